// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_NORMALS_OF_OBJ_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_NORMALS_OF_OBJ_H

#include "Normals_of_corners.h"
#include "Numbers.h"
#include "Surface.h"
#include "text_of.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tool {

// An index of an OBJ file: from 1 on, or negative from the last one back. \return from 0 on
inline std::optional<std::size_t> obj_index(const char* begin, const char* end, std::size_t size)
{
  long long i = 0;
  std::from_chars(begin, end, i);
  const auto index = static_cast<std::size_t>(i > 0 ? i - 1 : static_cast<long long>(size) + i);
  return i != 0 && index < size ? std::optional<std::size_t>(index) : std::nullopt;
}

// The normals of the vertices of an OBJ file, of which CGAL's reader has none: each corner of a face, v//n or v/t/n,
// names the one it takes. Lines that are none of a vertex, a normal or a face are passed over.
// \return empty if the file has no normals
inline std::vector<Vector> normals_of_obj(const std::string& file, std::size_t number_of_vertices)
{
  const std::string text = text_of(file);
  if (text.find("vn ") == std::string::npos) return {};
  Numbers numbers(text);
  std::vector<Vector> normals;
  Normals_of_corners of_corners(number_of_vertices);
  for (std::size_t vertices = 0; numbers.skip_to_content(); numbers.skip_line()) {
    const std::string key = numbers.read_word();
    vertices += key == "v";
    double x, y, z;
    if (key == "vn")
      normals.push_back(numbers.read(x) && numbers.read(y) && numbers.read(z) ? Vector(x, y, z) : CGAL::NULL_VECTOR);
    while (key == "f" && !numbers.ends_line()) {
      const std::string corner = numbers.read_word();
      const char* const end = corner.data() + corner.size();
      const std::size_t last = corner.rfind('/');
      const auto vertex = obj_index(corner.data(), end, (std::min)(vertices, number_of_vertices));
      if (!vertex || last == corner.find('/')) continue; // v or v/t
      if (const auto normal = obj_index(corner.data() + last + 1, end, normals.size()))
        of_corners.add(*vertex, normals[*normal]);
    }
  }
  return of_corners.normals();
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_NORMALS_OF_OBJ_H
