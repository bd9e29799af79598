// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What a processor can do differently: forms of a mesh and of a point set, in double and in float, and the files of the
// program, whose bytes are in the order of the machine. With "write" or "read" and a folder, the files are left for
// another machine, or taken from one.

#include "analytic_meshes.h"
#include "check.h"

#include "../../demo/Jet_fitting_3/tool/read_input.h"
#include "../../demo/Jet_fitting_3/tool/write_ply.h"
#include "../../demo/Jet_fitting_3/tool/write_vtp.h"

#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/estimate_point_monge_forms.h>
#include <CGAL/estimate_vertex_monge_forms.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

using namespace test;
using CGAL::Jet_fitting::k_rings;
using CGAL::Jet_fitting::nearest;

const Analytic_mesh sampled = torus(2, 0.7, 48, 24);

template <class Form>
double error_of(const Form& form, const Point& p)
{
  if (form.coefficients().empty()) return 1e9;
  const Curvatures truth = sampled.truth(p);
  const auto n = form.normal_direction();
  const bool is_turned = n.x() * truth.normal.x + n.y() * truth.normal.y + n.z() * truth.normal.z < 0;
  const double k1 = form.principal_curvatures(is_turned ? 1 : 0), k2 = form.principal_curvatures(is_turned ? 0 : 1),
               side = is_turned ? -1 : 1;
  return std::max(std::abs(side * k1 - truth.k1), std::abs(side * k2 - truth.k2));
}

// Curvatures of the torus by rings and by nearest points: nearly all of the errors is truncation, which is the same on
// every processor.
template <class FT>
void forms(const std::string& what)
{
  using Kernel = CGAL::Simple_cartesian<FT>;
  using Point_3 = typename Kernel::Point_3;
  using Form = typename CGAL::Monge_via_jet_fitting<Kernel>::Monge_form;
  CGAL::Surface_mesh<Point_3> mesh;
  build(sampled, mesh);
  std::vector<Form> of_mesh(sampled.points.size()), of_points;
  const auto degree = CGAL::parameters::degree_fitting(4);
  CGAL::estimate_vertex_monge_forms(mesh, k_rings(3), CGAL::make_property_map(of_mesh), degree);
  std::vector<Point_3> points;
  for (const Point& p : sampled.points) points.emplace_back(FT(p.x), FT(p.y), FT(p.z));
  CGAL::estimate_point_monge_forms(points, nearest(37), std::back_inserter(of_points), degree);
  double of_rings = 0, of_nearest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    of_rings = std::max(of_rings, error_of(of_mesh[i], sampled.points[i]));
    of_nearest = std::max(of_nearest, error_of(of_points[i], sampled.points[i]));
  }
  check_near(of_rings, 0.0503692, 1e-5, what + ": error of curvatures of a mesh");
  check_near(of_nearest, 0.1886386, 1e-5, what + ": error of curvatures of a point set");
}

double written_value(std::size_t v) { return std::sin(double(v)); }

// Binary STL files have the low byte first, on all machines.
void write_stl(const std::string& file)
{
  std::ofstream out(file, std::ios::binary);
  const auto put = [&out](const auto& number) {
    char bytes[sizeof(number)];
    std::memcpy(bytes, &number, sizeof(number));
    if (!tool::is_little_endian()) std::reverse(bytes, bytes + sizeof(number));
    out.write(bytes, sizeof(number));
  };
  out << std::string(80, ' ');
  put(std::uint32_t(sampled.faces.size()));
  for (const auto& face : sampled.faces) {
    for (int i = 0; i < 3; ++i) put(0.f);
    for (const std::size_t corner : face)
      for (const double x : {sampled.points[corner].x, sampled.points[corner].y, sampled.points[corner].z})
        put(float(x));
    put(std::uint16_t(0));
  }
}

void write_files(const std::filesystem::path& folder)
{
  tool::Mesh mesh;
  build(sampled, mesh);
  const std::vector<tool::Quantity> quantities{
      {{"H", "mean curvature", -1}, 1, [](std::size_t v, int) { return written_value(v); }}};
  const std::vector<tool::Color> colors(mesh.number_of_vertices(), tool::Color{{1, 2, 3}});
  const std::vector<std::uint16_t> statuses(mesh.number_of_vertices(), 0x0102);
  const tool::Vertex_table table{mesh, quantities, &quantities[0], colors, statuses, {"a torus"}};
  std::ofstream ply(folder / "torus.ply", std::ios::binary), vtp(folder / "torus.vtp", std::ios::binary);
  tool::write_ply(ply, table);
  tool::write_vtp(vtp, table);
  check_true(bool(ply) && bool(vtp), "files are written");
  write_stl((folder / "torus.stl").string());
}

void read_ply(const std::string& file)
{
  const tool::Mesh mesh = tool::read_input(file).mesh;
  check_equal(mesh.number_of_faces(), sampled.faces.size(), "faces of the PLY file");
  if (!check_equal(mesh.number_of_vertices(), sampled.points.size(), "points of the PLY file")) return;
  double farthest = 0;
  for (std::size_t i = 0; i < sampled.points.size(); ++i)
    for (int c : {0, 1, 2}) {
      const Point& p = sampled.points[i];
      const double written = c == 0 ? p.x : c == 1 ? p.y : p.z;
      const tool::Vertex v(static_cast<tool::Mesh::size_type>(i));
      farthest = std::max(farthest, std::abs(mesh.point(v)[c] - written));
    }
  check_le(farthest, 1e-13, "distance of points of the PLY file from those that were written");
}

void read_stl(const std::string& file)
{
  const tool::Mesh mesh = tool::read_input(file).mesh;
  check_equal(mesh.number_of_faces(), sampled.faces.size(), "faces of the STL file");
  check_equal(mesh.number_of_vertices(), sampled.points.size(), "points of the STL file");
  double farthest = 0;
  for (const auto v : vertices_around_face(mesh.halfedge(*mesh.faces_begin()), mesh)) {
    double nearest = 1e9;
    for (const std::size_t i : sampled.faces[0])
      nearest =
          std::min(nearest, std::hypot(mesh.point(v).x() - sampled.points[i].x, mesh.point(v).y() - sampled.points[i].y,
                                       mesh.point(v).z() - sampled.points[i].z));
    farthest = std::max(farthest, nearest);
  }
  check_le(farthest, 1e-6, "distance of the corners of the first face of the STL file from what was written");
}

// The numbers of one array of a VTP file, whatever its byte order.
template <class Number>
std::vector<Number> array_of_vtp(const std::string& bytes, const std::string& name)
{
  const std::size_t at = bytes.find("Name=\"" + name + '"'), offset = bytes.find("offset=\"", at) + 8;
  const char* data = bytes.data() + bytes.find("\n_") + 2 + std::stoul(bytes.substr(offset, 20));
  const bool is_little = bytes.find("byte_order=\"LittleEndian\"") != std::string::npos;
  const auto next = [&](auto& number) {
    char own[sizeof(number)];
    std::copy(data, data + sizeof(number), own);
    if (is_little != tool::is_little_endian()) std::reverse(own, own + sizeof(number));
    std::memcpy(&number, own, sizeof(number));
    data += sizeof(number);
  };
  std::uint64_t size = 0;
  next(size);
  std::vector<Number> numbers((std::min)(std::size_t(size), bytes.size()) / sizeof(Number));
  for (Number& number : numbers) next(number);
  return numbers;
}

void read_vtp(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  const auto points = array_of_vtp<double>(bytes, "Points");
  const auto values = array_of_vtp<float>(bytes, "H");
  const auto statuses = array_of_vtp<std::uint16_t>(bytes, "status");
  const std::size_t n = sampled.points.size();
  check_equal(points.size(), 3 * n, "coordinates of the VTP file");
  check_equal(values.size(), n, "values of the VTP file");
  check_equal(statuses.size(), n, "statuses of the VTP file");
  if (points.size() != 3 * n || values.size() != n || statuses.size() != n) return;
  double farthest = 0;
  for (std::size_t i = 0; i < n; ++i)
    farthest =
        std::max({farthest, std::abs(points[3 * i + 1] - sampled.points[i].y), std::abs(values[i] - written_value(i))});
  check_le(farthest, 1e-7, "difference of the VTP file from what was written");
  check_equal(statuses.back(), 0x0102, "a status in the VTP file");
}

int main(int argc, char** argv)
{
  const std::string task = argc == 3 ? argv[1] : "all";
  std::filesystem::path folder = std::filesystem::temp_directory_path() / "jet_fitting_3_other_processors";
  if (argc == 3) folder = argv[2];
  if (task == "all") {
    forms<double>("double");
    forms<float>("float");
    std::filesystem::create_directories(folder);
  }
  if (task != "read") write_files(folder);
  if (task != "write") {
    read_ply((folder / "torus.ply").string());
    read_vtp((folder / "torus.vtp").string());
    read_stl((folder / "torus.stl").string());
  }
  if (task == "all") std::filesystem::remove_all(folder);
  return result();
}
