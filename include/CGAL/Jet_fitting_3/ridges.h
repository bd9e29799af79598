// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_RIDGES_H
#define CGAL_JET_FITTING_3_RIDGES_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/internal/Vertex_numbering.h>
#include <CGAL/estimate_vertex_monge_forms.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

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

/// \ingroup PkgJetFitting3Ridges
/// From a mesh to the property maps that CGAL::Ridge_approximation, CGAL::compute_max_ridges and its kin, and
/// CGAL::Umbilic_approximation take, the fit of the Monge forms included. Frames are direct and normals consistently
/// oriented, as those functions need it.
///
/// They have no way to leave a vertex out. So a vertex that was skipped has the values of the closest one (by edges)
/// that was not, and a mesh component without any has k = b = P = 0: is_estimated() tells. A b0 or b3 that is exactly 0 is
/// handed out as 1e-100: a triangle with two zeros sends CGAL::Ridge_approximation into undefined behaviour.
///
/// CGAL's ridge and umbilic classes keep references to the maps: keep this object alive as long as them. Copies share
/// the values.
///
/// \tparam Mesh a triangle mesh, model of FaceListGraph and HalfedgeListGraph
/// \tparam ConcurrencyTag as for estimate_vertex_monge_forms()
template <class Mesh, class ConcurrencyTag = Sequential_tag>
class Ridge_property_maps
{
  using Default_parameters = parameters::Default_named_parameters;
  using Ids = decltype(internal::vertex_ids(std::declval<const Mesh&>(), std::declval<const Default_parameters&>()));
  using Numbering = internal::Vertex_numbering<Mesh, Ids>;
  using Kernel = typename GetGeomTraits<Mesh, Default_parameters>::type;

public:
  /// @{
  /// A vertex of the mesh; numbers and vectors of the kernel of its points.
  using vertex_descriptor = typename boost::graph_traits<Mesh>::vertex_descriptor;
  using FT = typename Kernel::FT;
  using Vector_3 = typename Kernel::Vector_3;
  /// @}

  /// A readable property map from vertex to Value.
  template <class Value>
  class Map
  {
  public:
    /// @{
    /// The types of the map, and its value at a vertex.
    using key_type = vertex_descriptor;
    using value_type = Value;
    using reference = const Value&;
    using category = boost::readable_property_map_tag;

    friend const Value& get(const Map& map, vertex_descriptor v) { return (*map.m_values)[(*map.m_number)(v)]; }
    /// @}

    /// Itself: maps.k1() and maps.k1 are the same.
    const Map& operator()() const { return *this; }

  private:
    friend class Ridge_property_maps;
    Map(const std::shared_ptr<const Numbering>& number, const Value& value)
      : m_number(number), m_values(std::make_shared<std::vector<Value>>(number->size(), value))
    {}

    Value& operator[](std::size_t i) { return (*m_values)[i]; }

    std::shared_ptr<const Numbering> m_number;
    std::shared_ptr<std::vector<Value>> m_values;
  };

  /// @{
  /// A type of the maps.
  using Scalar_map = Map<FT>;
  using Vector_map = Map<Vector_3>;
  /// @}

  /// \param mesh read only here
  /// \param neighborhood as for estimate_vertex_monge_forms(); without it: enough_rings() for twice as many points as a
  ///        jet has coefficients
  /// \param np the named parameters of estimate_vertex_monge_forms(), except that the degree of the jet is 4 if not given,
  ///        and that of the form 3 (P1 and P2 are 0 then, and only ridges of order 3 can be computed) or 4 (default)
  /// \param options as for estimate_vertex_monge_forms()
  /// \throw Invalid_input if the degree of the form is less than 3
  template <class Neighborhood, class NamedParameters = Default_parameters>
  Ridge_property_maps(const Mesh& mesh, const Neighborhood& neighborhood,
                      const NamedParameters& np = parameters::default_values(), const Options& options = {})
    : Ridge_property_maps(std::make_shared<const Numbering>(mesh, internal::vertex_ids(mesh, Default_parameters())))
  {
    const std::size_t d = degree_fitting(np);
    const std::size_t dprime =
        std::size_t(parameters::choose_parameter(parameters::get_parameter(np, internal_np::degree_monge),
                                                 (std::min)(d, std::size_t(4))));
    if (dprime < 3)
      throw Invalid_input("ridges need Monge forms of degree 3 or more: got degree_monge = " + std::to_string(dprime));
    m_summary = estimate_vertex_monge_forms<ConcurrencyTag>(mesh, neighborhood, Form_map{this},
                                                            np.degree_fitting(d).degree_monge(dprime), options);
    fill_gaps(mesh);
  }

  /// From forms that are estimated already. Those of degree less than 3 count as skipped.
  /// \param mesh read only here
  /// \param form_map readable, from vertex to Monge_form, consistently oriented
  /// \param summary what estimate_vertex_monge_forms() returned with them
  template <class FormMap>
  Ridge_property_maps(const Mesh& mesh, const FormMap& form_map, const Estimation_summary<vertex_descriptor>& summary)
    : Ridge_property_maps(std::make_shared<const Numbering>(mesh, internal::vertex_ids(mesh, Default_parameters())))
  {
    m_summary = summary;
    for (vertex_descriptor v : make_range(vertices(mesh))) take(v, get(form_map, v));
    fill_gaps(mesh);
  }

  /// The same with the default neighborhood.
  template <class T, class Tag, class Base>
  Ridge_property_maps(const Mesh& mesh, const Named_function_parameters<T, Tag, Base>& np)
    : Ridge_property_maps(mesh, enough_rings(std::ptrdiff_t(2 * number_of_jet_coefficients(degree_fitting(np)))), np)
  {}

  /// The same with the default neighborhood and degrees 4.
  explicit Ridge_property_maps(const Mesh& mesh) : Ridge_property_maps(mesh, parameters::default_values()) {}

private:
  std::shared_ptr<const Numbering> m_number;
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

  /// Whether the values at a vertex are its own. Otherwise it was skipped, or estimated with a degree less than 3.
  bool is_estimated(vertex_descriptor v) const { return m_is_estimated[(*m_number)(v)]; }

  /// Which vertices were estimated, and why others were not.
  const Estimation_summary<vertex_descriptor>& summary() const { return m_summary; }

private:
  /// Takes the forms as they are estimated.
  struct Form_map
  {
    using key_type = vertex_descriptor;
    using value_type = Jet_fitting::Monge_form<Kernel>;
    using reference = void;
    using category = boost::writable_property_map_tag;

    Ridge_property_maps* maps;

    void take(vertex_descriptor v, const value_type& form) const { maps->take(v, form); }
    friend void put(const Form_map& map, vertex_descriptor v, const value_type& form) { map.take(v, form); }
  };

  explicit Ridge_property_maps(const std::shared_ptr<const Numbering>& number)
    : m_number(number), k1(number, FT(0)), k2(number, FT(0)), b0(number, FT(0)), b3(number, FT(0)), P1(number, FT(0)),
      P2(number, FT(0)), d1(number, Vector_3(1, 0, 0)), d2(number, Vector_3(0, 1, 0)), b1(number, FT(0)),
      b2(number, FT(0)), m_is_estimated(number->size(), false)
  {}

  template <class NamedParameters>
  static std::size_t degree_fitting(const NamedParameters& np)
  {
    return std::size_t(parameters::choose_parameter(parameters::get_parameter(np, internal_np::degree_fitting), 4));
  }

  static FT not_zero(const FT& b) { return b == FT(0) ? FT(1e-100) : b; }

  void take(vertex_descriptor v, const Jet_fitting::Monge_form<Kernel>& form)
  {
    if (form.degree() < 3) return;
    const std::size_t i = (*m_number)(v);
    m_is_estimated[i] = true;
    k1[i] = form.principal_curvatures(0);
    k2[i] = form.principal_curvatures(1);
    b0[i] = not_zero(form.third_order_coefficients(0));
    b1[i] = form.third_order_coefficients(1);
    b2[i] = form.third_order_coefficients(2);
    b3[i] = not_zero(form.third_order_coefficients(3));
    d1[i] = form.maximal_principal_direction();
    d2[i] = form.minimal_principal_direction();
    if (form.degree() < 4) return;
    P1[i] = ridge_P1(form);
    P2[i] = ridge_P2(form);
  }

  void copy(std::size_t from, std::size_t to)
  {
    for (Scalar_map* map : {&k1, &k2, &b0, &b1, &b2, &b3, &P1, &P2}) (*map)[to] = (*map)[from];
    for (Vector_map* map : {&d1, &d2}) (*map)[to] = (*map)[from];
  }

  void fill_gaps(const Mesh& mesh)
  {
    std::vector<bool> is_known = m_is_estimated;
    if (std::find(is_known.begin(), is_known.end(), false) == is_known.end()) return;
    std::vector<internal::Index> queue;
    for (internal::Index i = 0; i < is_known.size(); ++i)
      if (is_known[i]) queue.push_back(i);
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const auto h = halfedge((*m_number)[queue[next]], mesh);
      if (h == boost::graph_traits<Mesh>::null_halfedge()) continue;
      for (auto v : vertices_around_target(h, mesh)) {
        const internal::Index i = (*m_number)(v);
        if (is_known[i]) continue;
        copy(queue[next], i);
        is_known[i] = true;
        queue.push_back(i);
      }
    }
  }

  std::vector<bool> m_is_estimated;
};

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_RIDGES_H
