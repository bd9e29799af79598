// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Differential quantities, ridges and umbilics of a mesh or a point set, from a file into files and pictures.

#include "tool/Arguments.h"
#include "tool/Colors.h"
#include "tool/Output_files.h"
#include "tool/Phases.h"
#include "tool/Picture.h"
#include "tool/Quantities.h"
#include "tool/Summary_table.h"
#include "tool/boxes.h"
#include "tool/describe.h"
#include "tool/directions.h"
#include "tool/estimate_by_choice.h"
#include "tool/find_ridges.h"
#include "tool/help.h"
#include "tool/hint_of_sharp_edges.h"
#include "tool/interrupt.h"
#include "tool/orient_points.h"
#include "tool/parse.h"
#include "tool/read_context.h"
#include "tool/read_input.h"
#include "tool/run_povray.h"
#include "tool/sharp_edges.h"
#include "tool/write_ply.h"
#include "tool/write_text.h"
#include "tool/write_vtp.h"

#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tool {

// The forms and all that follows from them.
struct Results
{
  Mesh mesh;
  Context context;
  Edge_marks is_sharp; // of the edges that the file has
  std::vector<Line> sharp_edges;
  std::vector<std::string> remarks; // sentences for the user
  Estimates estimates;
  std::vector<Quantity> quantities;
  const Quantity* colored = nullptr; // one of them, or none
  Ridges_and_umbilics ridges;
  std::vector<Line> directions;
  Color_scale scale;
  std::vector<Color> colors;
  std::vector<std::uint16_t> statuses;
};

// Estimates across sharp edges and at borders are not to set the range of the colors: those of one thin part would
// bleach all the rest. If there are no others, they do.
std::vector<double> values_for_range(const std::vector<double>& values, const Estimates& estimates)
{
  using Flag = CGAL::Jet_fitting::Status_flag;
  std::vector<double> reliable;
  for (std::size_t v = 0; v < values.size(); ++v) {
    const auto status = estimates.statuses[v];
    if (status.is_estimated() && !status.has(Flag::pca_ambiguous) && !status.has(Flag::one_sided))
      reliable.push_back(values[v]);
  }
  return reliable.empty() ? values : reliable;
}

void set_colors(Results& r, const Arguments& a)
{
  r.colors.assign(r.mesh.number_of_vertices(), Color{{216, 210, 200}});
  const auto q = std::find_if(r.quantities.begin(), r.quantities.end(),
                              [&](const Quantity& quantity) { return quantity.name.symbol == a.color; });
  if (q == r.quantities.end()) return;
  r.colored = &*q;
  std::vector<double> values;
  for (std::size_t v = 0; v < r.colors.size(); ++v) values.push_back(q->value(v, 0));
  r.scale = Color_scale(values, values_for_range(values, r.estimates), a.percentile);
  std::transform(values.begin(), values.end(), r.colors.begin(), r.scale);
}

void write_results(Output_files& files, const Results& r, const Arguments& a)
{
  Vertex_table table{r.mesh, r.quantities, r.colored, r.colors, r.statuses, {}};
  table.description = describe(a, r.colored != nullptr ? &r.colored->name : nullptr);
  table.description.insert(table.description.end(), r.remarks.begin(), r.remarks.end());
  for (const std::string& name : a.outputs)
    files.add(name, [&](std::ostream& out) {
      const std::string format = extension(name);
      if (format == "ply") write_ply(out, table);
      else if (format == "vtp") write_vtp(out, table);
      else if (format == "csv") write_csv(out, table);
      else write_4ogl(out, r.mesh, r.estimates);
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
  if (!a.verbose_output.empty())
    files.add(a.verbose_output, [&](std::ostream& out) { write_verbose(out, r.mesh, r.estimates); });
}

void add_picture(Output_files& files, const Results& r, const Arguments& a)
{
  std::vector<Line> lines = r.sharp_edges;
  if (a.drawn == Drawn::directions) lines = directions_in_picture(r.mesh, r.estimates, a);
  if (a.draws_ridges()) lines.insert(lines.end(), r.ridges.lines.begin(), r.ridges.lines.end());
  const Picture picture{r.mesh,
                        r.estimates.forms,
                        r.colors,
                        r.colored != nullptr ? &r.colored->name : nullptr,
                        r.scale,
                        lines,
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

// What only the input tells about the arguments. \throw Usage_error, Input_error
void check_arguments(const Arguments& a, const Mesh& mesh)
{
  if (a.finds_ridges && (is_point_set(mesh) || !CGAL::is_triangle_mesh(mesh)))
    throw Input_error(a.input, "ridges are found on triangle meshes only");
  if (!is_point_set(mesh) && !a.context.empty())
    throw Usage_error("--context: " + a.input + " is a mesh; points only have a context");
  if (!is_point_set(mesh)) return;
  if (a.rings)
    throw Usage_error("--nb-rings: " + a.input +
                      " is a point set, which has no rings; --nb-points takes the nearest ones");
  if (a.sharp_angle) throw Usage_error("--sharp-angle: " + a.input + " is a point set, which has no edges");
}

void flip(Mesh& mesh, bool has_normals)
{
  CGAL::Polygon_mesh_processing::reverse_face_orientations(mesh);
  if (!has_normals) return;
  auto normals = map_in(mesh.property_map<Vertex, Vector>(normals_of_points));
  for (Vertex v : mesh.vertices()) normals[v] = -normals[v];
}

void check_estimated(const Estimates& estimates, const Arguments& a)
{
  using Flag = CGAL::Jet_fitting::Status_flag;
  if (estimates.count(Flag::estimated) > 0) return;
  std::ostringstream reasons;
  for (const Flag flag : {Flag::isolated, Flag::not_finite, Flag::too_few_points, Flag::rank_deficient})
    if (const std::size_t count = estimates.count(flag))
      reasons << (reasons.str().empty() ? "" : "; ") << count << ' ' << CGAL::Jet_fitting::Estimation_status(flag)
              << ": " << advice(flag);
  throw std::runtime_error(a.input + ": nothing could be estimated, no file was written. " + reasons.str());
}

// Signs of curvatures are arbitrary where points come without normals: \return what was done about it
std::string orient(Results& r, const Arguments& a)
{
  const std::size_t without = number_without_normal(r.mesh), all_points = r.mesh.number_of_vertices();
  const std::string no_normals = without == all_points
                                     ? "the points have no normals: "
                                     : std::to_string(without) + " of " + std::to_string(all_points) +
                                           " points have no normal, and those of the others orient but are not data: ";
  if (!a.orients_points) return no_normals + "their signs of k1, k2 and H are arbitrary from point to point";
  const std::size_t oriented = orient_points(r.mesh, r.estimates, a.flips);
  std::string text = no_normals + "they were oriented like their neighbors";
  if (without == all_points) text += ", upwards at the top (--flip turns all over)";
  if (const std::size_t all = r.estimates.count(CGAL::Jet_fitting::Status_flag::estimated); oriented < all)
    text +=
        "; " + std::to_string(all - oriented) + " points were not reached, their signs of k1, k2 and H are arbitrary";
  return text;
}

// The surface and its sharp edges; what is odd about it goes into the summary. \return whether it has normals of its
// own
bool read_surface(Results& r, Arguments& a, Summary_table& table)
{
  Input input = read_input(a.input);
  check_arguments(a, input.mesh);
  table.add_surface(a.input, input.mesh);
  r.remarks = input.remarks;
  if (a.flips) flip(input.mesh, is_point_set(input.mesh) || input.has_normals);
  r.mesh = std::move(input.mesh);
  a.of_points = is_point_set(r.mesh);
  r.is_sharp = a.sharp_angle ? sharp_edges(r.mesh, *a.sharp_angle) : Edge_marks(r.mesh.number_of_edges(), 0);
  r.sharp_edges = marked_edges(r.mesh, r.is_sharp, sharp_edge_line);
  return input.has_normals;
}

// The points around a tile of a larger set. What is done from point to point across the whole set is refused.
void read_context(Results& r, const Arguments& a, bool has_normals)
{
  if (!has_normals && a.orients_points)
    throw Usage_error("--context: points of " + a.input +
                      " have no normals, and are not oriented tile by tile; --no-orient leaves them as they are");
  Read_context read = read_context(r.mesh, a);
  r.context = std::move(read.points);
  r.remarks.push_back("a tile: " + std::to_string(r.context.size()) + " points around it, of " +
                      std::to_string(read.all_points) + " in " + std::to_string(read.files) +
                      " files that were read, may be neighbors of its own");
}

void estimate_all(Results& r, Arguments& a, bool has_normals, Phases& phases)
{
  phases.begin("fitting");
  r.estimates = estimate(r.mesh, r.is_sharp, r.context, has_normals, a, r.remarks,
                         [&phases](double fraction) { phases.show(fraction); });
  check_color(a);
  if (a.is_automatic && !a.of_points && !a.sharp_angle) // others have a status that tells
    if (const std::string hint = hint_of_sharp_edges(r.mesh); !hint.empty()) r.remarks.push_back(hint);
  if (a.sharp_angle) r.mesh = split_at(r.mesh, r.estimates.sides, r.estimates.size());
  check_estimated(r.estimates, a);
  if (is_point_set(r.mesh) && !has_normals) {
    phases.begin("orienting");
    r.remarks.push_back(orient(r, a));
  }
  if (a.finds_ridges) {
    phases.begin("ridges");
    r.ridges = find_ridges(r.mesh, r.estimates, a);
  }
  r.quantities = quantities(r.estimates, a);
  for (const auto status : r.estimates.statuses) r.statuses.push_back(status.to_integer());
  set_colors(r, a);
  if (!a.direction_outputs.empty()) r.directions = directions(r.mesh, r.estimates, a.minimal_directions);
}

void run(Arguments a)
{
  Results r;
  std::ostringstream text;
  Summary_table table(text);
  Phases phases(a.quiet);
  phases.begin("reading");
  const bool has_normals = read_surface(r, a, table);
  if (!a.context.empty()) {
    phases.begin("context");
    read_context(r, a, has_normals);
  }
  const std::size_t vertices = r.mesh.number_of_vertices();
  estimate_all(r, a, has_normals, phases);
  if (a.sharp_angle)
    table.add_sharp_edges(r.sharp_edges.size(), *a.sharp_angle, r.mesh.number_of_vertices() - vertices);
  for (const std::string& remark : r.remarks) table.add_remark(remark);
  table.add_fits(r.estimates, a);

  Output_files files;
  phases.begin("writing");
  write_results(files, r, a);
  if (!a.picture.empty()) {
    phases.begin("drawing");
    add_picture(files, r, a);
  }
  table.add_quantiles(r.quantities, r.estimates.size());
  if (a.finds_ridges) table.add_ridges(r.ridges);
  for (const auto& [phase, seconds] : phases.finish()) table.add_phase(phase, seconds, r.mesh.number_of_vertices());
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
    const tool::Arguments arguments = command_line.parse(argc, argv);
    if (arguments.page == tool::Page::help) tool::print_help(std::cout, command_line.groups());
    else if (arguments.page == tool::Page::manual) tool::print_manual_page(std::cout, command_line.groups());
    else if (arguments.page == tool::Page::box) tool::write_box(std::cout, arguments.input);
    if (arguments.page != tool::Page::none) return EXIT_SUCCESS;
    tool::catch_interrupts();
    tool::run(arguments);
    return EXIT_SUCCESS;
  } catch (const tool::Usage_error& e) {
    return fail(2, e);
  } catch (const tool::Input_error& e) {
    return fail(2, e);
  } catch (const CGAL::Jet_fitting::Invalid_input& e) {
    return fail(2, e);
  } catch (const tool::Interrupted& e) {
    return fail(e.exit_code(), e);
  } catch (const std::exception& e) {
    return fail(1, e);
  }
}
