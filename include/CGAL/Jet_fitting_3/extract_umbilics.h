// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_EXTRACT_UMBILICS_H
#define CGAL_JET_FITTING_3_EXTRACT_UMBILICS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/internal/umbilic_in_triangle.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <ostream>
#include <string>
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
/// Extracts the umbilics of a triangle mesh, where lines of curvature and ridges of both colours meet.
///
/// An umbilic is a zero of the deviator of the second fundamental form, which has two components. Interpolated linearly
/// in each triangle, it has at most one zero there; its gradient gives the index, and the cubic form b0..b3 the type. On
/// a closed mesh without noise the indices add up to the Euler characteristic. Triangles with a vertex that was not
/// estimated, or where a quantity is not finite, are left out.
///
/// \tparam Mesh and Maps as for extract_ridges()
/// \param mesh of triangles
/// \param maps of all its vertices
/// \param merge_distance umbilics nearer to each other than that, in length, directly or by way of others, become one, the
///        mean of them, of the sum of their indices; none if the sum is 0. For noise, which makes pairs of umbilics, and
///        swarms of them where k1 = k2, as on a sphere
/// \param np the named parameter `vertex_point_map` (the mesh's own)
/// \throw Invalid_input if a face is not a triangle, or the distance is negative
///
/// The time is O(n + m log m) for n triangles and m umbilics, if few of them lie within the distance of each other.
template <class Mesh, class Maps, class NamedParameters = parameters::Default_named_parameters>
auto extract_umbilics(const Mesh& mesh, const Maps& maps, double merge_distance = 0,
                      const NamedParameters& np = parameters::default_values())
{
  using namespace internal;
  using Kernel = typename GetGeomTraits<Mesh, NamedParameters>::type;
  using Umbilic = Umbilic_in_triangle;
  if (!(merge_distance >= 0))
    throw Invalid_input("the distance for merging umbilics must not be negative: got " +
                        std::to_string(merge_distance));
  const auto points = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                   get_const_property_map(vertex_point, mesh));
  const Ridge_field field = read_ridge_field(mesh, maps, points, false);
  std::vector<Umbilic> found;
  for (const auto& triangle : field.triangles)
    if (const auto umbilic = umbilic_in_triangle(field, triangle)) found.push_back(*umbilic);

  std::vector<std::size_t> leader(found.size());
  std::iota(leader.begin(), leader.end(), std::size_t(0));
  const auto leader_of = [&leader](std::size_t i) {
    while (leader[i] != i) i = leader[i] = leader[leader[i]];
    return i;
  };
  if (merge_distance > 0) {
    std::stable_sort(found.begin(), found.end(),
                     [](const Umbilic& a, const Umbilic& b) { return a.point.x < b.point.x; });
    for (std::size_t i = 0; i < found.size(); ++i)
      for (std::size_t j = i + 1; j < found.size() && found[j].point.x - found[i].point.x < merge_distance; ++j)
        if (norm(found[j].point - found[i].point) < merge_distance) {
          const std::size_t a = leader_of(i), b = leader_of(j);
          leader[(std::max)(a, b)] = (std::min)(a, b);
        }
  }

  struct Group
  {
    Real_vector sum{0, 0, 0};
    double k = 0;
    int size = 0, turn = 0;
  };
  std::vector<Group> groups(found.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    Group& group = groups[leader_of(i)];
    group.sum = group.sum + found[i].point;
    group.k += found[i].k;
    group.size += 1;
    group.turn += found[i].turn;
  }
  std::vector<Umbilic_point<Kernel>> umbilics;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Group& group = groups[i];
    if (group.turn == 0) continue;
    const Real_vector mean = 1. / group.size * group.sum;
    const bool has_three_lines = number_of_straight_lines(found[i].form) == 3;
    const Umbilic_type type = group.turn == -1  ? Umbilic_type::star
                              : group.turn != 1 ? Umbilic_type::non_generic
                              : has_three_lines ? Umbilic_type::monstar
                                                : Umbilic_type::lemon;
    umbilics.push_back(
        {typename Kernel::Point_3(mean.x, mean.y, mean.z), group.k / group.size, 0.5 * group.turn, type});
  }
  return umbilics;
}

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_EXTRACT_UMBILICS_H
