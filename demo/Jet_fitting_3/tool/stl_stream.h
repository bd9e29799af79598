// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_STL_STREAM_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_STL_STREAM_H

#include "Bytes.h"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <istream>
#include <iterator>
#include <memory>
#include <sstream>
#include <string>

namespace tool {

// An STL file as CGAL's reader needs it: numbers of a binary one, which have the low byte first, are taken for those of
// this machine. Where it is not so, their bytes are turned round. A binary file is told from a text by its size: 84
// bytes, the last four of them the number of facets, and 50 for each, 12 numbers and two more bytes.
inline std::unique_ptr<std::istream> stl_stream(const std::string& file)
{
  auto in = std::make_unique<std::ifstream>(file, std::ios::binary);
  if (is_little_endian()) return in;
  std::string bytes{std::istreambuf_iterator<char>(*in), std::istreambuf_iterator<char>()};
  const std::size_t header = 80, start = 84, facet = 50, numbers = 12;
  std::size_t count = 0;
  for (std::size_t i = start; bytes.size() >= start && i-- > header;)
    count = 256 * count + static_cast<unsigned char>(bytes[i]);
  if (bytes.size() >= start && (bytes.size() - start) / facet == count && (bytes.size() - start) % facet == 0) {
    const auto turn = [&bytes](std::size_t at) { std::reverse(&bytes[at], &bytes[at] + 4); };
    turn(header);
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < numbers; ++j) turn(start + facet * i + 4 * j);
  }
  return std::make_unique<std::istringstream>(bytes);
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_STL_STREAM_H
