// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_NOISY_SURFACE_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_NOISY_SURFACE_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/Options.h>
#include <CGAL/Jet_fitting_3/averaging/noise_of_normals.h>
#include <CGAL/Jet_fitting_3/averaging/noise_of_surface.h>
#include <CGAL/Jet_fitting_3/averaging/sound_normals.h>
#include <CGAL/Jet_fitting_3/averaging/whereabouts.h>
#include <CGAL/Jet_fitting_3/internal/fitting/Unit_surface.h>
#include <CGAL/Jet_fitting_3/internal/fitting/normals_as_data.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/values/Noise.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Of the points: the given one, or that of the mesh. In the unit of the tables.
/// \throw Invalid_input if it is not given and cannot be told
template <class Points>
averaging::Surface_noise noise_of_positions(const Unit_surface& surface, const Points& points, const Options& options)
{
  averaging::Surface_noise noise;
  if (options.position_noise) noise.of_all.position = *options.position_noise * points.per_length();
  else noise = averaging::noise_of_surface(surface.surface());
  if (!std::isfinite(noise.of_all.position))
    throw Invalid_input("the noise of this mesh of " + std::to_string(points.size()) +
                        " vertices is unknown: too few of them have enough others within three rings that do not "
                        "coincide or lie on a line (separate triangles have to be stitched first). automatic() takes "
                        "Options::position_noise for it");
  return noise;
}

/// What automatic() fits, and estimate_noise() tells the noise of: points of a mesh, their noise, their tangent planes,
/// and given normals as far as these are sound. In the unit of the tables, which must outlive it.
class Noisy_surface
{
public:
  /// \param of_mesh normals of the nodes, by the faces
  /// \param options noise that is given, and whether outliers are kept
  /// \param for_each as for Surface_choice
  /// \throw Invalid_input if noise is not given and cannot be told
  template <class Tables, class For_each>
  Noisy_surface(const Tables& tables, const Normal_table& of_mesh, const Normals_as_data& normals,
                const Options& options, const For_each& for_each)
    : m_surface(tables, of_mesh, !normals.given.empty(), options, for_each),
      m_noise(noise_of_positions(m_surface, tables.points, options))
  {
    const Unit_surface::Surface& s = surface();
    for (std::size_t i = 0; i < s.points.size(); ++i)
      m_squares_of_noise.push_back(
          averaging::variance_in_units(m_noise.at(averaging::whereabouts_anywhere(s, i)), s.units[i]));
    take_tangent_planes(for_each);
    if (!normals.given.empty()) take_normals(tables, normals, options, for_each);
  }

  const Unit_surface::Surface& surface() const { return m_surface.surface(); }
  /// Whether normals are data: not if there are none, or they seem to follow from the faces.
  bool has_normals() const { return surface().given; }
  /// Of each vertex, in squares of its unit.
  const std::vector<double>& squares_of_noise() const { return m_squares_of_noise; }
  /// In the middle.
  const Noise& noise() const { return m_noise.of_all; }
  Normal_table sides() const { return m_surface.sides(); }
  bool is_outlier(std::size_t node) const { return m_surface.is_outlier(node); }

private:
  template <class For_each>
  void take_tangent_planes(const For_each& for_each)
  {
    const Noise& noise = m_noise.of_all;
    m_surface.take_tangent_planes(m_squares_of_noise, is_told_from_shape(noise.position, noise.position_error),
                                  for_each);
  }

  // As data, unless they seem to follow from the faces.
  template <class Tables, class For_each>
  void take_normals(const Tables& tables, const Normals_as_data& normals, const Options& options,
                    const For_each& for_each)
  {
    std::vector<Vector_3<double>> given = averaging::on_side_of(surface(), normals_of_nodes(tables, normals.given));
    Noise& noise = m_noise.of_all;
    if (!normals.of_faces.empty() &&
        averaging::follow_from_faces(surface(), given, normals_of_nodes(tables, normals.of_faces)))
      return;
    const std::size_t of_no_side = m_surface.forget_normals_of_no_side(given);
    averaging::Sound_normals sound = averaging::sound_normals(surface(), std::move(given), for_each);
    noise.wrong_normals = of_no_side + sound.wrong;
    const averaging::Size_of_noise estimated = averaging::noise_of_normals(surface(), sound.normals);
    noise.normal = options.normal_noise.value_or(estimated.value);
    noise.normal_error = options.normal_noise ? 0 : estimated.error;
    if (!std::isfinite(noise.normal))
      throw Invalid_input("the noise of the normals of this mesh of " + std::to_string(tables.points.size()) +
                          " vertices is unknown: too few of them are known within two rings. automatic() takes "
                          "Options::position_noise and normal_noise for both");
    // Points whose noise cannot be told from what fits leave without any: with slopes these leave less
    constexpr double height_over_slope = 0.25;
    if (noise.position <= noise.position_error) {
      const double beside = averaging::noise_beside_normals(surface(), sound.normals);
      const double most = averaging::variance_in_units((std::max)(beside, height_over_slope * noise.normal), 1);
      for (double& square : m_squares_of_noise) square = (std::min)(square, most);
      take_tangent_planes(for_each); // which may be finer now
    }
    m_surface.take_normals(std::move(sound.normals), noise.normal, m_squares_of_noise);
  }

  Unit_surface m_surface;
  averaging::Surface_noise m_noise;
  std::vector<double> m_squares_of_noise;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_NOISY_SURFACE_H
