// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_NORMALS_AS_DATA_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_NORMALS_AS_DATA_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/fitting/Unit_surface.h>
#include <CGAL/Jet_fitting_3/internal/fitting/normals_of_faces.h>
#include <CGAL/Jet_fitting_3/internal/tables/Normal_table.h>
#include <CGAL/Jet_fitting_3/internal/tables/Unit_normals.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Normals of vertices that are to be data, or none, and those of the faces, to tell whether they follow from these.
struct Normals_as_data
{
  Unit_normals given;
  std::vector<Vector_3<double>> of_faces{}; ///< none where nothing is to be compared with them
  bool are_means_of_faces = false;
};

/// Those to compare with the faces. \param of_mesh normals of the nodes, by the faces
template <class Mesh, class Tables>
Normals_as_data normals_beside_faces(const Mesh& mesh, const Tables& tables, const Normal_table& of_mesh,
                                     Unit_normals given)
{
  const bool are_means = are_means_of_faces(mesh, *tables.numbering, tables.points, given);
  return {std::move(given), unit_vectors(of_mesh, tables.size()), are_means};
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_NORMALS_AS_DATA_H
