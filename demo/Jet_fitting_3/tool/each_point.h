// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_EACH_POINT_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_EACH_POINT_H

#include "Context.h"
#include "Input_error.h"
#include "check_ply.h"
#include "extension.h"
#include "read_input.h"

#include <CGAL/IO/read_points.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <functional>
#include <iterator>
#include <string>

namespace tool {

// Calls a function for each point that is assigned.
class Point_visitor
{
public:
  using iterator_category = std::output_iterator_tag;
  using value_type = Oriented_point;
  using difference_type = std::ptrdiff_t;
  using pointer = void;
  using reference = void;

  explicit Point_visitor(const std::function<void(const Oriented_point&)>& visit) : m_visit(&visit) {}

  Point_visitor& operator*() { return *this; }
  Point_visitor& operator++() { return *this; }
  Point_visitor operator++(int) { return *this; }
  void operator=(const Oriented_point& p) { (*m_visit)(p); }

private:
  const std::function<void(const Oriented_point&)>* m_visit;
};

// Visits the points of a file, one by one: no more than one is in memory. \throw Input_error
inline void each_point(const std::string& file, const std::function<void(const Oriented_point&)>& visit)
try {
  check_readable(file);
  const std::string format = extension(file);
  if (!is_one_of(format, {"xyz", "pwn", "ply", "las"}))
    throw Input_error(file, "points are read one by one from xyz, pwn, ply and las files");
  if (format == "ply") check_ply(file);
  else if (format != "las") check_lines_of_points(file);
#ifndef CGAL_LINKED_WITH_LASLIB
  else throw Input_error(file, "LAS files cannot be read: this program was compiled without LASlib");
#endif
  const Silence silence;
  const auto parameters = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented_point>())
                              .normal_map(CGAL::Second_of_pair_property_map<Oriented_point>());
  if (!CGAL::IO::read_points<Oriented_point>(file, Point_visitor(visit), parameters))
    throw Input_error(file, "not a complete file of points: it is cut short or malformed");
} catch (const CGAL::Failure_exception&) {
  throw Input_error(file, "malformed: an assertion of CGAL's reader does not hold");
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_EACH_POINT_H
