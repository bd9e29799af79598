// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_RIDGES_EXTRACT_RIDGES_H
#define CGAL_JET_FITTING_3_RIDGES_EXTRACT_RIDGES_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/ridges/Ridge_line.h>
#include <CGAL/Jet_fitting_3/ridges/internal/Ridge_significance.h>
#include <CGAL/Jet_fitting_3/ridges/internal/enclosing_radius.h>
#include <CGAL/Jet_fitting_3/ridges/internal/measure_ridges.h>
#include <CGAL/Jet_fitting_3/ridges/internal/ridge_chains.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {

/// \ingroup PkgJetFitting3Ridges
/// Which ridges: both colours with their elliptic and hyperbolic parts, one of them, or the crests of both.
enum class Ridge_selection
{
  max_and_min,
  max,
  min,
  crest
};

/// \ingroup PkgJetFitting3Ridges
/// What extract_ridges() looks for, and which lines it keeps.
struct Ridge_options
{
  Ridge_selection lines = Ridge_selection::max_and_min; ///< which of them

  /// 4: elliptic or hyperbolic by the sign of P1 or P2, from Monge forms of degree 4 or more; 3: by the slope of b0 or
  /// b3 over the triangle, for forms of degree 3.
  int order = 4;

  /// If positive: a zero crossing of b0 or b3 counts only if on both sides of it, on the way along the line of
  /// curvature to the next zero, b exceeds so many of its standard errors. 2 removes nearly all that noise draws; lower
  /// values keep more of faint ridges. The maps must hold standard errors.
  double significance = 0;

  /// Whether lines are drawn only where a change of the sign of b0 or b3 is certain, or within a few triangles of
  /// there: on both sides of it, k1 or k2 rises (or falls), and b exceeds what errors can make of zero. These are read
  /// off the data: b0, ..., b3 are the derivatives of the second fundamental form, and b has to exceed twice the
  /// largest difference, on the edges around, between them and the difference quotients of that form; or, where shapes
  /// are as small as neighborhoods, b has to be so large that the curvature changes by one and a half times as much as
  /// it is, over the reach of the neighborhood or while the normal turns by a radian. With a significance, what may be
  /// noise by the standard errors is left to that. If false, lines are drawn at random where b vanishes identically, as
  /// on spheres, cylinders, tori.
  /// With automatic(), where there is noise, lines are drawn along which b exceeds a fifth of the error that it reports
  /// around there, bias included, if somewhere they are certain in the above way, or b exceeds four times that error
  /// and a quarter of the other bounds.
  bool only_certain = true;

  /// How far rounding may have moved the points, in length, besides that of their number type: for coordinates read
  /// from text with six digits, 5e-7 times the largest. A part of what b has to exceed.
  double coordinate_rounding = 0;

  double least_length = 0;    ///< lines shorter than that are dropped; in length
  double least_strength = 0;  ///< of smaller Ridge_line::strength, too
  double least_sharpness = 0; ///< of smaller Ridge_line::sharpness, too

  /// In which the sharpness is measured; 0: the radius of the smallest sphere around the mesh.
  double model_size = 0;
};

/// \ingroup PkgJetFitting3Ridges
/// The result of extract_ridges(): values, nothing refers to the mesh or the maps.
template <class Kernel>
struct Ridges
{
  std::vector<Ridge_line<Kernel>> lines; ///< those that the options let pass

  Ridge_triangles left_out; ///< triangles that could not be looked at

  double model_size = 0; ///< with which the sharpness was computed

  /// Of all lines together.
  double length() const
  {
    double sum = 0;
    for (const Ridge_line<Kernel>& line : lines) sum += line.length;
    return sum;
  }
};

namespace internal {

inline void check_ridge_options(const Ridge_options& options)
{
  if (options.order != 3 && options.order != 4)
    throw Invalid_input("the order of ridges is 3 or 4: got " + std::to_string(options.order));
  const double numbers[] = {options.significance,   options.coordinate_rounding, options.least_length,
                            options.least_strength, options.least_sharpness,     options.model_size};
  for (const double number : numbers)
    if (!(number >= 0))
      throw Invalid_input("significance, rounding, thresholds and size in Ridge_options must not be negative: got " +
                          number_text(number));
}

inline void check_ridge_field(const Ridge_field& field, const Ridge_options& options)
{
  const auto any = [&field](const auto& holds) {
    return std::any_of(field.values->begin(), field.values->end(),
                       [&holds](const Ridge_values& v) { return holds(v.max) || holds(v.min); });
  };
  if (field.triangles.empty()) return;
  if (options.order == 4 && !any([](const Ridge_quantities& q) { return q.P != 0; }) &&
      any([](const Ridge_quantities& q) { return q.b != 0; }))
    throw Invalid_input("ridges of order 4 need P1 and P2, which are all zero: ask for order 3, or for Monge forms of "
                        "degree 4");
  if (options.significance > 0 && !any([](const Ridge_quantities& q) { return q.error.has_value(); }))
    throw Invalid_input("the significance of ridges needs standard errors: build the Ridge_property_maps with "
                        "Options::standard_errors");
}

/// Whether the errors of b contain bias, as those of automatic() do.
inline bool have_total_errors(const Ridge_field& field)
{
  return std::any_of(field.values->begin(), field.values->end(),
                     [](const Ridge_values& v) { return v.errors_contain_bias; });
}

inline bool have_same_type(const Ridge_segment& a, const Ridge_segment& b) { return a.is_elliptic == b.is_elliptic; }

/// Which segments are more than errors at both ends.
template <class Exceeds_errors>
std::vector<bool> exceed_errors(const Ridge_field& field, const Ridge_view& view,
                                const std::vector<Ridge_segment>& segments, const Exceeds_errors& exceeds_errors)
{
  const Ridge_significance<Exceeds_errors> is_significant(field, view, exceeds_errors);
  std::vector<bool> result;
  result.reserve(segments.size());
  for (const Ridge_segment& s : segments) result.push_back(is_significant(s.ends[0]) && is_significant(s.ends[1]));
  return result;
}

/// Of all vertices, errors of b that contain bias. That of a single vertex may be by far too small, so they are those
/// around it in the root of the mean square, at least.
inline std::vector<double> errors_around(const Ridge_field& field, const Ridge_view& view)
{
  const auto square = [&view](Index v) {
    const double error = view[v].error.value_or(0);
    return error * error;
  };
  std::vector<double> sums(field.points.size()), counts(field.points.size()), result(field.points.size());
  for (const Ridge_triangle& triangle : field.triangles)
    for (const Index v : triangle)
      for (const Index w : triangle) {
        sums[v] += square(w);
        ++counts[v];
      }
  for (Index v = 0; v < result.size(); ++v)
    if (counts[v] > 0) result[v] = std::sqrt((std::max)(square(v), sums[v] / counts[v]));
  return result;
}

/// Of the lines along which b exceeds a fifth of the errors that contain bias, those that are certain somewhere
/// (hysteresis, as for the edges of an image): because b exceeds what errors can make of zero, or these errors many
/// times. With little noise these may be too small on spheres, so it has to exceed a part of the other, which noise
/// enlarges, too.
inline std::vector<Ridge_segment> certain_lines(const Ridge_field& field, const Ridge_view& view,
                                                const std::vector<Ridge_segment>& segments)
{
  const std::vector<double> errors = errors_around(field, view);
  const auto exceeds_a_part = [&](Index v) { return std::abs(view.b(v)) > 0.2 * errors[v]; };
  const auto is_certain = [&](Index v) {
    const double b = std::abs(view.b(v));
    return b > view.tolerance(v) || (b > 4 * errors[v] && b > 0.25 * view.tolerance(v));
  };
  const auto always = [](const Ridge_segment&, const Ridge_segment&) { return true; };
  const std::vector<Ridge_segment> weak =
      segments_near_certain_ones(segments, exceed_errors(field, view, segments, exceeds_a_part), 0, always);
  return segments_near_certain_ones(weak, exceed_errors(field, view, weak, is_certain), weak.size(), always);
}

/// The segments of one colour that the options let pass.
inline std::vector<Ridge_segment> selected_segments(const Ridge_field& field, const Ridge_view& view,
                                                    const Ridge_options& options, Ridge_triangles& left_out)
{
  const std::size_t steps = 16; // about twice the reach of a neighborhood
  std::vector<Ridge_segment> segments = ridge_segments(field, view, options.order, left_out);
  if (options.lines == Ridge_selection::crest)
    segments.erase(std::remove_if(segments.begin(), segments.end(), [](const Ridge_segment& s) { return !s.is_crest; }),
                   segments.end());
  const auto noise = [&](Index v) { return options.significance * view[v].error.value_or(0); };
  // A tolerance is twice a disagreement. Noise makes that up to about twice the noise of b at significance 2: the
  // largest of six differences of two errors exceeds 3.7 standard errors once in twenty times. Then the other test
  // decides.
  const auto exceeds_tolerance = [&](Index v) {
    return std::abs(view.b(v)) > view.tolerance(v) || view.tolerance(v) <= 4 * noise(v);
  };
  const auto exceeds_noise = [&](Index v) { return std::abs(view.b(v)) >= noise(v); };
  if (options.only_certain && have_total_errors(field)) segments = certain_lines(field, view, segments);
  else if (options.only_certain) // before the other test makes gaps
    segments = segments_near_certain_ones(segments, exceed_errors(field, view, segments, exceeds_tolerance), steps,
                                          have_same_type);
  if (options.significance > 0)
    segments =
        segments_near_certain_ones(segments, exceed_errors(field, view, segments, exceeds_noise), 0, have_same_type);
  return segments;
}

} // namespace internal

/// \ingroup PkgJetFitting3Ridges
/// Extracts the ridges of a triangle mesh (Cazals and Pouget, Topology driven algorithms for ridge extraction on
/// meshes): in each triangle whose principal directions can be oriented alike, b0 (or b3) taken along them changes its
/// sign on two edges or on none; the crossings are interpolated linearly and joined across the edges to lines of one
/// type.
///
/// The lines are those of CGAL::Ridge_approximation, where that is defined, but not computed by it: it takes zero and
/// not finite values to undefined behaviour, has no room for a test of significance at each crossing, and its sharpness
/// divides by |k1| - |k2|. Here an exact zero counts as positive, along the direction at its vertex, which makes the
/// crossings of every triangle even; so a line passes through a vertex or along a mesh edge of zeros without a gap.
///
/// \tparam Mesh a triangle mesh, model of FaceListGraph and HalfedgeListGraph
/// \tparam Maps Ridge_property_maps<Mesh>, or anything with readable property maps k1, k2, b0, b3, P1, P2 (numbers) and
///         d1, d2 (vectors) as members. Frames must be direct and the normals consistently oriented
/// \param mesh of triangles
/// \param maps of all its vertices
/// \param np the named parameter `vertex_point_map` (the mesh's own)
/// \param options which ridges
/// \throw Invalid_input if a face is not a triangle, if order 4 is asked for and all P are zero, if a significance is
///        asked for and there are no standard errors, or an option is out of its range
///
/// The time is O(n + r log r) for n triangles and r ridge segments, besides the walks along lines of curvature that the
/// significance takes.
template <class Mesh, class Maps, class NamedParameters = parameters::Default_named_parameters>
auto extract_ridges(const Mesh& mesh, const Maps& maps, const NamedParameters& np = parameters::default_values(),
                    const Ridge_options& options = {})
{
  using namespace internal;
  using Kernel = typename GetGeomTraits<Mesh, NamedParameters>::type;
  check_ridge_options(options);
  const auto point_map = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                      get_const_property_map(vertex_point, mesh));
  const Ridge_field field = ridge_field(mesh, ridge_table(mesh, maps, point_map), point_map);
  check_ridge_field(field, options);
  std::vector<Ridge_tolerance> tolerances;
  if (options.only_certain)
    tolerances = ridge_tolerances(field, coordinate_rounding<typename Kernel::FT>(options.coordinate_rounding));

  Ridges<Kernel> ridges;
  ridges.model_size = options.model_size > 0 ? options.model_size : enclosing_radius(field.points);
  for (const Ridge_colour colour : {Ridge_colour::max, Ridge_colour::min}) {
    if (options.lines == (colour == Ridge_colour::max ? Ridge_selection::min : Ridge_selection::max)) continue;
    const Ridge_view view(field, tolerances, colour);
    const std::vector<Ridge_segment> segments = selected_segments(field, view, options, ridges.left_out);
    for (const Ridge_chain& chain : ridge_chains(segments, have_same_type)) {
      Ridge_line<Kernel> line = ridge_line<Kernel>(view, segments, chain, options.lines == Ridge_selection::crest);
      line.sharpness *= ridges.model_size * ridges.model_size;
      if (line.length >= options.least_length && line.strength >= options.least_strength &&
          line.sharpness >= options.least_sharpness)
        ridges.lines.push_back(std::move(line));
    }
  }
  return ridges;
}

/// \ingroup PkgJetFitting3Ridges
/// The same with options and no named parameters.
template <class Mesh, class Maps>
auto extract_ridges(const Mesh& mesh, const Maps& maps, const Ridge_options& options)
{
  return extract_ridges(mesh, maps, parameters::default_values(), options);
}

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_RIDGES_EXTRACT_RIDGES_H
