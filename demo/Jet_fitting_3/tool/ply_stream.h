// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_PLY_STREAM_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_PLY_STREAM_H

#include "Bytes.h"

#include <cstddef>
#include <fstream>
#include <istream>
#include <iterator>
#include <memory>
#include <sstream>
#include <string>

namespace tool {

// A PLY file as CGAL's readers need it: they take every machine for one that has the low byte first. Where it is not
// so, the names of the two byte orders are exchanged.
inline std::unique_ptr<std::istream> ply_stream(const std::string& file)
{
  auto in = std::make_unique<std::ifstream>(file, std::ios::binary);
  if (is_little_endian()) return in;
  std::string bytes{std::istreambuf_iterator<char>(*in), std::istreambuf_iterator<char>()};
  const std::string start = "format binary_", little = "little", big = "big";
  const std::size_t order = bytes.find(start) + start.size();
  if (order >= start.size() && order < bytes.find("end_header")) {
    const bool is_big = bytes.compare(order, big.size(), big) == 0;
    bytes.replace(order, is_big ? big.size() : little.size(), is_big ? little : big);
  }
  return std::make_unique<std::istringstream>(bytes);
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_PLY_STREAM_H
