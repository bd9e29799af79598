// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_MESH_ESTIMATION_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_MESH_ESTIMATION_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Options.h>
#include <CGAL/Jet_fitting_3/internal/fitting/Automatic_mesh_estimator.h>
#include <CGAL/Jet_fitting_3/internal/fitting/estimate_blocks.h>
#include <CGAL/Jet_fitting_3/internal/fitting/normals_as_data.h>
#include <CGAL/Jet_fitting_3/internal/fitting/normals_left_aside.h>
#include <CGAL/Jet_fitting_3/internal/fitting/parameters.h>
#include <CGAL/Jet_fitting_3/internal/fitting/read_point_weights.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Mesh_gatherer.h>
#include <CGAL/Jet_fitting_3/internal/gathering/User_gatherer.h>
#include <CGAL/Jet_fitting_3/internal/tables/Mesh_tables.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Automatic.h>

#include <type_traits>
#include <variant>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// What is prepared once to estimate forms at vertices of a mesh, all or some: tables, and an estimator. It refers to
/// the neighborhood, and must stay where it is.
template <class Mesh, class Neighborhood, class NamedParameters>
class Mesh_estimation
{
  static constexpr bool has_normals = has_given_normals<NamedParameters>;

public:
  using Tables = Mesh_tables<Mesh, NamedParameters>;
  using Kernel = typename Tables::Kernel;
  using Parameters = Estimation_parameters<Kernel, NamedParameters>;
  static constexpr bool is_automatic = std::is_same<Neighborhood, Automatic>::value;
  static constexpr bool is_users = Is_user_neighborhood<Neighborhood, typename Tables::Item>::value;
  using Estimator = std::conditional_t<is_automatic, std::variant<Automatic_mesh_estimator<Kernel>>,
                                       Row_estimators<Kernel, Parameters, has_normals>>;

  /// Looks at nothing.
  struct No_check
  {
    void operator()(const Tables&) const {}
  };

  /// \param for_places whether forms may be asked for at places that are no vertices, too
  /// \param check check(tables) may throw, before anything else that takes time
  template <class ConcurrencyTag, class Check = No_check>
  Mesh_estimation(ConcurrencyTag, const Mesh& mesh, const Neighborhood& neighborhood, const NamedParameters& np,
                  const Options& options, bool for_places = false, const Check& check = {})
    : m_neighborhood(neighborhood), m_given(np, is_automatic),
      m_tables(mesh_tables<ConcurrencyTag>(mesh, np, {!is_users, !is_users})),
      m_options(options_by_number(mesh, np, options)),
      m_normals(options.use_normals ? read_unit_normals(np, *m_tables.numbering) : Unit_normals()),
      m_estimator(make_estimator(ConcurrencyTag(), mesh, for_places, check))
  {
    if constexpr (is_automatic && !has_normals) m_tables.normals = std::get<0>(m_estimator).sides();
  }

  Mesh_estimation(const Mesh_estimation&) = delete;
  Mesh_estimation& operator=(const Mesh_estimation&) = delete;

  const Tables& tables() const { return m_tables; }
  const Progress& progress() const { return m_given.progress; }
  const Options& options() const { return m_options; }

  /// For one thread, as its copy of the estimator.
  auto gatherer() const
  {
    if constexpr (is_users) return User_gatherer<Tables, Neighborhood>(m_tables, m_neighborhood);
    else return mesh_gatherer(m_tables, m_neighborhood);
  }
  const Estimator& estimator() const { return m_estimator; }

  /// Estimates forms of vertices, or of other nodes of the adjacency; the rest as for estimate_blocks().
  template <class ConcurrencyTag, class Rows, class Write>
  Estimation_reports estimate(const Rows& rows, const Write& write, const Progress& progress) const
  {
    const auto make_gatherer = [this] { return gatherer(); };
    return std::visit(
        [&](const auto& estimator) {
          return estimate_blocks<ConcurrencyTag>(m_tables, estimator, make_gatherer, write, progress, rows);
        },
        m_estimator);
  }

private:
  Options options_by_number(const Mesh& mesh, const NamedParameters& np, const Options& options) const
  {
    Options result = options;
    result.point_weights =
        weights_by_number(*m_tables.numbering,
                          read_point_weights(np, make_range(vertices(mesh)), m_tables.size(), options.point_weights));
    return result;
  }

  template <class ConcurrencyTag, class Check>
  Estimator make_estimator(ConcurrencyTag tag, const Mesh& mesh, bool for_places, const Check& check) const
  {
    check(m_tables);
    if constexpr (is_automatic) {
      const Automatic_degrees degrees{m_given.dprime, m_given.highest_degree(averaging::highest_degree)};
      const Normal_table of_mesh = normals_of_mesh<ConcurrencyTag>(mesh, m_tables);
      const Normals_as_data normals = may_be_left_aside(m_normals, m_options)
                                          ? normals_beside_faces(mesh, m_tables, of_mesh, m_normals)
                                          : Normals_as_data{m_normals};
      return Automatic_mesh_estimator<Kernel>(tag, m_tables, of_mesh, normals, degrees, m_options, for_places);
    } else return row_estimator<has_normals>(m_tables.points, m_normals, m_given, m_options);
  }

  const Neighborhood& m_neighborhood;
  Parameters m_given;
  Tables m_tables;
  Options m_options; // with weights in the order of the tables
  Unit_normals m_normals;
  Estimator m_estimator;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_MESH_ESTIMATION_H
