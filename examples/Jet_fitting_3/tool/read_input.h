// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXAMPLES_JET_FITTING_3_TOOL_READ_INPUT_H
#define CGAL_EXAMPLES_JET_FITTING_3_TOOL_READ_INPUT_H

#include "Surface.h"
#include "extension.h"
#include "read_plain_off.h"
#include "why_not_a_mesh.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/exceptions.h>
#ifdef CGAL_USE_VTK
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#endif

#include <filesystem>
#include <fstream>
#include <iostream>
#include <new>
#include <set>
#include <sstream>
#include <stdexcept>
#include <streambuf>
#include <string>
#include <vector>

namespace tool {

// What is wrong with the input, in one sentence.
class Input_error : public std::runtime_error
{
public:
  Input_error(const std::string& file, const std::string& what) : std::runtime_error(file + ": " + what) {}
};

inline void check_readable(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file))
    throw Input_error(file, "there is no such file, or it may not be read");
  if (in.get() == std::ifstream::traits_type::eof()) throw Input_error(file, "the file is empty");
}

// CGAL's reader of PLY files takes it for granted that properties belong to an element, that the coordinates of a vertex,
// and those of its normal, are of one floating type, that names are unique, and that there are as many elements as the
// header says, which it counts without a sign.
inline void check_ply_header(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  std::string element, point_type, normal_type;
  std::set<std::string> names;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string keyword, type, name;
    words >> keyword;
    if (keyword == "end_header") return;
    double count = 0;
    if (keyword == "element" && words >> element >> count) {
      names.clear();
      if (count < 0) throw Input_error(file, "not a PLY file: a negative number of elements '" + element + "'");
      if (count > double(std::filesystem::file_size(file)))
        throw Input_error(file, "cut short: more elements '" + element + "' than bytes");
    }
    if (keyword.compare(0, 8, "property") != 0) continue;
    if (element.empty()) throw Input_error(file, "not a PLY file: a property without an element");
    words >> type >> name;
    if (type == "list") words >> type >> name; // of its size, of its items, its name
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
}

// CGAL's readers write their own remarks to std::cerr.
class Silence
{
public:
  Silence() : m_buffer(std::cerr.rdbuf(nullptr)) {}
  ~Silence()
  {
    std::cerr.rdbuf(m_buffer);
    std::cerr.clear();
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

private:
  std::streambuf* m_buffer;
};

inline Mesh read_point_set(const std::string& file)
{
  CGAL::Point_set_3<Point> points;
  if (!CGAL::IO::read_point_set(file, points))
    throw Input_error(file, "not a complete file of points: it is cut short or malformed");
  Mesh mesh;
  mesh.reserve(static_cast<Mesh::size_type>(points.size()), 0, 0);
  for (auto i : points) mesh.add_vertex(points.point(i));
  auto normals = mesh.add_property_map<Vertex, Vector>(normals_of_points, CGAL::NULL_VECTOR).first;
  if (points.has_normal_map()) {
    auto v = mesh.vertices_begin();
    for (auto i : points) normals[*v++] = points.normal(i);
  }
  return mesh;
}

// By way of a list of faces, so that nothing damaged gets into a mesh: CGAL's readers of meshes trust the file.
inline Mesh read_mesh(const std::string& file)
{
  std::vector<Point> points;
  std::vector<Corners> faces;
  bool is_read = extension(file) == "off" && read_plain_off(file, points, faces);
  if (!is_read) {
    points.clear();
    faces.clear();
    is_read = CGAL::IO::read_polygon_soup(file, points, faces);
  }
  if (!is_read) throw Input_error(file, "not a complete " + extension(file) + " file: it is cut short or malformed");
  const std::string why_not = why_not_a_mesh(points.size(), faces);
  if (!why_not.empty()) throw Input_error(file, why_not);
  Mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, faces, mesh);
  return mesh;
}

constexpr char larger_than_memory[] = "it is larger than the memory, or says so";

// Reads a mesh or, from a file that has no faces, a point set. \throw Input_error
inline Mesh read_input(const std::string& file)
try {
  check_readable(file);
  const Silence silence;
  const std::string format = extension(file);
  Mesh mesh;
  if (is_one_of(format, {"off", "obj", "ply", "stl", "ts"})) {
    if (format == "ply") check_ply_header(file);
    mesh = read_mesh(file);
    if (is_point_set(mesh) && is_one_of(format, {"off", "ply"})) mesh = read_point_set(file);
    else if (is_point_set(mesh)) throw Input_error(file, "the mesh has no faces");
  } else if (is_one_of(format, {"xyz", "pwn"})) {
    mesh = read_point_set(file);
  } else if (format == "las") {
#ifdef CGAL_LINKED_WITH_LASLIB
    mesh = read_point_set(file);
#else
    throw Input_error(file, "LAS files cannot be read: this program was compiled without LASlib");
#endif
  } else if (format == "vtp") {
#ifdef CGAL_USE_VTK
    if (!CGAL::IO::read_polygon_mesh(file, mesh)) // CGAL has no soup of polygons from such a file
      throw Input_error(file, "not a complete vtp file, or no manifold mesh");
#else
    throw Input_error(file, "VTP files cannot be read: this program was compiled without VTK");
#endif
  } else {
    const std::string known =
        "meshes are read from off, obj, ply, stl and vtp files, points from xyz, pwn, off, ply and "
        "las files";
    throw Input_error(file, (format.empty() ? "no extension that would tell the format: "
                                            : "unknown format '" + format + "': ") +
                                known);
  }
  if (mesh.number_of_vertices() == 0) throw Input_error(file, "no vertices and no points");
  return mesh;
} catch (const std::bad_alloc&) {
  throw Input_error(file, larger_than_memory);
} catch (const std::length_error&) {
  throw Input_error(file, larger_than_memory);
} catch (const CGAL::Failure_exception&) {
  throw Input_error(file, "malformed: an assertion of CGAL's reader does not hold");
}

} // namespace tool

#endif // CGAL_EXAMPLES_JET_FITTING_3_TOOL_READ_INPUT_H
