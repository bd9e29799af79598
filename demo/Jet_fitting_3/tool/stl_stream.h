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
#include <filesystem>
#include <fstream>
#include <istream>
#include <iterator>
#include <memory>
#include <sstream>
#include <string>

namespace tool {

constexpr std::size_t stl_header = 84, stl_facet = 50; // bytes: 80 and the number of facets; 12 numbers and two bytes

// The number of facets of a binary STL file, whose first bytes these are; its numbers have the low byte first.
inline std::size_t number_of_stl_facets(const std::string& bytes)
{
  std::size_t count = 0;
  for (std::size_t i = stl_header; i-- > stl_header - 4;) count = 256 * count + static_cast<unsigned char>(bytes[i]);
  return count;
}

// Whether a binary STL file says to have more facets than it holds. Texts begin with "solid".
inline bool is_cut_short_stl(const std::string& file)
{
  std::string bytes(stl_header, ' ');
  std::ifstream in(file, std::ios::binary);
  if (!in.read(&bytes[0], stl_header)) return false;
  std::string word;
  std::istringstream(bytes) >> word;
  return word.compare(0, 5, "solid") != 0 &&
         number_of_stl_facets(bytes) > (std::filesystem::file_size(file) - stl_header) / stl_facet;
}

// An STL file as CGAL's reader needs it: numbers of a binary one are taken for those of this machine. Where the high
// byte comes first, their bytes are turned round. A binary file is told from a text by its size.
inline std::unique_ptr<std::istream> stl_stream(const std::string& file)
{
  auto in = std::make_unique<std::ifstream>(file, std::ios::binary);
  if (is_little_endian()) return in;
  std::string bytes{std::istreambuf_iterator<char>(*in), std::istreambuf_iterator<char>()};
  const std::size_t count = bytes.size() < stl_header ? 0 : number_of_stl_facets(bytes);
  if (count > 0 && bytes.size() == stl_header + stl_facet * count) {
    const auto turn = [&bytes](std::size_t at) { std::reverse(&bytes[at], &bytes[at] + 4); };
    turn(stl_header - 4);
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < 12; ++j) turn(stl_header + stl_facet * i + 4 * j);
  }
  return std::make_unique<std::istringstream>(bytes);
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_STL_STREAM_H
