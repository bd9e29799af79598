// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The program Mesh_estimation from outside: what it writes can be read by CGAL and is right; what it cannot read it
// refuses in one sentence, with exit code 2, and without a file left behind.
// Arguments: the program, an empty folder.

#include "check.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
namespace fs = std::filesystem;

std::string program;

std::string contents(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

struct Run
{
  int exit_code;
  std::string out, err;
};

Run run(const std::string& arguments)
{
  const int status = std::system((program + ' ' + arguments + " > stdout.txt 2> stderr.txt").c_str());
  const Run result{WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents("stdout.txt"), contents("stderr.txt")};
  fs::remove("stdout.txt");
  fs::remove("stderr.txt");
  return result;
}

std::size_t number_of_files()
{
  return std::size_t(std::distance(fs::directory_iterator("."), fs::directory_iterator()));
}

// A torus around the z axis, radii 2 and 1, oriented outwards.
constexpr int around = 60, across = 40;

std::string torus()
{
  const double pi = std::acos(-1.);
  std::ostringstream out;
  out.precision(17);
  out << "OFF\n" << around * across << ' ' << 2 * around * across << " 0\n";
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double u = 2 * pi * i / around, v = 2 * pi * j / across, r = 2 + std::cos(v);
      out << r * std::cos(u) << ' ' << r * std::sin(u) << ' ' << std::sin(v) << '\n';
    }
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const int next = (i + 1) % around, a = i * across + j, b = next * across + j,
                c = next * across + (j + 1) % across, d = i * across + (j + 1) % across;
      out << "3 " << a << ' ' << b << ' ' << c << "\n3 " << a << ' ' << c << ' ' << d << '\n';
    }
  return out.str();
}

void write(const std::string& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

template <class T>
Mesh::Property_map<Vertex, T> property(Mesh& mesh, const std::string& name)
{
  const auto map = mesh.add_property_map<Vertex, T>("v:" + name);
  test::check_true(!map.second, "the PLY file has " + name);
  return map.first;
}

// At every vertex of the torus: the quantities in the PLY file against the truth, and against each other.
void check_round_trip()
{
  const Run made = run("torus.off -d 4 -a 3 -o torus.ply torus.vtp torus.csv --directions directions.ply");
  test::check_equal(made.exit_code, 0, "exit code for the torus: " + made.err);
  test::check_equal(made.err, std::string(), "nothing on stderr where it is no terminal");

  std::ifstream in("torus.ply", std::ios::binary);
  Mesh mesh;
  std::string comments;
  test::check_true(CGAL::IO::read_PLY(in, mesh, comments), "CGAL reads the PLY file");
  test::check_equal(mesh.number_of_vertices(), std::size_t(around * across), "vertices of the PLY file");
  test::check_equal(mesh.number_of_faces(), std::size_t(2 * around * across), "faces of the PLY file");

  const auto map = [&mesh](const std::string& name) { return property<float>(mesh, name); };
  for (const char* name :
       {"shape_index", "curvedness", "b0", "b1", "b2", "b3", "c0", "c1", "c2", "c3", "c4", "residual"})
    map(name);
  const auto k1 = map("k1"), k2 = map("k2"), h = map("H"), k = map("K"), condition = map("condition_number");
  const auto d1x = map("d1x"), d1y = map("d1y"), d1z = map("d1z"), d2x = map("d2x"), d2y = map("d2y"), d2z = map("d2z");
  const auto normal = property<Kernel::Vector_3>(mesh, "normal");
  const auto status = property<std::uint16_t>(mesh, "status");
  property<CGAL::IO::Color>(mesh, "color");
  if (test::failures() > 0) return;

  double normal_error = 0, k_error = 0, product_error = 0, frame_error = 0, least_condition = 1e300;
  bool is_estimated = true;
  for (Vertex v : mesh.vertices()) {
    const Point& p = mesh.point(v);
    const double distance = std::hypot(p.x(), p.y()), cosine = distance - 2;
    const double across_circle = -1, around_axis = -cosine / distance;
    const Kernel::Vector_3 outward(cosine * p.x() / distance, cosine * p.y() / distance, p.z());
    normal_error = std::max(normal_error, std::sqrt((normal[v] - outward).squared_length()));
    k_error = std::max({k_error, std::abs(k2[v] - std::min(across_circle, around_axis)),
                        std::abs(k1[v] - std::max(across_circle, around_axis))});
    product_error = std::max({product_error, std::abs(double(h[v]) - (double(k1[v]) + k2[v]) / 2),
                              std::abs(double(k[v]) - double(k1[v]) * k2[v])});
    frame_error = std::max(frame_error, std::abs(double(d1x[v]) * d2x[v] + d1y[v] * d2y[v] + d1z[v] * d2z[v]));
    least_condition = std::min(least_condition, double(condition[v]));
    is_estimated = is_estimated && (status[v] & 1) != 0;
  }
  test::check_le(normal_error, 5e-3, "error of the normals on the torus");
  test::check_le(k_error, 5e-3, "error of k1 and k2 on the torus");
  test::check_le(product_error, 1e-6, "H and K follow from k1 and k2");
  test::check_le(frame_error, 1e-6, "d1 and d2 are orthogonal");
  test::check_ge(least_condition, 1., "condition numbers");
  test::check_true(is_estimated, "every status says estimated");

  std::ifstream csv("torus.csv");
  std::string line;
  std::getline(csv, line);
  const auto columns = std::count(line.begin(), line.end(), ',');
  long rows = 0;
  bool is_table = true;
  while (std::getline(csv, line)) {
    ++rows;
    is_table = is_table && std::count(line.begin(), line.end(), ',') == columns;
  }
  test::check_equal(rows, long(around * across), "lines of the CSV file");
  test::check_true(is_table, "every line of the CSV file has all columns");
  test::check_true(contents("torus.vtp").find("</VTKFile>") != std::string::npos, "the VTP file is complete");
  test::check_true(contents("directions.ply").find("element edge 2400") != std::string::npos,
                   "a segment for each vertex");

  const Run read_again = run("torus.vtp -o torus_again.ply -a 3 -d 4 -q"); // by VTK, where the program has it
  if (read_again.exit_code == 0)
    test::check_true(contents("torus_again.ply") == contents("torus.ply"), "the same from the VTP file");
  else test::check_true(read_again.err.find("without VTK") != std::string::npos, "VTP not read: " + read_again.err);
}

void check_old_options()
{
  test::check_equal(run("-f torus.off -d2 -m2 -a2 -v 1").exit_code, 0, "CGAL's options");
  std::ifstream in("torus.off.4ogl.txt");
  double x;
  long numbers = 0;
  while (in >> x) ++numbers;
  test::check_true(in.eof(), "the 4ogl file holds numbers only");
  test::check_equal(numbers, 14L * around * across, "14 numbers for each vertex in the 4ogl file");
  test::check_true(contents("torus.off.verb.txt").find("condition_number") != std::string::npos, "the verbose file");
  fs::remove("torus.off.4ogl.txt");
  test::check_equal(run("torus.off --directions d.obj -q").exit_code, 0, "an output of directions only");
  test::check_true(!fs::exists("torus.off.4ogl.txt"), "the 4ogl file is written only where no output is named");
  test::check_equal(run("-f torus.off -d2 -p 3").exit_code, 2, "too few points for the degree");
}

void check_ridges()
{
  const Run made = run("torus.off --ridges all --ridges-output r.ply r.obj r.vtp -a 3 -q -t 1");
  test::check_equal(made.exit_code, 0, "exit code with ridges: " + made.err);
  test::check_equal(made.out, std::string(), "nothing is printed with -q");
  test::check_true(contents("r.obj").find("\nl ") != std::string::npos, "ridge lines of the torus");
  test::check_equal(run("torus.off --ridges-output r.ply").exit_code, 2, "ridge output without ridges");
  test::check_equal(run("quads.off --ridges all").exit_code, 2, "ridges of a mesh of quads");
}

void check_points()
{
  std::string lines = torus();
  lines = lines.substr(lines.find('\n', lines.find('\n') + 1) + 1);
  std::istringstream in(lines);
  std::string points, line;
  for (int i = 0; i < around * across && std::getline(in, line); ++i) points += line + '\n';
  write("points.xyz", points);
  test::check_equal(run("points.xyz -p 20 -o points.ply points.vtp").exit_code, 0, "a point set");
  test::check_true(contents("points.ply").find("element vertex 2400") != std::string::npos, "all points are written");
  write("points.xyz", points + "1 2");
  test::check_equal(run("points.xyz -o cut.ply").exit_code, 2, "a point set that is cut short");
}

void check_refused(const std::string& file, const std::string& word)
{
  const std::size_t before = number_of_files();
  const Run refused = run(file + " -o out.ply out.vtp");
  test::check_equal(refused.exit_code, 2, "exit code for " + file);
  test::check_true(refused.err.find(word) != std::string::npos, file + " is said to be " + word + ": " + refused.err);
  test::check_equal(std::count(refused.err.begin(), refused.err.end(), '\n'), 1L, "one line on stderr for " + file);
  test::check_equal(number_of_files(), before, "no file is left behind for " + file);
}

void check_bad_input()
{
  const std::string whole = torus();
  write("cut_in_points.off", whole.substr(0, whole.size() / 3));
  write("cut_in_faces.off", whole.substr(0, whole.size() * 9 / 10));
  write("empty.off", "");
  write("nothing.off", "OFF\n0 0 0\n");
  write("words.stl", "hello\n");
  write("words.ply", "hello\n");
  write("fan.off", "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0\n3 0 1 2\n3 1 0 3\n3 0 1 4\n");
  write("twisted.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 0 1 3\n");
  write("butterfly.off", "OFF\n5 2 0\n0 0 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n3 0 1 2\n3 0 3 4\n");
  write("index.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n");
  write("mesh.unknown", whole);
  check_refused("cut_in_points.off", "cut short");
  check_refused("cut_in_faces.off", "cut short");
  check_refused("empty.off", "empty");
  check_refused("nothing.off", "no vertices");
  check_refused("words.stl", "no faces");
  check_refused("words.ply", "malformed");
  check_refused("fan.off", "between vertices 0 and 1 belongs to 3 faces");
  check_refused("twisted.off", "not oriented");
  check_refused("butterfly.off", "several fans of faces meet in vertex 0");
  check_refused("index.off", "face 0 refers to vertex 7 of 3");
  check_refused("mesh.unknown", "unknown format");
  check_refused("missing.off", "no such file");
}

void check_bad_arguments()
{
  for (const char* arguments :
       {"--no-such-option", "torus.off -d 0", "torus.off -d 2 -m 3", "torus.off -r -1", "torus.off --ridges some",
        "torus.off -d 2 --ridges crest", "torus.off -o out.txt", "torus.off --color b0", "torus.off --view 1,2",
        "torus.off --view 0,0,1", "a.off b.off", "-d %value%", "--co%original_token%"}) {
    const std::size_t before = number_of_files();
    const Run refused = run(arguments);
    test::check_equal(refused.exit_code, 2, std::string("exit code for ") + arguments);
    test::check_equal(number_of_files(), before, std::string("no file is left behind for ") + arguments);
  }
  test::check_equal(run("torus.off -o no_such_folder/out.ply").exit_code, 1, "an output that cannot be written");
  const Run help = run("--help");
  test::check_equal(help.exit_code, 0, "exit code for help");
  test::check_true(help.out.find("Usage") != std::string::npos, "a page of help");
}

int main(int argc, char* argv[])
{
  if (argc != 3) {
    std::cerr << "Usage: " << argv[0] << " <program Mesh_estimation> <folder to work in>\n";
    return EXIT_FAILURE;
  }
  program = argv[1];
  fs::remove_all(argv[2]);
  fs::create_directories(argv[2]);
  fs::current_path(argv[2]);
  write("torus.off", torus());
  write("quads.off", "OFF\n9 4 0\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 .1\n2 1 0\n0 2 0\n1 2 0\n2 2 0\n"
                     "4 0 1 4 3\n4 1 2 5 4\n4 3 4 7 6\n4 4 5 8 7\n");
  check_round_trip();
  check_old_options();
  check_ridges();
  check_points();
  check_bad_input();
  check_bad_arguments();
  return test::result();
}
