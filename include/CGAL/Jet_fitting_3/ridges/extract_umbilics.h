// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_RIDGES_EXTRACT_UMBILICS_H
#define CGAL_JET_FITTING_3_RIDGES_EXTRACT_UMBILICS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/ridges/internal/Ridge_tolerance.h>
#include <CGAL/Jet_fitting_3/ridges/internal/merge_umbilics.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <vector>

namespace CGAL {
namespace Jet_fitting {

/// \ingroup PkgJetFitting3Ridges
/// The patterns that lines of curvature make around an umbilic (Berry and Hannay, Umbilic points on Gaussian random
/// surfaces): of index 1/2 with one straight line running out of it, or with three, of index -1/2 with three.
enum class Umbilic_type
{
  lemon,
  monstar,
  star,
  non_generic
};

/// \ingroup PkgJetFitting3Ridges
/// Writes the type in a word or two.
inline std::ostream& operator<<(std::ostream& out, Umbilic_type type)
{
  static const char* const names[] = {"lemon", "monstar", "star", "non generic"};
  return out << names[static_cast<std::size_t>(type)];
}

/// \ingroup PkgJetFitting3Ridges
/// A point where both principal curvatures are equal: a value.
template <class Kernel>
struct Umbilic_point
{
  typename Kernel::Point_3 point; ///< in a triangle
  double curvature;               ///< k1 = k2, in 1/length
  double index;                   ///< turns that d1 makes on the way around: 1/2 or -1/2, or a sum of such
  Umbilic_type type;              ///< non generic if the index is none of the two
};

/// \ingroup PkgJetFitting3Ridges
/// Which umbilics extract_umbilics() looks for.
struct Umbilic_options
{
  /// Umbilics nearer to each other than that, in length, directly or by way of others, become one, the mean of them, of
  /// the sum of their indices; none if the sum is 0. For noise, which makes pairs of umbilics.
  double merge_distance = 0;

  /// Whether only those count from which k1 - k2 rises more steeply than errors can make it, which are found as in
  /// Ridge_options. If false, there are umbilics at random where k1 = k2, as on spheres and planes.
  bool only_certain = true;

  double coordinate_rounding = 0; ///< as in Ridge_options
};

namespace internal {

/// Whether the deviator rises more steeply than by errors, at the corners of a triangle together.
inline bool rises_certainly(const Ridge_field& field, const Ridge_triangle& triangle,
                            const std::vector<Ridge_tolerance>& tolerances)
{
  double slope = 0, tolerance = 0;
  for (const Index v : triangle) {
    slope += deviator_slope({field[v].max.b, field[v].b1, field[v].b2, field[v].min.b});
    tolerance += tolerances[v].slope;
  }
  return slope > tolerance;
}

/// In the triangles whose corners are usable.
/// \param tolerances of all vertices, or none at all
inline std::vector<Umbilic_in_triangle> find_umbilics(const Ridge_field& field,
                                                      const std::vector<Ridge_tolerance>& tolerances)
{
  std::vector<Umbilic_in_triangle> found;
  for (const Ridge_triangle& triangle : field.triangles) {
    if (!std::all_of(triangle.begin(), triangle.end(), [&field](Index v) { return field.is_usable(v); })) continue;
    const auto umbilic = umbilic_in_triangle(field, triangle);
    if (umbilic && (tolerances.empty() || rises_certainly(field, triangle, tolerances))) found.push_back(*umbilic);
  }
  return found;
}

inline Umbilic_type umbilic_type(int turn, const Cubic_form& form)
{
  if (turn == -1) return Umbilic_type::star;
  if (turn != 1) return Umbilic_type::non_generic;
  return number_of_straight_lines(form) == 3 ? Umbilic_type::monstar : Umbilic_type::lemon;
}

} // namespace internal

/// \ingroup PkgJetFitting3Ridges
/// Extracts the umbilics of a triangle mesh, where lines of curvature and ridges of both colours meet.
///
/// An umbilic is a zero of the deviator of the second fundamental form, which has two components. Interpolated linearly
/// in each triangle, it has at most one zero there; its gradient gives the index, and the cubic form b0..b3 the type.
/// On a closed mesh without noise the indices add up to the Euler characteristic. Triangles with a vertex that was not
/// estimated, or where a quantity is not finite, are left out.
///
/// \tparam Mesh and Maps as for extract_ridges()
/// \param mesh of triangles
/// \param maps of all its vertices
/// \param np the named parameter `vertex_point_map` (the mesh's own)
/// \param options which umbilics
/// \throw Invalid_input if a face is not a triangle, or an option is negative
///
/// The time is O(n + m log m) for n triangles and m umbilics, if few of them lie within the distance of each other.
template <class Mesh, class Maps, class NamedParameters = parameters::Default_named_parameters>
auto extract_umbilics(const Mesh& mesh, const Maps& maps, const NamedParameters& np = parameters::default_values(),
                      const Umbilic_options& options = {})
{
  using namespace internal;
  using Kernel = typename GetGeomTraits<Mesh, NamedParameters>::type;
  for (const double length : {options.merge_distance, options.coordinate_rounding})
    if (!(length >= 0))
      throw Invalid_input("distance for merging and rounding in Umbilic_options must not be negative: got " +
                          number_text(length));
  const auto point_map = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                      get_const_property_map(vertex_point, mesh));
  const Ridge_field field = ridge_field(mesh, ridge_table(mesh, maps, point_map), point_map);
  std::vector<Ridge_tolerance> tolerances;
  if (options.only_certain)
    tolerances = ridge_tolerances(field, coordinate_rounding<typename Kernel::FT>(options.coordinate_rounding));
  std::vector<Umbilic_point<Kernel>> umbilics;
  for (const Umbilic_group& group : merge_umbilics(find_umbilics(field, tolerances), options.merge_distance)) {
    if (group.turn == 0) continue;
    const Real_vector& p = group.point;
    umbilics.push_back(
        {typename Kernel::Point_3(p.x, p.y, p.z), group.k, 0.5 * group.turn, umbilic_type(group.turn, group.form)});
  }
  return umbilics;
}

/// \ingroup PkgJetFitting3Ridges
/// The same with options and no named parameters.
template <class Mesh, class Maps>
auto extract_umbilics(const Mesh& mesh, const Maps& maps, const Umbilic_options& options)
{
  return extract_umbilics(mesh, maps, parameters::default_values(), options);
}

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_RIDGES_EXTRACT_UMBILICS_H
