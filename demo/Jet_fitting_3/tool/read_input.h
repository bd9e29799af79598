// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_READ_INPUT_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_READ_INPUT_H

#include "Surface.h"
#include "extension.h"
#include "finite_number.h"
#include "mend_soup.h"
#include "normals_of_mesh.h"
#include "normals_of_obj.h"
#include "ply_stream.h"
#include "stl_stream.h"
#include "Input_error.h"
#include "check_ply.h"
#include "read_off.h"
#include "why_not_a_mesh.h"

#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/exceptions.h>
#ifdef CGAL_USE_VTK
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#endif

#include <filesystem>
#include <fstream>
#include <iostream>
#include <new>
#include <sstream>
#include <stdexcept>
#include <streambuf>
#include <string>
#include <vector>

namespace tool {

inline void check_readable(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file))
    throw Input_error(file, "there is no such file, or it may not be read");
  if (in.get() == std::ifstream::traits_type::eof()) throw Input_error(file, "the file is empty");
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

// As CGAL's readers of XYZ and PWN files do not tell a line that is none from the end: finite numbers only, three of
// them in a line, or six with the normal and more, or one in the first, the number of points of a PWN file.
inline void check_lines_of_points(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  std::size_t number = 0;
  bool is_first = true;
  const auto refuse = [&](const std::string& why) {
    throw Input_error(file, "line " + std::to_string(number) + ": " + why);
  };
  for (std::string line; std::getline(in, line);) {
    ++number;
    std::istringstream words(line);
    std::string word;
    std::size_t count = 0;
    for (; words >> word && word[0] != '#'; ++count)
      if (!is_finite_number(word)) refuse(no_finite_number(word));
    if (count == 0) continue;
    if (count < 3 && !(count == 1 && is_first)) refuse("fewer than three coordinates");
    if (count == 4 || count == 5) refuse(std::to_string(count) + " numbers; a point has 3, and with its normal 6");
    is_first = false;
  }
}

inline Input read_point_set(const std::string& file)
{
  if (is_one_of(extension(file), {"xyz", "pwn"})) check_lines_of_points(file);
  CGAL::Point_set_3<Point> points;
  const bool is_read =
      extension(file) == "ply" ? CGAL::IO::read_PLY(*ply_stream(file), points) : CGAL::IO::read_point_set(file, points);
  if (!is_read) throw Input_error(file, "not a complete file of points: it is cut short or malformed");
  Input input;
  Mesh& mesh = input.mesh;
  mesh.reserve(static_cast<Mesh::size_type>(points.size()), 0, 0);
  for (auto i : points) mesh.add_vertex(points.point(i));
  auto normals = mesh.add_property_map<Vertex, Vector>(normals_of_points, CGAL::NULL_VECTOR).first;
  if (points.has_normal_map()) {
    auto v = mesh.vertices_begin();
    for (auto i : points) normals[*v++] = points.normal(i);
  }
  input.has_normals = number_without_normal(mesh) == 0;
  return input;
}

// Those of a PLY file, of which CGAL's reader of faces has none.
inline std::vector<Vector> normals_of_ply(const std::string& file)
{
  const std::vector<Ply_element> elements = check_ply(file);
  const auto has_normals = [](const Ply_element& e) {
    const auto is_normal = [](const Ply_property& p) { return is_one_of(p.name, {"nx", "ny", "nz"}); };
    return is_one_of(e.name, {"vertex", "vertices"}) &&
           std::count_if(e.properties.begin(), e.properties.end(), is_normal) == 3;
  };
  std::vector<Vector> normals;
  if (std::none_of(elements.begin(), elements.end(), has_normals)) return normals;
  const Mesh points = read_point_set(file).mesh;
  const auto of_points = map_in(points.property_map<Vertex, Vector>(normals_of_points));
  for (const Vertex v : points.vertices()) normals.push_back(of_points[v]);
  return normals;
}

// \param normals of all points, or none
inline bool read_soup(const std::string& file, std::vector<Point>& points, std::vector<Corners>& faces,
                      std::vector<Vector>& normals)
{
  const std::string format = extension(file);
  if (format == "off") return read_off(file, points, faces, normals);
  if (format == "ply") {
    normals = normals_of_ply(file);
    return CGAL::IO::read_PLY(*ply_stream(file), points, faces);
  }
  if (format == "stl") return !is_cut_short_stl(file) && CGAL::IO::read_STL(*stl_stream(file), points, faces);
  if (!CGAL::IO::read_polygon_soup(file, points, faces)) return false;
  if (format == "obj") normals = normals_of_obj(file, points.size());
  return true;
}

// By way of a list of faces, so that nothing damaged gets into a mesh: CGAL's readers of meshes trust the file.
inline Input read_mesh(const std::string& file)
{
  std::vector<Point> points;
  std::vector<Corners> faces;
  std::vector<Vector> normals;
  if (!read_soup(file, points, faces, normals))
    throw Input_error(
        file, !points.empty() && faces.empty()
                  ? "no face was read: it is cut short, or of points alone, which xyz, pwn, off, ply and las files have"
                  : "not a complete " + extension(file) + " file: it is cut short or malformed");
  if (normals.size() != points.size()) normals.clear();
  Input input;
  const std::string why_no_faces = why_not_faces(points.size(), faces);
  if (!why_no_faces.empty()) throw Input_error(file, why_no_faces);
  for (const std::string& done : {weld(points, faces, normals), leave_out_degenerate(faces)})
    if (!done.empty()) input.remarks.push_back(done);
  std::string why_not = why_not_a_mesh(points.size(), faces);
  if (!why_not.empty()) {
    input.remarks.push_back(mend_soup(points, faces, why_not));
    why_not = why_not_a_mesh(points.size(), faces);
    if (!why_not.empty()) throw Input_error(file, why_not);
  }
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, faces, input.mesh);
  if (!normals.empty()) normals.resize(points.size(), CGAL::NULL_VECTOR);
  input.has_normals = take_normals(normals, input.mesh);
  if (CGAL::is_closed(input.mesh)) {
    std::vector<const Corners*> all;
    for (const Corners& face : faces) all.push_back(&face);
    if (signed_volume(points, all) < 0)
      input.remarks.push_back(
          "the surface is closed and inside out: its normals point inwards, and curvatures are positive "
          "where it bulges out; --flip turns it");
  }
  return input;
}

constexpr char larger_than_memory[] = "it is larger than the memory, or says so";

// Reads a mesh or, from a file that has no faces, a point set. \throw Input_error
inline Input read_input(const std::string& file)
try {
  check_readable(file);
  const Silence silence;
  const std::string format = extension(file);
  Input input;
  Mesh& mesh = input.mesh;
  if (is_one_of(format, {"off", "obj", "ply", "stl", "ts"})) {
    if (format == "ply") check_corners(file, check_ply(file));
    input = read_mesh(file);
    if (is_point_set(mesh) && is_one_of(format, {"off", "ply"})) {
      const std::vector<std::string> remarks = input.remarks;
      input = read_point_set(file);
      input.remarks = remarks;
    } else if (is_point_set(mesh)) throw Input_error(file, "the mesh has no faces");
  } else if (is_one_of(format, {"xyz", "pwn"})) {
    input = read_point_set(file);
  } else if (format == "las") {
#ifdef CGAL_LINKED_WITH_LASLIB
    input = read_point_set(file);
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
  return input;
} catch (const std::bad_alloc&) {
  throw Input_error(file, larger_than_memory);
} catch (const std::length_error&) {
  throw Input_error(file, larger_than_memory);
} catch (const CGAL::Failure_exception&) {
  throw Input_error(file, "malformed: an assertion of CGAL's reader does not hold");
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_READ_INPUT_H
