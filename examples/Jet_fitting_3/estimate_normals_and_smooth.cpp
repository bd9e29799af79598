// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Normals of a point set, and the points moved onto their jets: smoothed.

#include <CGAL/IO/read_points.h>
#include <CGAL/IO/write_points.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/estimate_point_monge_forms.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point_with_normal = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using Point_map = CGAL::First_of_pair_property_map<Point_with_normal>;
using Normal_map = CGAL::Second_of_pair_property_map<Point_with_normal>;
using Monge_form = CGAL::Monge_via_jet_fitting<Kernel>::Monge_form;

// Every point moves to the origin of its form and gets the normal there; one that could not be estimated stays as it
// is, and so do all that were not reached when the callback cancelled. Normals that are there orient the new ones.
std::size_t smooth(std::vector<Point_with_normal>& points, std::ptrdiff_t k, bool has_normals,
                   const std::function<bool(double)>& callback)
{
  std::vector<Monge_form> forms;
  const auto parameters = CGAL::parameters::point_map(Point_map()).callback(callback);
  const auto neighborhood = CGAL::Jet_fitting::nearest(k); // or within_radius(r)
  if (has_normals)
    CGAL::estimate_point_monge_forms<CGAL::Parallel_if_available_tag>(points, neighborhood, std::back_inserter(forms),
                                                                      parameters.normal_map(Normal_map()));
  else
    CGAL::estimate_point_monge_forms<CGAL::Parallel_if_available_tag>(points, neighborhood, std::back_inserter(forms),
                                                                      parameters);
  std::size_t moved = 0;
  for (std::size_t i = 0; i < forms.size(); ++i) {
    if (forms[i].coefficients().empty()) continue;
    points[i] = {forms[i].origin(), forms[i].normal_direction()};
    ++moved;
  }
  return moved;
}

int main(int argc, char* argv[])
{
  const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("points_3/kitten.xyz");
  const int k = argc > 2 ? std::atoi(argv[2]) : 24;
  std::vector<Point_with_normal> points;
  if (!CGAL::IO::read_points(file, std::back_inserter(points),
                             CGAL::parameters::point_map(Point_map()).normal_map(Normal_map()))) {
    std::cerr << file << " cannot be read\n";
    return EXIT_FAILURE;
  }
  bool has_normals = true;
  for (const Point_with_normal& p : points) has_normals = has_normals && p.second != CGAL::NULL_VECTOR;

  const std::vector<Point_with_normal> before = points;
  const std::size_t moved = smooth(points, k, has_normals, [](double) { return true; });
  double sum = 0, agreeing = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    sum += CGAL::squared_distance(points[i].first, before[i].first);
    agreeing += points[i].second * before[i].second > 0;
  }
  std::cout << moved << " of " << points.size() << " points moved, by " << std::sqrt(sum / double(points.size()))
            << " (root of the mean square)\n";
  if (has_normals)
    std::cout << agreeing / double(points.size()) << " of the normals lie on the side of the given ones\n";
  else std::cout << "The sides of the normals differ from point to point: see CGAL::mst_orient_normals\n";
  if (argc > 3 &&
      !CGAL::IO::write_points(argv[3], points, CGAL::parameters::point_map(Point_map()).normal_map(Normal_map()))) {
    std::cerr << argv[3] << " cannot be written\n";
    return EXIT_FAILURE;
  }
}
