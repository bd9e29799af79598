// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXAMPLES_JET_FITTING_3_TOOL_READ_PLAIN_OFF_H
#define CGAL_EXAMPLES_JET_FITTING_3_TOOL_READ_PLAIN_OFF_H

#include "Surface.h"
#include "why_not_a_mesh.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

namespace tool {

// The lines of a text, without those that are blank or comments, and the numbers in them.
class Numbers_by_line
{
public:
  explicit Numbers_by_line(const std::string& text) : m_at(text.data()), m_end(text.data() + text.size()) {}

  // At the start of the next line that holds anything. The one before has to be read to its end.
  bool start_line()
  {
    for (; m_at != m_end; ++m_at) {
      if (*m_at == '#') m_at = std::find(m_at, m_end, '\n');
      if (m_at == m_end) return false;
      if (!is_blank(*m_at) && *m_at != '\n') return true;
    }
    return false;
  }

  bool ends_line()
  {
    skip_blanks();
    return m_at == m_end || *m_at == '\n';
  }

  bool read_word(const std::string& word)
  {
    if (std::size_t(m_end - m_at) < word.size() || !std::equal(word.begin(), word.end(), m_at)) return false;
    m_at += word.size();
    return true;
  }

  template <class Number>
  bool read(Number& number)
  {
    skip_blanks();
    const auto [after, error] = std::from_chars(m_at, m_end, number);
    m_at = after;
    return error == std::errc() && (m_at == m_end || is_blank(*m_at) || *m_at == '\n');
  }

private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
  void skip_blanks()
  {
    while (m_at != m_end && is_blank(*m_at)) ++m_at;
  }

  const char *m_at, *m_end;
};

// Reads the plain kind of OFF files, points of three coordinates and faces, a line each, several times as fast as CGAL's
// reader. \return false for any other file, malformed ones too, which are left to CGAL
inline bool read_plain_off(const std::string& file, std::vector<Point>& points, std::vector<Corners>& faces)
{
#ifndef __cpp_lib_to_chars
  return false; // from_chars knows integers only
#else
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  std::string text(static_cast<std::size_t>(in.tellg()), ' ');
  in.seekg(0);
  if (!in.read(&text[0], static_cast<std::streamsize>(text.size()))) return false;

  Numbers_by_line numbers(text);
  std::size_t number_of_points = 0, number_of_faces = 0, number_of_edges = 0;
  if (!numbers.start_line() || !numbers.read_word("OFF") || !numbers.ends_line() || !numbers.start_line() ||
      !numbers.read(number_of_points) || !numbers.read(number_of_faces) || !numbers.read(number_of_edges) ||
      !numbers.ends_line() || number_of_points > text.size() || number_of_faces > text.size())
    return false;
  points.reserve(number_of_points);
  for (std::size_t i = 0; i < number_of_points; ++i) {
    double x, y, z;
    if (!numbers.start_line() || !numbers.read(x) || !numbers.read(y) || !numbers.read(z) || !numbers.ends_line() ||
        !std::isfinite(x + y + z))
      return false;
    points.emplace_back(x, y, z);
  }
  faces.reserve(number_of_faces);
  for (std::size_t f = 0; f < number_of_faces; ++f) {
    std::size_t size = 0;
    if (!numbers.start_line() || !numbers.read(size) || size > text.size()) return false;
    Corners& corners = faces.emplace_back(size);
    for (std::size_t& corner : corners)
      if (!numbers.read(corner)) return false;
    if (!numbers.ends_line()) return false;
  }
  return true;
#endif
}

} // namespace tool

#endif // CGAL_EXAMPLES_JET_FITTING_3_TOOL_READ_PLAIN_OFF_H
