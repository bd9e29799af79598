// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_READ_OFF_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_READ_OFF_H

#include "Input_error.h"
#include "Numbers.h"
#include "Surface.h"
#include "extension.h"
#include "text_of.h"
#include "why_not_a_mesh.h"

#include <cctype>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

namespace tool {

// What the keyword of an OFF file says: [ST][C][N][4][n]OFF. What ST, C and N announce follows the coordinates.
struct Off_keyword
{
  bool is_known = false;
  bool has_normals = false;    // N: they follow the coordinates
  bool is_homogeneous = false; // 4: a fourth coordinate, by which the others are divided
  bool has_dimension = false;  // n: the number of coordinates comes next

  explicit Off_keyword(std::string word)
  {
    const auto take = [&word](const std::string& prefix) {
      const bool is_there = word.compare(0, prefix.size(), prefix) == 0;
      if (is_there) word.erase(0, prefix.size());
      return is_there;
    };
    take("ST");
    bool announces_normals = take("N");
    take("C");
    announces_normals = announces_normals || take("N");
    const bool has_4 = take("4"), has_n = take("n");
    is_known = word == "OFF";
    has_normals = is_known && announces_normals;
    is_homogeneous = is_known && has_4;
    has_dimension = is_known && has_n;
  }
};

// What follows the keyword. \throw Input_error if the file is binary, or its points have not three coordinates
inline void check_kind(const std::string& file, Numbers& numbers, bool has_dimension)
{
  Numbers ahead = numbers;
  if (!ahead.ends_line() && ahead.read_word() == "BINARY")
    throw Input_error(file, "binary off files are not read: save it as text, or as ply");
  std::size_t dimension = 3;
  if (has_dimension && (!numbers.skip_to_content() || !numbers.read(dimension) || dimension != 3))
    throw Input_error(file, "an nOFF file whose points have not three coordinates");
}

// No face has more corners than `most`. \return whether all are there
template <bool Lines>
bool read_faces(Numbers& numbers, std::size_t count, std::size_t most, std::vector<Corners>& faces)
{
  const auto read = [&](auto& number) { return (Lines || numbers.skip_to_content()) && numbers.read(number); };
  faces.reserve(count);
  for (std::size_t f = 0; f < count; ++f) {
    std::size_t size = 0;
    if ((Lines && !numbers.skip_to_content()) || !read(size) || size > most) return false;
    for (std::size_t& corner : faces.emplace_back(size))
      if (!read(corner)) return false;
    if (Lines) numbers.skip_line();
  }
  return true;
}

// The points and faces of an OFF file. Lines is true: each has a line of its own, on which normals, which are read, and
// texture coordinates and colors may follow; false: numbers follow one another, however they are spread over lines. No
// memory is taken for counts that a text of this size cannot hold. \return whether it is such a text
// \throw Input_error if it is of another kind
template <bool Lines>
bool parse_off(const std::string& file, Numbers& numbers, std::size_t size, std::vector<Point>& points,
               std::vector<Corners>& faces, std::vector<Vector>& normals)
{
  points.clear();
  faces.clear();
  normals.clear();
  const auto begin = [&numbers] { return numbers.skip_to_content(); };
  const auto read = [&](auto& number) { return (Lines || numbers.skip_to_content()) && numbers.read(number); };
  if (!begin()) return false;
  const Numbers start = numbers;
  const std::string first_word = numbers.read_word();
  const Off_keyword keyword(first_word);
  if (!keyword.is_known && !std::isdigit(static_cast<unsigned char>(first_word.front()))) return false;
  if (!keyword.is_known) numbers = start; // the keyword may be missing
  else check_kind(file, numbers, keyword.has_dimension);
  std::size_t number_of_points = 0, number_of_faces = 0, number_of_edges = 0; // the last one nobody needs
  if (!begin() || !numbers.read(number_of_points) || !numbers.read(number_of_faces)) return false;
  if (Lines) numbers.skip_line();
  else if (!numbers.read(number_of_edges)) return false;
  if (number_of_points > size || number_of_faces > size) return false;
  points.reserve(number_of_points);
  for (std::size_t i = 0; i < number_of_points; ++i) {
    double x, y, z, w = 1;
    if ((Lines && !begin()) || !read(x) || !read(y) || !read(z) || (keyword.is_homogeneous && !read(w)) ||
        !std::isfinite(x / w + y / w + z / w))
      return false;
    points.emplace_back(x / w, y / w, z / w);
    if (!Lines) continue;
    double nx, ny, nz;
    if (keyword.has_normals)
      normals.push_back(read(nx) && read(ny) && read(nz) ? Vector(nx, ny, nz) : CGAL::NULL_VECTOR);
    numbers.skip_line();
  }
  return read_faces<Lines>(numbers, number_of_faces, size, faces);
}

// Reads OFF files of text, several times as fast as CGAL's reader, which takes the sizes of faces on trust.
// \return whether it is complete \throw Input_error if it is of a kind that is not read, or has what is no number
inline bool read_off(const std::string& file, std::vector<Point>& points, std::vector<Corners>& faces,
                     std::vector<Vector>& normals)
{
  const std::string text = text_of(file);
  Numbers by_lines(text), in_a_row(text);
  if (parse_off<true>(file, by_lines, text.size(), points, faces, normals) ||
      parse_off<false>(file, in_a_row, text.size(), points, faces, normals))
    return true;
  const std::string refused = by_lines.refused();
  if (!refused.empty()) throw Input_error(file, refused);
  return false;
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_READ_OFF_H
