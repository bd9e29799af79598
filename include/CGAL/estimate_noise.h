// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ESTIMATE_NOISE_H
#define CGAL_ESTIMATE_NOISE_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Options.h>
#include <CGAL/Jet_fitting_3/internal/fitting/Noisy_surface.h>
#include <CGAL/Jet_fitting_3/internal/fitting/Unit_cloud.h>
#include <CGAL/Jet_fitting_3/internal/fitting/Unit_surface.h>
#include <CGAL/Jet_fitting_3/internal/fitting/normals_as_data.h>
#include <CGAL/Jet_fitting_3/internal/fitting/normals_left_aside.h>
#include <CGAL/Jet_fitting_3/internal/machine/parallel.h>
#include <CGAL/Jet_fitting_3/internal/tables/Mesh_tables.h>
#include <CGAL/Jet_fitting_3/internal/tables/Normal_table.h>
#include <CGAL/Jet_fitting_3/internal/tables/Point_set_tables.h>
#include <CGAL/Jet_fitting_3/internal/tables/Sample_tables.h>
#include <CGAL/Jet_fitting_3/scale/estimate_noise.h>
#include <CGAL/Jet_fitting_3/values/Noise.h>

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <iterator>
#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

template <class T, class = void>
struct Is_range : std::false_type
{};

template <class T>
struct Is_range<T, std::void_t<decltype(std::begin(std::declval<const T&>()))>> : std::true_type
{};

/// In lengths.
template <class ConcurrencyTag, class PointRange, class NamedParameters>
Noise noise_of_points(const PointRange& points, const NamedParameters& np)
{
  using Kernel = Kernel_of_range<PointRange, NamedParameters>;
  Point_set_tables<Kernel> read = point_set_tables(ConcurrencyTag(), points, np);
  const std::optional<Unit_normals> given = unit_normals_if_any(points, np, read.size());
  const Sample_tables<Kernel> tables(ConcurrencyTag(), std::move(read.points), read.normals);
  const Unit_normals normals = given.value_or(Unit_normals()).reordered(tables.samples.tree().numbers());
  Unit_cloud<Kernel> samples(tables, normals);
  const For_each_sample<ConcurrencyTag> for_each;
  if (samples.cloud().has_normals() || shows_outliers(samples.cloud(), samples.search(), for_each))
    samples.leave_out_outliers(for_each);
  Noise noise = in_larger_unit(scale::estimate_noise(samples.cloud(), samples.search()).noise, samples.per_length());
  noise.wrong_normals = samples.wrong_normals();
  return noise;
}

template <class ConcurrencyTag, class FaceGraph, class NamedParameters>
Noise noise_of_vertices(const FaceGraph& mesh, const NamedParameters& np)
{
  const auto tables = mesh_tables<ConcurrencyTag>(mesh, np, {true, true});
  const Normal_table of_mesh = normals_of_mesh<ConcurrencyTag>(mesh, tables);
  const auto in_lengths = [&](const Noise& noise) { return in_larger_unit(noise, tables.points.per_length()); };
  const For_each_with_body<ConcurrencyTag> for_each;
  const auto of_positions = [&] {
    const Unit_surface surface(tables, of_mesh, false, Options(), for_each);
    return in_lengths(noise_of_positions(surface, tables.points, Options()).of_all);
  };
  if constexpr (has_given_normals<NamedParameters>) {
    const Normals_as_data normals =
        normals_beside_faces(mesh, tables, of_mesh, read_unit_normals(np, *tables.numbering));
    if (normals.are_means_of_faces) return without_normals(of_positions());
    const Noisy_surface surface(tables, of_mesh, normals, Options(), for_each);
    return surface.has_normals() ? in_lengths(surface.noise()) : without_normals(of_positions());
  } else return of_positions();
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting

CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Choice
/// Estimates the noise of a point set or mesh, and of its normals if there are any, from what jets of high degree leave
/// in small neighborhoods at about 200 places. It is what automatic() goes by, and costs little beside it. Outliers are
/// left out (see automatic()), those of a point set without normals if some show at 50 places. At sharp edges of a mesh
/// neighborhoods end as those of automatic(); on a point set they do not: where most balls of 45 points hold an edge,
/// it counts as noise.
///
/// \tparam ConcurrencyTag Sequential_tag, Parallel_tag (needs TBB) or Parallel_if_available_tag. The results are the
///         same, bit by bit, for every tag and number of threads.
/// \param points_or_mesh a range of points, or of anything with a point map, as for estimate_point_monge_forms(), or a
///        mesh, as for estimate_vertex_monge_forms()
/// \param np `point_map`, `normal_map` and `geom_traits`, or `vertex_point_map`, `vertex_index_map`,
///        `vertex_normal_map`, `edge_is_constrained_map` and `geom_traits`, as for these functions. Given normals may
///        have any length; those that are zero or not finite are left out
/// \return standard deviations, in the unit of the coordinates and in radians, with errors; those in the middle where
///         they differ over the surface. Where the surface is not smooth on the scale of a few edges, or of 45 points,
///         what cannot be told from noise counts as noise, and the error says so. Of a mesh, noise that is alike over
///         four edges and more counts as surface, of points one that is alike over ten of their distances. Normals
///         that are wrong are left out and counted; those of a mesh that follow from its faces have infinite noise
/// \throw Jet_fitting::Invalid_input if there are too few points, too many of them coincide, or too few have normals
template <class ConcurrencyTag = Sequential_tag, class PointsOrMesh,
          class NamedParameters = parameters::Default_named_parameters>
Jet_fitting::Noise estimate_noise(const PointsOrMesh& points_or_mesh,
                                  const NamedParameters& np = parameters::default_values())
{
  if constexpr (Jet_fitting::internal::Is_range<PointsOrMesh>::value)
    return Jet_fitting::internal::noise_of_points<ConcurrencyTag>(points_or_mesh, np);
  else return Jet_fitting::internal::noise_of_vertices<ConcurrencyTag>(points_or_mesh, np);
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace CGAL

#endif // CGAL_ESTIMATE_NOISE_H
