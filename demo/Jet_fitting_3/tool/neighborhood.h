// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_NEIGHBORHOOD_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_NEIGHBORHOOD_H

#include "Arguments.h"

#include <CGAL/estimate_point_monge_forms.h>
#include <CGAL/estimate_vertex_monge_forms.h>

#include <cstddef>
#include <sstream>
#include <string>
#include <variant>

// From which points the fits are made: what the user asks for, and what is done if nothing is asked for: automatic()
// where it serves, or the last case of mesh_neighborhood() and point_neighborhood().
namespace tool {

// Any of the neighborhoods, chosen at run time.
template <class... Neighborhoods>
struct Chosen_neighborhood
{
  std::variant<Neighborhoods...> choice;

  template <class Gatherer, class Index, class Output>
  void operator()(Gatherer& gatherer, Index seed, Output& output) const
  {
    std::visit([&](const auto& neighborhood) { neighborhood(gatherer, seed, output); }, choice);
  }
};

inline std::ptrdiff_t least_points(const Arguments& a)
{
  return static_cast<std::ptrdiff_t>(CGAL::Jet_fitting::number_of_jet_coefficients(a.degree_jet));
}

using Mesh_neighborhood = Chosen_neighborhood<CGAL::Jet_fitting::K_rings, CGAL::Jet_fitting::Enough_rings,
                                              CGAL::Jet_fitting::Nearest, CGAL::Jet_fitting::Within_radius>;

inline Mesh_neighborhood mesh_neighborhood(const Arguments& a)
{
  using namespace CGAL::Jet_fitting;
  if (a.points) return {nearest(*a.points)};
  if (a.radius) return {within_radius(*a.radius)};
  if (a.rings && *a.rings > 0) return {k_rings(*a.rings)};
  return {enough_rings(a.rings ? least_points(a) : 2 * least_points(a))};
}

// Scans are noisy: five times the points that the fit needs.
inline std::ptrdiff_t points_of_scans(const Arguments& a) { return 5 * least_points(a); }

using Point_neighborhood = Chosen_neighborhood<CGAL::Jet_fitting::Nearest, CGAL::Jet_fitting::Within_radius>;

inline Point_neighborhood point_neighborhood(const Arguments& a)
{
  using namespace CGAL::Jet_fitting;
  if (a.points) return {nearest(*a.points)};
  if (a.radius) return {within_radius(*a.radius)};
  return {nearest(points_of_scans(a))};
}

// Why automatic() does not choose radius and degree although they are left open; empty if it does.
inline std::string why_not_automatic(const Arguments& a, std::size_t size)
{
  using namespace CGAL::Jet_fitting;
  if (a.of_points && a.degree_monge > 2) return "the order of the Monge form is above 2";
  if (a.degree_monge < 2) return "no curvatures are estimated";
  if (a.options.loss != Loss::least_squares && a.options.loss != Loss::tukey) return "--robust is set";
  if (a.options.weights_by_distance()) return "--weights is set";
  if (a.options.standard_errors) return "--errors is set";
  const std::size_t most = a.of_points ? most_points_for_automatic : most_vertices_for_automatic;
  return size > most && !a.chooses_at_any_size
             ? "there are more than " + std::to_string(most) + " of them (--automatic chooses nevertheless)"
             : "";
}

// From which points the fits are made.
inline std::string neighborhood_in_words(const Arguments& a)
{
  if (a.points) return "the " + std::to_string(*a.points) + " nearest points";
  if (a.radius) {
    std::ostringstream text;
    text << "the points within " << *a.radius;
    return text.str();
  }
  if (a.of_points) return "the " + std::to_string(points_of_scans(a)) + " nearest points";
  if (a.rings && *a.rings > 0) return std::to_string(*a.rings) + (*a.rings == 1 ? " ring" : " rings");
  return "rings up to " + std::to_string(a.rings ? least_points(a) : 2 * least_points(a)) + " points";
}

// What is fitted to what.
inline std::string fits_in_words(const Arguments& a)
{
  if (!a.is_automatic) return "jets of degree " + std::to_string(a.degree_jet) + " from " + neighborhood_in_words(a);
  return std::string("jets of radius and degree chosen for each ") + (a.of_points ? "point" : "vertex") +
         (a.options.use_normals ? ", from points and normals" : "");
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_NEIGHBORHOOD_H
