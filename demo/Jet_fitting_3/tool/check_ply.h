// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_CHECK_PLY_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_CHECK_PLY_H

#include "Input_error.h"
#include "extension.h"
#include "finite_number.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <istream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

// CGAL's reader of PLY files trusts them: what it takes for granted is checked before.
namespace tool {

struct Ply_property
{
  std::string name, type, count_type; // the latter of lists only
};

struct Ply_element
{
  std::string name;
  std::size_t count = 0;
  std::vector<Ply_property> properties;
};

inline std::size_t size_of_ply_type(const std::string& type)
{
  if (is_one_of(type, {"char", "uchar", "int8", "uint8"})) return 1;
  if (is_one_of(type, {"short", "ushort", "int16", "uint16"})) return 2;
  if (is_one_of(type, {"int", "uint", "int32", "uint32", "float", "float32"})) return 4;
  return is_one_of(type, {"double", "float64"}) ? 8 : 0;
}

// What follows the header: is it all there, and does no list claim to be longer than the rest of the file?
class Ply_body
{
public:
  Ply_body(std::istream& in, const std::string& format)
    : m_in(in), m_is_text(format == "ascii"), m_is_big_endian(format == "binary_big_endian")
  {}

  bool holds(const Ply_element& element)
  {
    std::size_t row = 0; // bytes, if all rows have as many
    for (const Ply_property& p : element.properties) row += p.count_type.empty() ? size_of_ply_type(p.type) : 0;
    const bool has_lists = std::any_of(element.properties.begin(), element.properties.end(),
                                       [](const Ply_property& p) { return !p.count_type.empty(); });
    if (!m_is_text && !has_lists) return skip(element.count, row);
    for (std::size_t i = 0; i < element.count; ++i)
      for (const Ply_property& p : element.properties) {
        std::size_t count = 1;
        if (!p.count_type.empty() && !read_count(p.count_type, count)) return false;
        if (!skip(count, size_of_ply_type(p.type))) return false;
      }
    return true;
  }

  // The word of a text that was refused as a number, if any was.
  const std::string& refused() const { return m_refused; }

private:
  // So many numbers of this size, or of any size in a text.
  bool skip(std::size_t count, std::size_t size)
  {
    if (!m_is_text) return m_in.ignore(std::streamsize(count * size)).gcount() == std::streamsize(count * size);
    for (std::size_t i = 0; i < count; ++i) {
      if (!(m_in >> m_word)) return false;
      if (is_finite_number(m_word)) continue;
      m_refused = m_word;
      return false;
    }
    return true;
  }

  bool read_count(const std::string& type, std::size_t& count)
  {
    if (m_is_text) {
      if (!(m_in >> m_word)) return false;
      count = std::strtoull(m_word.c_str(), nullptr, 10);
      return std::all_of(m_word.begin(), m_word.end(), [](char c) { return c >= '0' && c <= '9'; });
    }
    const std::size_t size = size_of_ply_type(type);
    std::array<char, 4> bytes;
    if (size > bytes.size() || !m_in.read(bytes.data(), std::streamsize(size))) return false;
    std::uint32_t value = 0;               // a negative one is large
    for (std::size_t i = 0; i < size; ++i) // from the highest byte on
      value = value << 8 | static_cast<unsigned char>(bytes[m_is_big_endian ? i : size - 1 - i]);
    count = value;
    return true;
  }

  std::istream& m_in;
  bool m_is_text, m_is_big_endian;
  std::string m_word, m_refused;
};

// Properties belong to an element, the coordinates of a vertex, and those of its normal, are of one floating type,
// names are unique, and there is as much of each element as the header says. \return the header \throw Input_error
inline std::vector<Ply_element> check_ply(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  std::string format;
  std::vector<Ply_element> elements;
  std::string element, point_type, normal_type;
  std::set<std::string> names;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string keyword, type, name;
    words >> keyword;
    if (keyword == "format") words >> format;
    if (keyword == "end_header") break;
    double count = 0;
    if (keyword == "element" && words >> element >> count) {
      names.clear();
      if (count < 0) throw Input_error(file, "not a PLY file: a negative number of elements '" + element + "'");
      if (count > double(std::filesystem::file_size(file)))
        throw Input_error(file, "cut short: more elements '" + element + "' than bytes");
      elements.push_back({element, static_cast<std::size_t>(count), {}});
    }
    if (keyword.compare(0, 8, "property") != 0) continue;
    if (elements.empty()) throw Input_error(file, "not a PLY file: a property without an element");
    words >> type >> name;
    Ply_property property;
    if (type == "list") {
      property.count_type = name;
      words >> type >> name;
    }
    property.name = name;
    property.type = type;
    elements.back().properties.push_back(property);
    if (!names.insert(name).second)
      throw Input_error(file, "two properties '" + name + "' of element '" + element + "'");
    const bool is_point = is_one_of(name, {"x", "y", "z"}), is_normal = is_one_of(name, {"nx", "ny", "nz"});
    if (element == "face" || !(is_point || is_normal)) continue;
    const std::string size = is_one_of(type, {"float", "float32"})    ? "float"
                             : is_one_of(type, {"double", "float64"}) ? "double"
                                                                      : "";
    std::string& first_size = is_point ? point_type : normal_type;
    if (first_size.empty()) first_size = size;
    if (size.empty() || size != first_size)
      throw Input_error(file, "property " + name + " of type " + type +
                                  ": the coordinates of points, and of normals, must all be float or all double");
  }
  Ply_body body(in, format);
  for (const Ply_element& e : elements)
    if (!body.holds(e))
      throw Input_error(file, body.refused().empty()
                                  ? "cut short or malformed: not as many elements '" + e.name + "' as it says"
                                  : "an element '" + e.name + "': " + no_finite_number(body.refused()));
  return elements;
}

// Of faces, CGAL's reader takes no other lists of corners. \throw Input_error
inline void check_corners(const std::string& file, const std::vector<Ply_element>& elements)
{
  const auto are_corners = [](const Ply_property& p) {
    return is_one_of(p.name, {"vertex_indices", "vertex_index"}) && !p.count_type.empty() &&
           is_one_of(p.type, {"int", "int32", "uint", "uint32"});
  };
  for (const Ply_element& e : elements)
    if (is_one_of(e.name, {"face", "faces"}) && std::none_of(e.properties.begin(), e.properties.end(), are_corners))
      throw Input_error(file, "the corners of its faces are not a list 'vertex_indices' or 'vertex_index' of int or "
                              "uint, and others are not read");
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_CHECK_PLY_H
