// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Differential quantities, ridges and umbilics of a mesh or a point set, from a file into files and pictures.

#include "tool/Arguments.h"
#include "tool/Colors.h"
#include "tool/Output_files.h"
#include "tool/Picture.h"
#include "tool/Quantities.h"
#include "tool/Summary_table.h"
#include "tool/estimate.h"
#include "tool/find_ridges.h"
#include "tool/interrupt.h"
#include "tool/parse.h"
#include "tool/read_input.h"
#include "tool/run_povray.h"
#include "tool/write_ply.h"
#include "tool/write_text.h"
#include "tool/write_vtp.h"

#include <CGAL/Real_timer.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace tool {

// The forms and all that follows from them.
struct Results
{
  Mesh mesh;
  Estimates estimates;
  std::vector<Quantity> quantities;
  Ridges_and_umbilics ridges;
  std::vector<Line> directions;
  Color_scale scale;
  std::vector<Color> colors;
  std::vector<std::uint16_t> statuses;
};

// Segments through the vertices, half a mean edge to either side.
std::vector<Line> directions(const Mesh& mesh, const Estimates& estimates, bool minimal)
{
  std::vector<Line> lines;
  for (Vertex v : mesh.vertices()) {
    const Monge_form& form = estimates.forms[v];
    if (form.coefficients().empty() || mesh.is_isolated(v)) continue;
    const Vector d = (minimal ? form.minimal_principal_direction() : form.maximal_principal_direction()) *
                     (mean_edge_length(mesh, v) / 2);
    lines.push_back({{mesh.point(v) - d, mesh.point(v) + d}, minimal ? 1 : 0, 0, 0});
  }
  return lines;
}

void set_colors(Results& r, const Arguments& a)
{
  r.colors.assign(r.mesh.number_of_vertices(), Color{{216, 210, 200}});
  if (a.color == "none") return;
  const auto q = std::find_if(r.quantities.begin(), r.quantities.end(), [&](const Quantity& quantity) {
    return quantity.name == a.color && quantity.components == 1;
  });
  if (q == r.quantities.end()) throw Usage_error("--color " + a.color + ": there is no such quantity at this degree");
  std::vector<double> values;
  for (std::size_t v = 0; v < r.colors.size(); ++v) values.push_back(q->value(v, 0));
  r.scale = Color_scale(values, a.percentile);
  std::transform(values.begin(), values.end(), r.colors.begin(), r.scale);
}

std::string name_without_slashes(std::string file)
{
  std::replace(file.begin(), file.end(), '/', '_');
  return file;
}

void write_results(Output_files& files, const Results& r, const Arguments& a)
{
  for (const std::string& name : a.outputs)
    files.add(name, [&](std::ostream& out) {
      const std::string format = extension(name);
      if (format == "ply") write_ply(out, r.mesh, r.quantities, r.colors, r.statuses);
      else if (format == "vtp") write_vtp(out, r.mesh, r.quantities, r.colors, r.statuses);
      else write_csv(out, r.mesh, r.quantities, r.statuses);
    });
  const auto write_lines = [&](const std::vector<std::string>& names, const std::vector<Line>& lines) {
    for (const std::string& name : names)
      files.add(name, [&](std::ostream& out) {
        const std::string format = extension(name);
        if (format == "ply") write_ply(out, lines);
        else if (format == "vtp") write_vtp(out, lines);
        else write_obj(out, lines);
      });
  };
  write_lines(a.ridge_outputs, r.ridges.lines);
  write_lines(a.direction_outputs, r.directions);
  const std::string old_name = name_without_slashes(a.input);
  if (!a.names_output())
    files.add(old_name + ".4ogl.txt", [&](std::ostream& out) { write_4ogl(out, r.mesh, r.estimates); });
  if (a.verbose) files.add(old_name + ".verb.txt", [&](std::ostream& out) { write_verbose(out, r.mesh, r.estimates); });
}

// As many of the directions as can be told apart in a picture: no two of them closer than a cell of a grid.
std::vector<Line> directions_in_picture(const Mesh& mesh, const Estimates& estimates, const Arguments& a)
{
  const CGAL::Bbox_3 box = CGAL::bbox_3(mesh.points().begin(), mesh.points().end());
  const double cell = std::hypot(box.x_span(), box.y_span(), box.z_span()) / 70;
  std::map<std::array<long, 3>, std::vector<Point>> taken;
  const auto is_free = [&](const Point& p, const std::array<long, 3>& c) {
    for (long i = -1; i <= 1; ++i)
      for (long j = -1; j <= 1; ++j)
        for (long k = -1; k <= 1; ++k) {
          const auto near = taken.find({c[0] + i, c[1] + j, c[2] + k});
          if (near == taken.end()) continue;
          for (const Point& q : near->second)
            if (CGAL::squared_distance(p, q) < cell * cell) return false;
        }
    return true;
  };
  std::vector<Line> lines;
  for (Line& line : directions(mesh, estimates, a.minimal_directions)) {
    const Point middle = CGAL::midpoint(line.points[0], line.points[1]);
    const std::array<long, 3> c = {std::lround(middle.x() / cell), std::lround(middle.y() / cell),
                                   std::lround(middle.z() / cell)};
    if (!is_free(middle, c)) continue;
    taken[c].push_back(middle);
    const Vector d = line.points[1] - line.points[0], half = d * (0.45 * cell / std::sqrt(d.squared_length()));
    line.points = {middle - half, middle + half};
    lines.push_back(std::move(line));
  }
  return lines;
}

void add_picture(Output_files& files, const Results& r, const Arguments& a)
{
  const std::vector<Line> none,
      segments = a.drawn == Drawn::directions ? directions_in_picture(r.mesh, r.estimates, a) : none;
  const bool has_ridges = a.draws_ridges();
  const Picture picture{r.mesh,
                        r.estimates.forms,
                        r.colors,
                        a.color == "none" ? nullptr : &r.scale,
                        has_ridges ? r.ridges.lines : segments,
                        has_ridges ? ridge_styles() : direction_styles(),
                        a.drawn == Drawn::ridges_and_umbilics ? r.ridges.umbilics : decltype(r.ridges.umbilics)()};
  const auto write_scene = [&](std::ostream& out) { write_picture(out, picture, a); };
  if (extension(a.picture) == "pov") {
    files.add(a.picture, write_scene);
    return;
  }
  Output_files scratch;
  scratch.add(a.picture + ".pov", write_scene);
  files.add_made(a.picture,
                 [&](const std::string& png) { return run_povray(scratch.temporary(), png, a.width, a.height); });
}

void run(const Arguments& a)
{
  Results r;
  std::ostringstream text;
  Summary_table table(text);
  CGAL::Real_timer timer;
  timer.start();
  const auto finish_phase = [&](const char* name) {
    stop_if_interrupted();
    table.add_phase(name, timer.time(), r.mesh.number_of_vertices());
    timer.reset();
  };

  r.mesh = read_input(a.input);
  table.add_surface(a.input, r.mesh);
  if (a.finds_ridges && (is_point_set(r.mesh) || !CGAL::is_triangle_mesh(r.mesh)))
    throw Input_error(a.input, "ridges are found on triangle meshes only");
  const double reading = timer.time();
  timer.reset();
  r.estimates = estimate(r.mesh, a);
  const double fitting = timer.time();
  table.add_fits(r.estimates, a);
  table.add_phase("reading", reading, r.mesh.number_of_vertices());
  table.add_phase("fitting", fitting, r.mesh.number_of_vertices());

  timer.reset();
  r.quantities = quantities(r.estimates, a.degree_monge);
  for (const auto status : r.estimates.statuses) r.statuses.push_back(status.to_integer());
  set_colors(r, a);
  if (a.finds_ridges) {
    r.ridges = find_ridges(r.mesh, r.estimates, a);
    finish_phase("ridges");
  }
  Output_files files;
  if (!a.direction_outputs.empty()) r.directions = directions(r.mesh, r.estimates, a.minimal_directions);
  write_results(files, r, a);
  finish_phase("writing");
  if (!a.picture.empty()) {
    add_picture(files, r, a);
    finish_phase("picture");
  }
  table.add_quantiles(r.quantities, r.estimates.size());
  if (a.finds_ridges) table.add_ridges(r.ridges);
  stop_if_interrupted();
  table.add_files(files.commit());
  if (!a.quiet) std::cout << text.str();
}

} // namespace tool

int main(int argc, char* argv[])
{
  const tool::Command_line command_line;
  const auto fail = [](int code, const std::exception& e) {
    std::cerr << "error: " << e.what() << '\n';
    return code;
  };
  try {
    const auto arguments = command_line.parse(argc, argv);
    if (!arguments) {
      command_line.print_help(std::cout, "Mesh_estimation");
      return EXIT_SUCCESS;
    }
    tool::catch_interrupts();
    tool::run(*arguments);
    return EXIT_SUCCESS;
  } catch (const tool::Usage_error& e) {
    return fail(2, e);
  } catch (const tool::Input_error& e) {
    return fail(2, e);
  } catch (const tool::Interrupted& e) {
    return fail(130, e);
  } catch (const std::exception& e) {
    return fail(1, e);
  }
}
