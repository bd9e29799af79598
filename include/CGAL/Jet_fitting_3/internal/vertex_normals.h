// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_VERTEX_NORMALS_H
#define CGAL_JET_FITTING_3_INTERNAL_VERTEX_NORMALS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/Normal_table.h>
#include <CGAL/Jet_fitting_3/internal/Point_table.h>
#include <CGAL/Jet_fitting_3/internal/numbered_mesh.h>
#include <CGAL/Jet_fitting_3/internal/parallel.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

/// The normal of a vertex is the sum of the vector areas of the faces around it: on the side from which they are seen
/// counterclockwise. Faces with a corner that is not finite do not count.
template <class ConcurrencyTag, class Mesh, class Numbering, class Kernel>
Normal_table vertex_normals(const Mesh& mesh, const Numbering& number, const Point_table<Kernel>& points)
{
  std::vector<Vector_3<float>> sums(number.size(), Vector_3<float>{0, 0, 0});
  for_each_face(mesh, number, [&](auto begin, auto end) {
    Vector_3<double> area{0, 0, 0};
    Vector_3<double> last = points.offset_in_units(begin[0], begin[1]);
    for (auto corner = begin + 2; corner != end; ++corner) {
      const Vector_3<double> next = points.offset_in_units(begin[0], *corner);
      area = area + cross(last, next);
      last = next;
    }
    if (!std::isfinite(area.x + area.y + area.z)) return;
    const Vector_3<float> rough{float(area.x), float(area.y), float(area.z)};
    for (auto corner = begin; corner != end; ++corner) sums[*corner] = sums[*corner] + rough;
  });

  Normal_table normals(sums.size());
  for_each_number<ConcurrencyTag>(sums.size(), [&](std::size_t i) { normals.set(static_cast<Index>(i), sums[i]); });
  return normals;
}

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_VERTEX_NORMALS_H
