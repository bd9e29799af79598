// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The program Mesh_estimation from outside: what it writes can be read by CGAL and is right; what it cannot read it
// refuses in one sentence, with exit code 2, and without a file left behind.
// Arguments: the program, an empty folder.

#include "check.h"

#include "../../demo/Jet_fitting_3/tool/Progress.h"
#include "../../demo/Jet_fitting_3/tool/View.h"
#include "../../demo/Jet_fitting_3/tool/guess_pose.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
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

// Stretched along x, it has ridges; round, it has none.
std::string torus(double stretch = 1)
{
  const double pi = std::acos(-1.);
  std::ostringstream out;
  out.precision(17);
  out << "OFF\n" << around * across << ' ' << 2 * around * across << " 0\n";
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double u = 2 * pi * i / around, v = 2 * pi * j / across, r = 2 + std::cos(v);
      out << stretch * r * std::cos(u) << ' ' << r * std::sin(u) << ' ' << std::sin(v) << '\n';
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

Mesh read_ply(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  Mesh mesh;
  std::string comments;
  test::check_true(CGAL::IO::read_PLY(in, mesh, comments), "CGAL reads " + file);
  return mesh;
}

template <class T>
Mesh::Property_map<Vertex, T> property(Mesh& mesh, const std::string& name)
{
  const auto map = mesh.add_property_map<Vertex, T>("v:" + name);
  test::check_true(!map.second, "the PLY file has " + name);
  return map.first;
}

// The attributes by which VTK's programs color, shade and explain.
void check_vtk_reads_it_right()
{
  const std::string vtp = contents("torus.vtp");
  test::check_true(vtp.find("<PointData Scalars=\"H\" Normals=\"n\">") != std::string::npos,
                   "VTP: what is colored, and normals");
  test::check_true(vtp.find("<Array type=\"String\" Name=\"description\"") != std::string::npos, "VTP: a description");
  const std::string ply = contents("torus.ply");
  for (const char* words :
       {"comment jets of degree 4 from 3 rings", "comment a curvature is negative where",
        "comment colors and quality: mean curvature H [1/length]", "comment status is a sum of 1 estimated"})
    test::check_true(ply.find(words) != std::string::npos, std::string("PLY: ") + words);
}

// At every vertex of the torus: the quantities in the PLY file against the truth, and against each other.
void check_round_trip()
{
  const Run made = run("torus.off -d 4 -a 3 -o torus.ply torus.vtp torus.csv --directions directions.ply");
  test::check_equal(made.exit_code, 0, "exit code for the torus: " + made.err);
  test::check_equal(made.err, std::string(), "nothing on stderr where it is no terminal");

  Mesh mesh = read_ply("torus.ply");
  test::check_equal(mesh.number_of_vertices(), std::size_t(around * across), "vertices of the PLY file");
  test::check_equal(mesh.number_of_faces(), std::size_t(2 * around * across), "faces of the PLY file");

  const auto map = [&mesh](const std::string& name) { return property<float>(mesh, name); };
  for (const char* name :
       {"shape_index", "curvedness", "b0", "b1", "b2", "b3", "c0", "c1", "c2", "c3", "c4", "residual"})
    map(name);
  const auto k1 = map("k1"), k2 = map("k2"), h = map("H"), k = map("K"), condition = map("condition_number");
  const auto d1x = map("d1x"), d1y = map("d1y"), d1z = map("d1z"), d2x = map("d2x"), d2y = map("d2y"), d2z = map("d2z");
  const auto normal = property<Kernel::Vector_3>(mesh, "normal");
  const auto quality = map("quality");
  const auto status = property<int>(mesh, "status");
  property<CGAL::IO::Color>(mesh, "color");
  if (test::failures() > 0) return;

  double normal_error = 0, k_error = 0, product_error = 0, frame_error = 0, least_condition = 1e300;
  bool is_estimated = true, is_colored = true;
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
    is_colored = is_colored && quality[v] == h[v];
    least_condition = std::min(least_condition, double(condition[v]));
    is_estimated = is_estimated && (status[v] & 1) != 0;
  }
  test::check_le(normal_error, 5e-3, "error of the normals on the torus");
  test::check_le(k_error, 5e-3, "error of k1 and k2 on the torus");
  test::check_le(product_error, 1e-6, "H and K follow from k1 and k2");
  test::check_le(frame_error, 1e-6, "d1 and d2 are orthogonal");
  test::check_ge(least_condition, 1., "condition numbers");
  test::check_true(is_estimated, "every status says estimated");
  test::check_true(is_colored, "the colored quantity once more as quality");
  check_vtk_reads_it_right();

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

  test::check_equal(run("torus.off -q --color curvedness --picture legend.pov").exit_code, 0, "a scene");
  const std::string scene = contents("legend.pov");
  test::check_true(scene.find("\"[1/length]\"") != std::string::npos && scene.find("\"0\"") != std::string::npos,
                   "a legend with unit, and ticks from 0");

  const Run read_again = run("torus.vtp -o torus_again.ply -a 3 -d 4 -q"); // by VTK, where the program has it
  if (read_again.exit_code == 0)
    test::check_true(contents("torus_again.ply") == contents("torus.ply"), "the same from the VTP file");
  else test::check_true(read_again.err.find("without VTK") != std::string::npos, "VTP not read: " + read_again.err);
}

void check_old_options()
{
  test::check_equal(run("-f torus.off -d2 -m2 -a2 -v 1 -o torus.off.4ogl.txt").exit_code, 0, "CGAL's options");
  std::ifstream in("torus.off.4ogl.txt");
  double x;
  long numbers = 0;
  while (in >> x) ++numbers;
  test::check_true(in.eof(), "the 4ogl file holds numbers only");
  test::check_equal(numbers, 14L * around * across, "14 numbers for each vertex in the 4ogl file");
  test::check_true(contents("torus.verb.txt").find("condition_number") != std::string::npos, "the verbose file");
  fs::remove("torus.off.4ogl.txt");
  test::check_equal(run("torus.off --directions d.obj -q").exit_code, 0, "an output of directions only");
  test::check_true(!fs::exists("torus.off.4ogl.txt"), "the 4ogl file is written only where it is named");
  test::check_equal(run("-f torus.off -d2 -p 3").exit_code, 2, "too few points for the degree");
}

void check_ridges()
{
  const Run made = run("stretched.off --ridges all --ridges-output r.ply r.obj r.vtp -a 3 -q -t 1");
  test::check_equal(made.exit_code, 0, "exit code with ridges: " + made.err);
  test::check_equal(made.out, std::string(), "nothing is printed with -q");
  test::check_true(contents("r.obj").find("\nl ") != std::string::npos, "ridge lines of a stretched torus");
  const Run round = run("torus.off --ridges all --ridges-output none.obj -a 3");
  test::check_equal(round.exit_code, 0, "a round torus");
  test::check_true(round.out.find("no ridges\nno umbilics\n") != std::string::npos, "it says none: " + round.out);
  test::check_true(contents("none.obj").find("\nl ") == std::string::npos, "a round torus has no ridges");
  test::check_equal(run("torus.off --ridges-output r.ply").exit_code, 2, "ridge output without ridges");
  test::check_equal(run("quads.off --ridges all").exit_code, 2, "ridges of a mesh of quads");
}

void check_says(const std::string& arguments, const std::string& words)
{
  const Run made = run(arguments + " -o choice.ply");
  test::check_equal(made.exit_code, 0, arguments + ": " + made.err);
  test::check_true(made.out.find(words) != std::string::npos, arguments + " says '" + words + "': " + made.out);
}

// Points without normals are oriented alike: the sign of the curvature across the circle, everywhere on the torus. It
// is k2, and negative, with normals outwards; k1 with normals inwards.
void check_orientation_of_points(const std::string& file, const std::string& curvature, int sign)
{
  Mesh mesh = read_ply(file);
  const auto k = property<float>(mesh, curvature);
  std::size_t count = 0;
  for (Vertex v : mesh.vertices()) count += float(sign) * k[v] > 0;
  test::check_equal(count, std::size_t(around * across), file + ": points where " + curvature + " has its sign");
}

// As if the file had no normals, but for the sides: what is given says which side is outside.
void check_some_normals(const std::string& points)
{
  std::istringstream in(points);
  std::string some, line;
  for (int i = 0; std::getline(in, line); ++i) {
    double x, y, z;
    std::istringstream(line) >> x >> y >> z;
    const double distance = std::hypot(x, y), cosine = 2 - distance; // inwards
    std::ostringstream normal;
    normal << ' ' << cosine * x / distance << ' ' << cosine * y / distance << ' ' << -z;
    some += line + (i < around * across / 2 ? normal.str() : "") + '\n';
  }
  write("some.xyz", some);
  const Run made = run("some.xyz -o some.ply");
  test::check_equal(made.exit_code, 0, "a point set with some normals: " + made.err);
  test::check_true(made.out.find(
                       "1200 of 2400 points have no normal, and those of the others orient but are not data") !=
                       std::string::npos,
                   "how many have none: " + made.out);
  check_orientation_of_points("some.ply", "k1", 1);
}

// Errors follow the forms that are turned to agree with their neighbors.
void check_errors_of_turned_points(const std::string& options)
{
  test::check_equal(run("points.xyz -q " + options + " -o up.ply").exit_code, 0, "errors of points");
  test::check_equal(run("points.xyz -q --flip " + options + " -o down.ply").exit_code, 0, "errors inside out");
  Mesh up = read_ply("up.ply"), down = read_ply("down.ply");
  const auto k1 = property<float>(up, "k1"), of_k1 = property<float>(up, "k1_error"),
             of_k2 = property<float>(up, "k2_error"), turned = property<float>(down, "k2"),
             of_turned = property<float>(down, "k2_error");
  std::size_t different = 0;
  for (Vertex v : up.vertices()) {
    test::check_equal(turned[v], -k1[v], "k2 of the other side with " + options);
    test::check_equal(of_turned[v], of_k1[v], "its error with " + options);
    different += of_k1[v] != of_k2[v];
  }
  test::check_true(different > up.number_of_vertices() / 2, "errors of k1 and k2 differ with " + options);
}

void check_points()
{
  std::string lines = torus();
  lines = lines.substr(lines.find('\n', lines.find('\n') + 1) + 1);
  std::istringstream in(lines);
  std::string points, line;
  for (int i = 0; i < around * across && std::getline(in, line); ++i) points += line + '\n';
  write("points.xyz", points);
  check_says("points.xyz -m 3", "not chosen from the data: the order of the Monge form is above 2");
  const Run made = run("points.xyz -p 20 -o points.ply points.vtp");
  test::check_equal(made.exit_code, 0, "a point set");
  test::check_true(made.out.find("points have no normals") != std::string::npos,
                   "what was done without normals: " + made.out);
  test::check_true(contents("points.ply").find("comment the points have no normals") != std::string::npos,
                   "and the file says so");
  check_orientation_of_points("points.ply", "k2", -1);
  test::check_equal(run("points.xyz -p 20 --flip -q -o points.ply").exit_code, 0, "a point set inside out");
  check_orientation_of_points("points.ply", "k1", 1);
  test::check_equal(run("points.xyz -p 20 -q -o points.ply").exit_code, 0, "a point set once more");
  check_errors_of_turned_points("-p 20 --errors");
  check_errors_of_turned_points("--automatic");
  check_some_normals(points);
  test::check_true(contents("points.ply").find("element vertex 2400") != std::string::npos, "all points are written");
  write("points.xyz", points + "1 2");
  test::check_equal(run("points.xyz -o cut.ply").exit_code, 2, "a point set that is cut short");
  write("points.xyz", points + "4 5 6 x\n");
  const Run refused = run("points.xyz -o cut.ply");
  test::check_equal(refused.exit_code, 2, "a point set with a word");
  test::check_true(refused.err.find("line 2401") != std::string::npos, "the line is named: " + refused.err);
  for (const auto& [text, words] : {std::pair("0 0 0\n1 nan 0\n", "line 2: 'nan' is no finite number"),
                                    {"0 0 0\n\n1 0 -inf\n", "line 3: '-inf' is no finite number"},
                                    {"0 0 0 7\n1 0 0 7\n", "line 1: 4 numbers"}}) {
    write("odd.xyz", text);
    const Run odd = run("odd.xyz -o odd.ply");
    test::check_equal(odd.exit_code, 2, "exit code for these points: " + std::string(text));
    test::check_true(odd.err.find(words) != std::string::npos, "it says '" + std::string(words) + "': " + odd.err);
  }
  write("points.xyz", points);
  test::check_equal(run("points.xyz -a 3").exit_code, 2, "rings of points");
  test::check_equal(run("points.xyz --sharp-angle 30").exit_code, 2, "sharp edges of points");
  write("three.xyz", "0 0 0\n1 0 0\n0 1 0\n");
  const std::size_t before = number_of_files();
  test::check_equal(run("three.xyz").exit_code, 1, "nothing estimated");
  test::check_equal(number_of_files(), before, "no file where nothing is estimated");
}

// Nothing but the input: the data decide, wherever that is possible, and the summary says what was done and why.
void check_choice()
{
  check_says("torus.off", "jets of radius and degree chosen for each vertex, Monge forms of degree 2: 2400 estimated");
  check_says("torus.off", "noise of points, along the normal: ");
  check_says("torus.off", "chosen degrees: ");
  Mesh mesh = read_ply("choice.ply");
  const auto k1 = property<float>(mesh, "k1"), bias = property<float>(mesh, "bias"),
             radius = property<float>(mesh, "radius"), degree = property<float>(mesh, "degree");
  double square_sum = 0;
  for (Vertex v : mesh.vertices()) {
    const Kernel::Point_3& p = mesh.point(v);
    const double rho = std::hypot(p.x(), p.y()), truth = (2 - rho) / rho; // of a tube of radius 1 around one of 2
    square_sum += (k1[v] - truth) * (k1[v] - truth);
    test::check_true(bias[v] >= 0, "an estimate of the bias at each vertex");
    test::check_true(radius[v] > 0.1 && radius[v] < 2, "a radius at each vertex");
    test::check_true(degree[v] == 2 || degree[v] == 4 || degree[v] == 6, "a degree at each vertex");
  }
  // -d 2, the fixed choice, has 0.0145 on this mesh without noise
  test::check_le(std::sqrt(square_sum / double(mesh.number_of_vertices())), 0.03, "RMS error of k1, automatic choice");
  test::check_equal(run("torus.off -q -o radius.ply --color radius --picture radius.pov").exit_code, 0, "a picture");
  mesh = read_ply("radius.ply");
  const auto colored = property<float>(mesh, "quality"), chosen = property<float>(mesh, "radius");
  for (Vertex v : mesh.vertices()) test::check_equal(colored[v], chosen[v], "colored by the chosen radius");
  test::check_true(contents("radius.pov").find("chosen radius") != std::string::npos, "its legend");
  check_says("torus.off -d 2", "jets of degree 2 from rings up to 12 points");
  check_says("torus.off -m 3", "chosen for each vertex, Monge forms of degree 3: 2400 estimated");
  check_says("torus.off --ridges crest", "chosen for each vertex, Monge forms of degree 4: 2400 estimated");
  check_says("torus.off --errors", "not chosen from the data: --errors is set");
  check_says("quads.off --lower-degree", "not chosen from the data: the noise of this mesh of 9 vertices is unknown");
}

// A file named like the input, which replaces none but the program's own; the input may come after the outputs.
void check_default_output()
{
  const Run made = run("torus.off");
  test::check_equal(made.exit_code, 0, "no output named: " + made.err);
  test::check_true(made.out.find("written: torus.ply (opens colored in MeshLab") != std::string::npos, "what opens it");
  test::check_equal(run("torus.ply -q").exit_code, 0, "the input is a PLY file of this folder");
  test::check_true(fs::exists("torus_curvatures.ply"), "the input is not replaced");
  write("other.off", torus());
  write("other.ply", "ply\n");
  test::check_equal(run("other.off -q").exit_code, 0, "a PLY file of that name is there");
  test::check_true(contents("other.ply") == "ply\n" && fs::exists("other_curvatures.ply"), "and is not replaced");
  test::check_equal(run("-q -o first.ply second.csv torus.off").exit_code, 0, "outputs, then the input");
  test::check_true(fs::exists("first.ply") && fs::exists("second.csv"), "outputs before the input");
}

struct Torus_with_normals
{
  std::vector<std::string> points, normals; // three numbers each
  std::vector<std::array<int, 3>> faces;
};

// Normals are turned by a sign.
Torus_with_normals torus_with_normals(double sign)
{
  const double pi = std::acos(-1.);
  std::istringstream in(torus());
  Torus_with_normals result;
  std::string line;
  std::getline(in, line);
  std::getline(in, line);
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across && std::getline(in, line); ++j) {
      const double u = 2 * pi * i / around, v = 2 * pi * j / across, r = sign * std::cos(v);
      std::ostringstream normal;
      normal.precision(17);
      normal << r * std::cos(u) << ' ' << r * std::sin(u) << ' ' << sign * std::sin(v);
      result.points.push_back(line);
      result.normals.push_back(normal.str());
    }
  std::array<int, 3> face;
  for (int three = 0; in >> three >> face[0] >> face[1] >> face[2];) result.faces.push_back(face);
  return result;
}

std::string as_off_or_ply(const Torus_with_normals& torus, bool is_ply)
{
  std::ostringstream out;
  const std::size_t points = torus.points.size(), faces = torus.faces.size();
  if (!is_ply) out << "NOFF\n" << points << ' ' << faces << " 0\n";
  else
    out << "ply\nformat ascii 1.0\nelement vertex " << points
        << "\nproperty double x\nproperty double y\nproperty double z\nproperty double nx\nproperty double ny\n"
           "property double nz\nelement face "
        << faces << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (std::size_t i = 0; i < points; ++i) out << torus.points[i] << ' ' << torus.normals[i] << '\n';
  for (const auto& f : torus.faces) out << "3 " << f[0] << ' ' << f[1] << ' ' << f[2] << '\n';
  return out.str();
}

// Normals come in another order than vertices; some corners count them from the end, some name a texture, too.
std::string as_obj(const Torus_with_normals& torus)
{
  std::ostringstream out;
  const int n = int(torus.points.size());
  for (int i = 0; i < n; ++i) out << "v " << torus.points[std::size_t(i)] << '\n';
  for (int i = n; i > 0; --i) out << "vn " << torus.normals[std::size_t(i) - 1] << '\n';
  out << "vt 0 0\n";
  for (const auto& f : torus.faces)
    out << "f " << f[0] + 1 << "//" << n - f[0] << ' ' << f[1] + 1 << "/1/" << n - f[1] << ' ' << f[2] + 1 << "//"
        << -f[2] - 1 << '\n';
  return out.str();
}

// Each face has vertices of its own. At the first vertex one face has another normal.
Torus_with_normals torn(const Torus_with_normals& torus)
{
  Torus_with_normals result;
  for (const auto& face : torus.faces) {
    const int first = int(result.points.size());
    for (const int v : face) {
      result.points.push_back(torus.points[std::size_t(v)]);
      result.normals.push_back(torus.normals[std::size_t(v)]);
    }
    result.faces.push_back({first, first + 1, first + 2});
  }
  result.normals.front() = "0 0 1";
  return result;
}

// Exact normals of a file are data, on whichever side they are.
void check_normals_of_meshes()
{
  std::string expected;
  for (const std::string format : {"off", "ply", "obj"})
    for (const double sign : {1., -1.}) {
      const std::string name = "normals." + format;
      const Torus_with_normals torus = torus_with_normals(sign);
      write(name, format == "obj" ? as_obj(torus) : as_off_or_ply(torus, format == "ply"));
      const Run made = run(name + " -o normals.csv");
      test::check_true(made.out.find("normals of the file are data") != std::string::npos, name + ": " + made.out);
      if (expected.empty()) expected = contents("normals.csv");
      else test::check_true(contents("normals.csv") == expected, "the same forms from " + name);
    }
  write("torn.ply", as_off_or_ply(torn(torus_with_normals(1)), true));
  const Run made = run("torn.ply");
  test::check_true(made.out.find("were joined to " + std::to_string(around * across)) != std::string::npos &&
                       made.out.find("normals of the file are data") != std::string::npos,
                   "normals of vertices that are joined: " + made.out);
  test::check_equal(run("torus.off -q -o normals.csv").exit_code, 0, "without normals");
  test::check_true(contents("normals.csv") != expected, "forms are others with normals");
}

// Permissions and symbolic links of files that are replaced.
void check_replaced_files()
{
  fs::create_directory("folder");
  write("folder/real.ply", "");
  fs::permissions("folder/real.ply", fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
  fs::create_symlink("folder/real.ply", "link.ply");
  test::check_equal(run("torus.off -q -o link.ply").exit_code, 0, "an output that is a symbolic link");
  test::check_true(fs::is_symlink("link.ply") && fs::file_size("folder/real.ply") > 0, "the link stays");
  test::check_true(fs::status("folder/real.ply").permissions() ==
                       (fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read),
                   "permissions are kept");
  test::check_equal(run("torus.off -q -o link.ply folder/real.ply").exit_code, 2, "a file and a link to it");
}

// Two square grids that meet at a right angle: there each side has its own vertices, forms and normals.
void check_sharp_edges()
{
  const int n = 12;
  std::ostringstream roof;
  roof << "OFF\n" << (2 * n + 1) * (n + 1) << ' ' << 2 * n * n << " 0\n";
  for (int i = 0; i <= 2 * n; ++i)
    for (int j = 0; j <= n; ++j) roof << std::max(n - i, 0) << ' ' << j << ' ' << std::min(n - i, 0) << '\n';
  for (int i = 0; i < 2 * n; ++i)
    for (int j = 0; j < n; ++j) {
      const int a = i * (n + 1) + j;
      roof << "4 " << a << ' ' << a + 1 << ' ' << a + n + 2 << ' ' << a + n + 1 << '\n';
    }
  write("roof.off", roof.str());
  check_says("roof.off", "12 edges are sharp, as of a CAD part");
  test::check_true(run("torus.off -o choice.ply").out.find("are sharp") == std::string::npos, "a torus has no edges");
  const Run made = run("roof.off --sharp-angle auto -o roof.ply --picture roof.pov");
  test::check_equal(made.exit_code, 0, "sharp edges: " + made.err);
  test::check_true(made.out.find("12 sharp edges, of more than 40 degrees; 13 vertices were added") !=
                       std::string::npos,
                   "sharp edges are counted: " + made.out);
  test::check_true(contents("roof.pov").find("\"sharp edge\"") != std::string::npos, "sharp edges are drawn");
  Mesh mesh = read_ply("roof.ply");
  test::check_equal(mesh.number_of_vertices(), std::size_t((2 * n + 2) * (n + 1)), "vertices of the roof, by sides");
  const auto k1 = property<float>(mesh, "k1"), k2 = property<float>(mesh, "k2");
  const auto normal = property<Kernel::Vector_3>(mesh, "normal");
  double curvature = 0, oblique = 0;
  for (Vertex v : mesh.vertices()) {
    curvature = std::max({curvature, std::abs(double(k1[v])), std::abs(double(k2[v]))});
    oblique = std::max(oblique, std::min(std::abs(normal[v].x()), std::abs(normal[v].z())));
  }
  test::check_le(curvature, 1e-9, "curvatures of the roof");
  test::check_le(oblique, 1e-9, "normals of the roof are those of its faces");
}

void check_inside_out()
{
  std::istringstream in(torus());
  std::string reversed, line;
  while (std::getline(in, line)) {
    int a, b, c;
    if (std::sscanf(line.c_str(), "3 %d %d %d", &a, &b, &c) == 3 && line.find('.') == std::string::npos)
      line = "3 " + std::to_string(a) + ' ' + std::to_string(c) + ' ' + std::to_string(b);
    reversed += line + '\n';
  }
  write("inside_out.off", reversed);
  const Run made = run("inside_out.off -o inside_out.ply");
  test::check_true(made.out.find("closed and inside out") != std::string::npos, "inside out: " + made.out);
  test::check_equal(run("inside_out.off --flip -q -o flipped.ply").exit_code, 0, "--flip");
  Mesh flipped = read_ply("flipped.ply");
  test::check_le(property<float>(flipped, "k2")[Vertex(0)], -0.9f, "k2 of the torus that was flipped");
}

// SIGTERM, sent when another program has begun to draw, which takes long: nothing is left behind.
void check_signals()
{
  fs::create_directory("bin");
  write("bin/povray", "#!/bin/sh\n[ \"$1\" = --version ] || { touch \"${0%/*}/draws\"; exec sleep 20; }\n");
  write("bin/terminate", "#!/bin/sh\n\"$@\" & while [ ! -e bin/draws ] && kill -0 $!; do sleep 0.05; done; "
                         "kill -TERM $!; wait $!\n");
  for (const char* file : {"bin/povray", "bin/terminate"}) fs::permissions(file, fs::perms::owner_all);
  const std::size_t before = number_of_files();
  const std::string usual = program;
  program = "PATH=\"$PWD/bin:$PATH\" bin/terminate " + program;
  const Run ended = run("torus.off -o ended.ply --picture ended.png");
  program = usual;
  test::check_equal(ended.exit_code, 128 + 15, "exit code after SIGTERM");
  test::check_true(ended.err.find("interrupted: no file was written") != std::string::npos, "SIGTERM: " + ended.err);
  test::check_equal(number_of_files(), before, "no file is left behind after SIGTERM");
}

// What is in the file once this is there, or after a while that is ample.
std::string contents_with(const std::string& file, const std::string& words)
{
  for (int i = 0; i < 1000 && contents(file).find(words) == std::string::npos; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  return contents(file);
}

// Lines come at intervals, whether the work reports or not.
void check_progress()
{
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen("progress.txt", "w"), &std::fclose);
  std::setbuf(file.get(), nullptr);
  tool::Progress progress(file.get(), false, std::chrono::milliseconds(20));
  progress.begin("fitting");
  progress.show(0.5);
  const std::string half = contents_with("progress.txt", "fitting  50 %, ");
  test::check_true(half.find("fitting  50 %, ") != std::string::npos && half.find(" s left\n") != std::string::npos,
                   "progress of a fraction: " + half);
  progress.begin("drawing");
  const std::string drawing = contents_with("progress.txt", " s\ndrawing, ");
  test::check_true(drawing.find(" s\ndrawing, ") != std::string::npos, "lines at intervals: " + drawing);
}

// Points of a strip of 12 x 1 along two axes; its corners, in order, are at 0, 48, 244 and 196.
tool::Mesh strip(std::size_t along, std::size_t aside)
{
  tool::Mesh points;
  for (int j = 0; j <= 4; ++j)
    for (int i = 0; i <= 48; ++i) {
      std::array<double, 3> p{};
      p[along] = i / 4.;
      p[aside] = j / 4.;
      points.add_vertex(tool::Point(p[0], p[1], p[2]));
    }
  return points;
}

// A long strip lies level, along any axis of its file, as points and as a surface; and discs do not leave the frame.
void check_view()
{
  for (const auto& [along, aside] : {std::pair(0, 1), {0, 2}, {1, 0}, {1, 2}, {2, 0}, {2, 1}})
    for (bool has_face : {false, true}) {
      tool::Mesh mesh = strip(std::size_t(along), std::size_t(aside));
      const tool::Vertex begin(0), end(48);
      if (has_face) mesh.add_face(begin, end, tool::Vertex(244), tool::Vertex(196));
      std::vector<double> radii(mesh.number_of_vertices(), 0);
      radii[end] = 2;
      const tool::Pose pose = tool::guess_pose(mesh, std::nullopt);
      const tool::View view(mesh, radii, pose.to_viewer, pose.up, 2, 0);
      const auto p = view(mesh.point(begin)), q = view(mesh.point(end));
      const std::string name = "strip along " + std::to_string(along) + ", across " + std::to_string(aside);
      test::check_le(std::abs(q[1] - p[1]), 1e-12, name + " lies level");
      test::check_ge(std::abs(q[0] - p[0]), 1., name + " is seen from the side");
      for (std::size_t i = 0; i < 2; ++i)
        test::check_le(std::abs(q[i]) + radii[end] * view.scale(), 1., name + ": its disc is in the frame");
    }
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

// Soups are made meshes, and it is said. These ones have too few points for a fit, which comes after that.
void check_mended(const std::string& file, const std::string& word)
{
  const Run made = run(file + " -d 1 -o mended.ply");
  test::check_equal(made.exit_code, 0, file + " is mended: " + made.err);
  test::check_true(made.out.find(word) != std::string::npos, file + " is said to be " + word + ": " + made.out);
  fs::remove("mended.ply");
}

// Forms of OFF: no keyword, comments, counts beside it, colors and normals behind, numbers that follow one another.
void check_same_mesh()
{
  const std::string points[] = {"0 0 0", "+1 0 0", "0 1e0 0", "1 1 .5"}, faces[] = {"3 0 1 2", "3 1 3 2"};
  std::string rest, colored, flat, homogeneous;
  for (const std::string& p : points) {
    rest += p + '\n';
    colored += p + " 0 0 1  255 0 0 255 # a point\n";
    flat += p + ' ';
    homogeneous += p + " 1\n";
  }
  for (const std::string& f : faces) {
    rest += f + "\n";
    colored += f + " 0.5 0.5 0.5\n";
    flat += f + ' ';
    homogeneous += f + '\n';
  }
  write("form.off", "OFF\n4 2 0\n" + rest);
  test::check_equal(run("form.off -d 1 -q -o expected.csv").exit_code, 0, "a plain OFF file");
  for (const std::string& text : {"4 2 0\n" + rest, "# a comment\nOFF 4 2 0\r\n\n" + rest, "CNOFF\n4 2 0\n" + colored,
                                  "OFF 4 2 5 " + flat, "4OFF\n4 2 0\n" + homogeneous, "nOFF 3\n4 2 0\n" + rest}) {
    write("form.off", text);
    test::check_equal(run("form.off -d 1 -q -o form.csv").exit_code, 0, "this OFF file is read:\n" + text);
    test::check_true(contents("form.csv") == contents("expected.csv"), "and is the same mesh:\n" + text);
  }
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
  write("plane_in_4d.off", "4nOFF\n4\n3 1 0\n0 0 0 0 1\n1 0 0 0 1\n0 1 0 0 1\n3 0 1 2\n");
  write("binary.off", std::string("OFF BINARY\n\0\0\0", 14));
  write("nan.off", "OFF\n3 1 0\n0 0 0 # a point\n1 nan 0\n0 1 0\n3 0 1 2\n");
  write("negative.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n");
  const std::string ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                          "property float z\nelement face 1\nproperty list uchar ";
  write("nan.ply", ply + "int vertex_indices\nend_header\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n");
  write("negative.ply", ply + "int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n");
  write("short.ply", ply + "short vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  write("twice.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n4 1 3 3 2\n3 2 2 1\n4 0 1 0 2\n");
  check_same_mesh();
  check_refused("plane_in_4d.off", "three coordinates");
  check_refused("binary.off", "binary");
  check_refused("cut_in_points.off", "cut short");
  check_refused("cut_in_faces.off", "cut short");
  check_refused("empty.off", "empty");
  check_refused("nothing.off", "no vertices");
  check_refused("words.stl", "no faces");
  check_refused("words.ply", "malformed");
  check_refused("nan.off", "line 4: 'nan' is no finite number");
  check_refused("negative.off", "line 6: '-1' is no whole number from 0 on");
  check_refused("nan.ply", "'vertex': 'nan' is no finite number");
  check_refused("negative.ply", "face 0 refers to vertex -1 of 3");
  check_refused("short.ply", "of int or uint");
  check_mended("twice.off", "2 faces without three corners, or with one corner twice, were left out");
  check_mended("twice.off", "4 vertices, 2 faces");
  check_mended("fan.off", "between vertices 0 and 1 belongs to 3 faces");
  check_mended("twisted.off", "not oriented");
  check_mended("butterfly.off", "several fans of faces meet in vertex 0");
  check_refused("index.off", "face 0 refers to vertex 7 of 3");
  check_refused("mesh.unknown", "unknown format");
  check_refused("missing.off", "no such file");
}

// A torus each triangle of which has vertices of its own, and one with a vertex that no face has.
void check_connections()
{
  std::istringstream in(torus());
  std::string header, points, faces, line;
  std::getline(in, header);
  std::getline(in, header);
  std::vector<std::string> lines;
  for (int i = 0; i < around * across && std::getline(in, line); ++i) lines.push_back(line + '\n');
  int corner = 0;
  for (std::size_t three, a, b, c; in >> three >> a >> b >> c; corner += 3) {
    points += lines[a] + lines[b] + lines[c];
    faces += "3 " + std::to_string(corner) + ' ' + std::to_string(corner + 1) + ' ' + std::to_string(corner + 2) + '\n';
  }
  write("soup.off", "OFF\n" + std::to_string(corner) + ' ' + std::to_string(corner / 3) + " 0\n" + points + faces);
  const Run welded = run("soup.off -d 2 -o soup.ply");
  test::check_equal(welded.exit_code, 0, "a soup of triangles: " + welded.err);
  for (const char* words :
       {"the 14400 vertices of the file were joined to 2400", "4800 faces, closed", "2400 estimated, 0 left out"})
    test::check_true(welded.out.find(words) != std::string::npos, std::string("soup: ") + words + ": " + welded.out);

  std::string isolated = torus();
  isolated.replace(isolated.find("2400"), 4, "2401");
  isolated.insert(isolated.find("3 0 40 "), "9 9 9\n");
  write("isolated.off", isolated);
  const Run made = run("isolated.off -o isolated.ply");
  test::check_equal(made.exit_code, 0, "an isolated vertex: " + made.err);
  test::check_true(made.out.find("1 of 2401 isolated") != std::string::npos, "is counted: " + made.out);
  for (const char* words : {"have too few neighbors for a choice", "too few points"})
    test::check_true(made.out.find(words) == std::string::npos, std::string("not said: ") + words + ": " + made.out);

  const Run lowered = run("torus.off -d 5 -a 1 --lower-degree -o lowered.ply");
  test::check_equal(lowered.exit_code, 0, "a lower degree: " + lowered.err);
  test::check_true(lowered.out.find("2400 of 2400 degree lowered") != std::string::npos, "is told: " + lowered.out);
  test::check_true(lowered.out.find("too few points") == std::string::npos, "and once: " + lowered.out);
}

// Small files that claim to have lists of two billion numbers, with less memory than these would take.
void check_claims()
{
  write("claim.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2147483648 0 1 2\n");
  const std::string ply = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
                          "property list int int vertex_indices\nend_header\n";
  write("claim.ply", "ply\nformat binary_little_endian 1.0\n" + ply + std::string(36, 0) + "\xff\xff\xff\x7f");
  write("claim_text.ply", "ply\nformat ascii 1.0\n" + ply + "0 0 0\n1 0 0\n0 1 0\n2147483647 0 1 2\n");
  const std::string header(80, ' ');
  write("claim.stl", header + "\xff\xff\xff\xff"); // 4294967295 facets in 84 bytes
  write("cut.stl", header + std::string("\2\0\0\0", 4) + std::string(50, '\0'));
  const std::string usual = program;
  program = "ulimit -v 4000000; " + program;
  for (const char* file : {"claim.off", "claim.ply", "claim_text.ply", "claim.stl", "cut.stl"})
    check_refused(file, "cut short");
  program = usual;
}

void check_bad_arguments()
{
  for (const char* arguments : {"--no-such-option",
                                "torus.off -d 0",
                                "torus.off -d 2 -m 3",
                                "torus.off -r -1",
                                "torus.off --ridges some",
                                "torus.off -d 2 --ridges crest",
                                "torus.off -o out.txt",
                                "torus.off --color b0",
                                "torus.off --view 1,2",
                                "torus.off --view 0,0,1 --up z",
                                "torus.off --up 0,0,0",
                                "torus.off --sharp-angle blunt",
                                "torus.off --sharp-angle 0",
                                "torus.off -d 40",
                                "torus.off -a 2 -p 10",
                                "",
                                " torus.off -o same.ply same.ply",
                                "torus.off -o same.ply --directions ./same.ply",
                                "torus.off -o torus.off",
                                "torus.off --color mean",
                                "a.off b.off",
                                "-d %value%",
                                "--co%original_token%"}) {
    const std::size_t before = number_of_files();
    const Run refused = run(arguments);
    test::check_equal(refused.exit_code, 2, std::string("exit code for ") + arguments);
    test::check_equal(number_of_files(), before, std::string("no file is left behind for ") + arguments);
  }
  const Run colors = run("torus.off --color mean");
  test::check_true(colors.err.find("one of H, K, shape_index") != std::string::npos,
                   "the names of quantities: " + colors.err);
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
  write("stretched.off", torus(1.5));
  write("quads.off", "OFF\n9 4 0\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 .1\n2 1 0\n0 2 0\n1 2 0\n2 2 0\n"
                     "4 0 1 4 3\n4 1 2 5 4\n4 3 4 7 6\n4 4 5 8 7\n");
  check_round_trip();
  check_old_options();
  check_choice();
  check_default_output();
  check_replaced_files();
  check_sharp_edges();
  check_inside_out();
  check_ridges();
  check_points();
  check_normals_of_meshes();
  check_connections();
  check_bad_input();
  check_claims();
  check_bad_arguments();
  check_signals();
  check_progress();
  check_view();
  return test::result();
}
