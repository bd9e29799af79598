// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_RIDGES_RIDGE_PROPERTY_MAPS_H
#define CGAL_JET_FITTING_3_RIDGES_RIDGE_PROPERTY_MAPS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/Monge_form.h>
#include <CGAL/Jet_fitting_3/internal/fitting/estimate_vertices.h>
#include <CGAL/Jet_fitting_3/internal/fitting/parameters.h>
#include <CGAL/Jet_fitting_3/ridges/internal/Ridge_table.h>
#include <CGAL/Jet_fitting_3/values/Monge_coefficients.h>
#include <CGAL/estimate_vertex_monge_forms.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Jet_fitting {

/// \ingroup PkgJetFitting3Ridges
/// Sign of the second derivative of k1 along its line of curvature, where b0 = 0: d2k1/ds2 = P1 / (k1 - k2).
/// Negative on a maximum, a ridge. Of a form of degree 4 or more.
template <class DataKernel>
typename DataKernel::FT ridge_P1(const Monge_form<DataKernel>& form)
{
  using FT = typename DataKernel::FT;
  const FT k1 = form.principal_curvatures(0), k2 = form.principal_curvatures(1), b1 = form.third_order_coefficients(1);
  return FT(3) * b1 * b1 + (k1 - k2) * (form.fourth_order_coefficients(0) - FT(3) * k1 * k1 * k1);
}

/// \ingroup PkgJetFitting3Ridges
/// The same of k2 along its line of curvature, where b3 = 0: d2k2/ds2 = P2 / (k2 - k1).
template <class DataKernel>
typename DataKernel::FT ridge_P2(const Monge_form<DataKernel>& form)
{
  using FT = typename DataKernel::FT;
  const FT k1 = form.principal_curvatures(0), k2 = form.principal_curvatures(1), b2 = form.third_order_coefficients(2);
  return FT(3) * b2 * b2 + (k2 - k1) * (form.fourth_order_coefficients(4) - FT(3) * k2 * k2 * k2);
}

namespace internal {

/// The values of a form; those of an empty form if its degree is less than 3.
template <class Kernel>
Ridge_values ridge_values(const Monge_form<Kernel>& form)
{
  Ridge_values values;
  if (form.degree() < 3) return values;
  const auto k = [&form](std::size_t i) { return CGAL::to_double(form.principal_curvatures(i)); };
  const auto b = [&form](std::size_t i) { return CGAL::to_double(form.third_order_coefficients(i)); };
  const bool has_P = form.degree() >= 4;
  values.max = {
      k(0), b(0), has_P ? CGAL::to_double(ridge_P1(form)) : 0, to_real(form.maximal_principal_direction()), {}};
  values.min = {
      k(1), b(3), has_P ? CGAL::to_double(ridge_P2(form)) : 0, to_real(form.minimal_principal_direction()), {}};
  values.b1 = b(1);
  values.b2 = b(2);
  values.is_estimated = true;
  return values;
}

/// What a summary tells of the values at a vertex.
inline void set_report(Ridge_values& values, const Estimation_status& status, const Fit_quality& quality,
                       const Noise& noise)
{
  values.is_estimated = values.is_estimated && status.is_estimated() && !status.has(Status_flag::degree_lowered);
  if (quality.number_of_points > 0 && quality.condition_number > 0)
    values.fit = Ridge_fit{quality.number_of_points, quality.condition_number};
  const auto& chosen = quality.scale.third_order_errors;
  if (chosen[0] > 0 && chosen[1] > 0) {
    values.max.error = chosen[0];
    values.min.error = chosen[1];
    // elsewhere the errors are too small where a few millionths of an edge are taken for noise, as on spheres
    values.errors_contain_bias = is_told_from_shape(noise.position, noise.position_error);
  }
  const auto& errors = quality.standard_errors.coefficients;
  if (errors.size() < monge_offset(4)) return;
  values.max.error = errors[monge_offset(3)];
  values.min.error = errors[monge_offset(3) + 3];
}

} // namespace internal

/// \ingroup PkgJetFitting3Ridges
/// From a mesh to the property maps that CGAL::Ridge_approximation, CGAL::compute_max_ridges and its kin, and
/// CGAL::Umbilic_approximation take, the fit of the Monge forms included. Frames are direct and normals consistently
/// oriented, as those functions need it.
///
/// They have no way to leave a vertex out. So a vertex that was skipped has the values of the closest one (by edges)
/// that was not, and a mesh component without any has k = b = P = 0: is_estimated() tells. A b0 or b3 that is exactly 0
/// is handed out as 1e-100: a triangle with two zeros sends CGAL::Ridge_approximation into undefined behaviour.
///
/// The maps are views on one table, which copies share. CGAL's ridge and umbilic classes keep references to the maps:
/// keep this object alive as long as them.
///
/// \tparam Mesh a triangle mesh, model of FaceListGraph and HalfedgeListGraph
/// \tparam ConcurrencyTag as for estimate_vertex_monge_forms()
template <class Mesh, class ConcurrencyTag = Sequential_tag>
class Ridge_property_maps
{
  using Default_parameters = parameters::Default_named_parameters;
  using Table = internal::Ridge_table<Mesh>;
  using Values = internal::Ridge_values;
  using Kernel = typename GetGeomTraits<Mesh, Default_parameters>::type;

public:
  /// @{
  /// A vertex of the mesh; numbers and vectors of the kernel of its points.
  using vertex_descriptor = typename boost::graph_traits<Mesh>::vertex_descriptor;
  using FT = typename Kernel::FT;
  using Vector_3 = typename Kernel::Vector_3;
  /// @}

  /// A readable property map from vertex to Value, which is returned by value.
  template <class Value>
  class Map
  {
  public:
    /// @{
    /// The types of the map, and its value at a vertex.
    using key_type = vertex_descriptor;
    using value_type = Value;
    using reference = Value;
    using category = boost::readable_property_map_tag;

    friend Value get(const Map& map, vertex_descriptor v)
    {
      return map.m_read(map.m_table->values[map.m_table->number(v)]);
    }
    /// @}

    /// Itself: maps.k1() and maps.k1 are the same.
    const Map& operator()() const { return *this; }

  private:
    friend class Ridge_property_maps;
    using Read = Value (*)(const Values&);
    Map(const std::shared_ptr<const Table>& table, Read read) : m_table(table), m_read(read) {}

    std::shared_ptr<const Table> m_table;
    Read m_read;
  };

  /// @{
  /// A type of the maps.
  using Scalar_map = Map<FT>;
  using Vector_map = Map<Vector_3>;
  /// @}

  /// \param mesh read only here
  /// \param neighborhood as for estimate_vertex_monge_forms(); without it: enough_rings() for twice as many points as a
  ///        jet has coefficients. With automatic(), what is significant is decided by the errors of b that it
  ///        estimates
  /// \param np the named parameters of estimate_vertex_monge_forms(), except that the degree of the jet is 4 if not
  ///        given (any with automatic()), and that of the form 3 (P1 and P2 are 0 then, and only ridges of order 3 can
  ///        be computed) or 4 (default). The object keeps a copy of a given `vertex_index_map`
  /// \param options as for estimate_vertex_monge_forms()
  /// \throw Invalid_input if the degree of the form is less than 3, or that of the jet impossible
  template <class Neighborhood, class NamedParameters = Default_parameters>
  Ridge_property_maps(const Mesh& mesh, const Neighborhood& neighborhood,
                      const NamedParameters& np = parameters::default_values(), const Options& options = {})
    : Ridge_property_maps(estimated(mesh, neighborhood, np, options))
  {}

  /// The same with options and no named parameters.
  template <class Neighborhood>
  Ridge_property_maps(const Mesh& mesh, const Neighborhood& neighborhood, const Options& options)
    : Ridge_property_maps(mesh, neighborhood, parameters::default_values(), options)
  {}

  /// From forms that are estimated already. Those of degree less than 3 count as skipped.
  /// \param mesh read only here
  /// \param form_map readable, from vertex to Monge_form, consistently oriented
  /// \param summary what estimate_vertex_monge_forms() returned with them
  template <class FormMap>
  Ridge_property_maps(const Mesh& mesh, const FormMap& form_map, const Estimation_summary<vertex_descriptor>& summary)
    : Ridge_property_maps(given(mesh, form_map, summary))
  {}

  /// The same with the default neighborhood.
  template <class T, class Tag, class Base>
  Ridge_property_maps(const Mesh& mesh, const Named_function_parameters<T, Tag, Base>& np, const Options& options = {})
    : Ridge_property_maps(mesh, default_neighborhood(degree_fitting(np)), np, options)
  {}

  /// The same with the default neighborhood and degrees 4.
  explicit Ridge_property_maps(const Mesh& mesh, const Options& options = {})
    : Ridge_property_maps(mesh, parameters::default_values(), options)
  {}

private:
  std::shared_ptr<const Table> m_table;
  Estimation_summary<vertex_descriptor> m_summary;

public:
  /// @{
  /// What CGAL's functions ask for: principal curvatures, their derivatives along their own lines, the signs of their
  /// second derivatives (see ridge_P1(), ridge_P2()), and the principal directions, of unit length.
  Scalar_map k1, k2, b0, b3, P1, P2;
  Vector_map d1, d2;
  /// @}

  /// @{
  /// The other two third order coefficients, for the cubic form at umbilics.
  Scalar_map b1, b2;
  /// @}

  /// Whether the values at a vertex are its own. Otherwise it was skipped, or estimated with a degree lower than the
  /// one that was asked for, or less than 3: no ridge is extracted from the triangles around it.
  bool is_estimated(vertex_descriptor v) const { return m_table->values[m_table->number(v)].is_estimated; }

  /// Which vertices were estimated, and why others were not.
  const Estimation_summary<vertex_descriptor>& summary() const { return m_summary; }

  /// The values behind the maps: for extract_ridges() and extract_umbilics().
  std::shared_ptr<const Table> table() const { return m_table; }

private:
  struct Contents
  {
    std::shared_ptr<Table> table;
    Estimation_summary<vertex_descriptor> summary;
  };

  template <class Neighborhood, class NamedParameters>
  static Contents estimated(const Mesh& mesh, const Neighborhood& neighborhood, const NamedParameters& np,
                            const Options& options)
  {
    const std::size_t d = degree_fitting(np);
    const std::size_t dprime = internal::degree_parameter(
        "degree_monge", parameters::choose_parameter(parameters::get_parameter(np, internal_np::degree_monge),
                                                     (std::min)(d, std::size_t(4))));
    if (dprime < 3)
      throw Invalid_input("ridges need Monge forms of degree 3 or more: got degree_monge = " + std::to_string(dprime));
    Options with_quality = options; // for bounds of the errors of b
    with_quality.report_quality = true;
    Contents made;
    const auto to_table = [&made](const auto& tables, const auto&) {
      made.table = std::make_shared<Table>(tables.numbering);
      return [&numbering = *tables.numbering, &values = made.table->values](const auto& block, const auto& report) {
        for (std::size_t i = 0; i < block.results.size(); ++i)
          values[numbering.position(internal::Index(block.first + i))] =
              internal::ridge_values<Kernel>(block.results[i].form);
        report(block);
      };
    };
    const auto estimate = [&](const auto& with_degrees) {
      return internal::estimate_vertices<ConcurrencyTag>(mesh, neighborhood, to_table, with_degrees, with_quality);
    };
    // automatic() chooses the degree, unless the user bounds it
    if constexpr (std::is_same<Neighborhood, Automatic>::value) made.summary = estimate(np.degree_monge(dprime));
    else made.summary = estimate(np.degree_fitting(d).degree_monge(dprime));
    complete(mesh, made);
    return made;
  }

  template <class FormMap>
  static Contents given(const Mesh& mesh, const FormMap& form_map, const Estimation_summary<vertex_descriptor>& summary)
  {
    Contents made{std::make_shared<Table>(mesh), summary};
    for (const vertex_descriptor& v : make_range(vertices(mesh)))
      made.table->values[made.table->number(v)] = internal::ridge_values<Kernel>(get(form_map, v));
    complete(mesh, made);
    return made;
  }

  /// Adds what the summary tells of the values, and values where there are none.
  static void complete(const Mesh& mesh, const Contents& made)
  {
    for (const vertex_descriptor& v : make_range(vertices(mesh)))
      internal::set_report(made.table->values[made.table->number(v)], made.summary.status(v), made.summary.quality(v),
                           made.summary.noise);
    internal::fill_gaps(mesh, *made.table);
  }

  explicit Ridge_property_maps(const Contents& made) : Ridge_property_maps(made.table, made.summary) {}

  Ridge_property_maps(const std::shared_ptr<const Table>& table, const Estimation_summary<vertex_descriptor>& summary)
    : m_table(table), m_summary(summary), k1(table, [](const Values& v) { return FT(v.max.k); }),
      k2(table, [](const Values& v) { return FT(v.min.k); }),
      b0(table, [](const Values& v) { return not_zero(v.max.b); }),
      b3(table, [](const Values& v) { return not_zero(v.min.b); }),
      P1(table, [](const Values& v) { return FT(v.max.P); }), P2(table, [](const Values& v) { return FT(v.min.P); }),
      d1(table, [](const Values& v) { return vector(v.max.direction); }),
      d2(table, [](const Values& v) { return vector(v.min.direction); }),
      b1(table, [](const Values& v) { return FT(v.b1); }), b2(table, [](const Values& v) { return FT(v.b2); })
  {}

  template <class NamedParameters>
  static std::size_t degree_fitting(const NamedParameters& np)
  {
    return internal::degree_parameter(
        "degree_fitting", parameters::choose_parameter(parameters::get_parameter(np, internal_np::degree_fitting), 4));
  }

  /// \throw Invalid_input unless there is such a degree
  static auto default_neighborhood(std::size_t d)
  {
    check_degrees(d, 1);
    return enough_rings(std::ptrdiff_t(2 * number_of_jet_coefficients(d)));
  }

  static FT not_zero(double b) { return FT(b == 0 ? 1e-100 : b); }
  static Vector_3 vector(const internal::Real_vector& v) { return Vector_3(FT(v.x), FT(v.y), FT(v.z)); }
};

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_RIDGES_RIDGE_PROPERTY_MAPS_H
