// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_PARSE_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_PARSE_H

#include "Arguments.h"
#include "Output_files.h"
#include "extension.h"
#include "help.h"
#include "names.h"

#include <CGAL/Jet_fitting_3/values/Jet.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <ostream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace tool {

namespace po = boost::program_options;

// What is wrong with the command line.
class Usage_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

template <class Value>
Value choice(const po::variables_map& given, const char* option, const std::map<std::string, Value>& choices)
{
  const std::string& word = given[option].as<std::string>();
  const auto found = choices.find(word);
  if (found != choices.end()) return found->second;
  std::string words;
  for (const auto& c : choices) words += (words.empty() ? "" : ", ") + c.first;
  throw Usage_error("--" + std::string(option) + ' ' + word + ": it takes one of " + words);
}

inline std::optional<std::array<double, 3>> direction(const po::variables_map& given, const char* option)
{
  if (given.count(option) == 0) return {};
  const std::string& words = given[option].as<std::string>();
  if (words == "x" || words == "y" || words == "z")
    return std::array<double, 3>{words == "x" ? 1. : 0., words == "y" ? 1. : 0., words == "z" ? 1. : 0.};
  std::array<double, 3> d;
  char comma = ',';
  std::istringstream in(words);
  for (std::size_t i = 0; i < 3; ++i) {
    if (i > 0) in >> comma;
    in >> d[i];
    if (!in || comma != ',') throw Usage_error("--" + std::string(option) + " takes three numbers, as in 1,0,0.5");
  }
  if (!(std::hypot(d[0], d[1], d[2]) > 0) || !std::isfinite(std::hypot(d[0], d[1], d[2])))
    throw Usage_error("--" + std::string(option) + ' ' + words + " is no direction");
  return d;
}

inline bool has_format(const std::string& file, const std::vector<std::string>& formats)
{
  if (std::find(formats.begin(), formats.end(), extension(file)) != formats.end()) return true;
  return is_4ogl(file) && std::find(formats.begin(), formats.end(), "4ogl.txt") != formats.end();
}

inline void check_format(const std::string& option, const std::string& file, const std::vector<std::string>& formats)
{
  if (has_format(file, formats)) return;
  std::string words;
  for (const std::string& format : formats) words += (words.empty() ? "." : ", .") + format;
  throw Usage_error("--" + option + ' ' + file + ": the name must end in one of " + words);
}

template <class Number>
std::optional<Number> positive(const po::variables_map& given, const char* option)
{
  if (given.count(option) == 0) return {};
  const Number n = given[option].as<Number>();
  if (!(n > Number(0))) throw Usage_error("--" + std::string(option) + " must be positive");
  return n;
}

inline bool has_color(const Arguments& a)
{
  const std::vector<Name> names = names_of_numbers(a);
  return a.color == "none" ||
         std::any_of(names.begin(), names.end(), [&](const Name& name) { return name.symbol == a.color; });
}

// Once it is known how the fits are made. \throw Usage_error
inline void check_color(const Arguments& a)
{
  if (has_color(a)) return;
  std::string words;
  for (const Name& name : names_of_numbers(a)) words += name.symbol + ", ";
  throw Usage_error("--color " + a.color + ": with these options it takes one of " + words + "none");
}

class Command_line
{
public:
  Command_line()
  {
    const auto files = [] { return po::value<std::vector<std::string>>()->multitoken()->value_name("file..."); };
    const auto file = [] { return po::value<std::string>()->value_name("file"); };
    const auto word = [](const char* words, const char* otherwise) {
      return po::value<std::string>()->value_name(words)->default_value(otherwise);
    };
    const auto number = [](double otherwise, const char* text) {
      return po::value<double>()->value_name("x")->default_value(otherwise, text);
    };
    const auto integer = [](int otherwise) { return po::value<int>()->value_name("n")->default_value(otherwise); };
    po::options_description general, fit, output, ridges, picture;
    const std::string degree_text =
        "degree of the jet. Without -d, -a, -p and -r, degree and neighbors are chosen for each vertex from the data, "
        "up to " +
        std::to_string(most_vertices_for_automatic) + " vertices or " + std::to_string(most_points_for_automatic) +
        " points with forms of degree 2: that takes up to .3 ms a vertex, 1 ms a point. Otherwise the fixed choice is "
        "made, which takes microseconds: degree 2, or m, or 4 for ridges. -d 2 asks for it";
    // clang-format off
    general.add_options()
      ("help,h", "this page")
      ("manual-page", "the same for man: Mesh_estimation.1 is made by it")
      ("input-file,f", file(), "mesh (off, obj, ply, stl, vtp) or points (xyz, pwn, off, ply, las)")
      ("context", files(),
       "the points are a tile of a larger set, and these are the others: xyz, pwn, ply, las, or lists made by --box. "
       "They are neighbors but not estimated, so that tiles have the same results as the whole. It needs -p or -r")
      ("box", "print the box of the points as a line of a list for --context (*.boxes), which spares reading files "
              "that are far away: xmin ymin zmin xmax ymax zmax name; and end")
      ("threads,t", integer(0), "0: all there are")
      ("quiet,q", "no progress, no summary");
    fit.add_options()
      ("degree-jet,d", po::value<int>()->value_name("d"), degree_text.c_str())
      ("degree-monge,m", po::value<int>()->value_name("m"), "degree of the Monge form, at most d (d)")
      ("nb-rings,a", po::value<int>()->value_name("n"),
       "neighbors: n rings; 0: as many rings as the fit needs at least. With -d alone: as many rings as have twice the "
       "points that the fit needs; for points: five times as many nearest ones")
      ("nb-points,p", po::value<int>()->value_name("n"), "neighbors: the n nearest points; 0: no effect")
      ("radius,r", po::value<double>()->value_name("x"), "neighbors: the points within this distance")
      ("automatic", "choose degree and neighbors for each vertex from the data, however many there are")
      ("sharp-angle", po::value<std::string>()->value_name("degrees|auto"),
       "for CAD parts: edges at which the normals of the two faces make a larger angle (auto: 40) are sharp. The "
       "surface is cut open there: each side has forms, normals and colors of its own, and the edges are drawn")
      ("flip", "turn the surface inside out: all normals, and the signs of curvatures")
      ("no-orient", "points without normals: leave their orientations as they are, instead of making neighbors agree")
      ("weights", word("kind", "unit"),
       "of the neighbors by their distance: unit, gaussian, wendland, inverse_distance")
      ("robust", word("loss", "none"), "to outliers, where radius and degree are given: none, absolute, huber, cauchy, "
                                       "tukey; needs some five times the points that the fit needs at least")
      ("keep-outliers", "where radius and degree are not given, outliers are left out: no, they are data like others")
      ("cross-sharp-edges", "where radius and degree are not given, neighborhoods end at sharp edges that are found: "
                            "no, they go across")
      ("errors", "standard errors of all coefficients, among the quantities")
      ("no-quality", "neither condition numbers nor residuals, which take half as long as the fits; ridges need them")
      ("lower-degree", "where the points do not suffice for degree d, fit a lower one instead of skipping the vertex");
    output.add_options()
      ("output,o", files(),
       "all quantities at all vertices, with colors: ply (binary), vtp, csv; or 4ogl.txt, CGAL's file with a line for "
       "each vertex: the vertex, the point of the fitted surface, d1 and d2 as segments, k1, k2. Without any output "
       "file or picture: <name of the input>.ply in this folder")
      ("verbose,v", po::value<bool>()->value_name("0|1")->default_value(false),
       "the Monge forms as text too: <name of the input>.verb.txt")
      ("directions", files(), "principal directions as line segments: ply, obj, vtp")
      ("direction", word("max|min", "max"), "which, in files and pictures")
      ("color,c", po::value<std::string>()->value_name("quantity"),
       "color by k1, k2, H, K, shape_index, curvedness, b0, ..., c4, radius, condition_number, ...; or none. H, but "
       "none where "
       "ridges are drawn")
      ("percentile", number(2, "2"), "the range of colors leaves out this percentage of the vertices at either end");
    ridges.add_options()
      ("ridges", po::value<std::string>()->value_name("kind"), "find ridges: max (of k1), min (of k2), all or crest")
      ("ridge-order", integer(4), "3 or 4: order of the derivatives that tell maxima from minima")
      ("min-length", number(0, "0"), "leave out shorter ridges")
      ("min-strength", po::value<double>()->value_name("x"),
       "and weaker ones: the strength is the integral of the curvature along the line, a number without a unit (3 for "
       "crests, 0 for the other kinds)")
      ("min-sharpness", number(0, "0"), "and less sharp ones (order 4)")
      ("significance", number(0, "0"),
       "leave out what noise may have drawn: a ridge counts where the derivative of the curvature changes its sign by "
       "so many standard errors; 2 is a good value")
      ("umbilic-size", number(2, "2"), "umbilics closer to each other than that, in mean edge lengths, become one")
      ("ridges-output", files(), "ridge lines, without the zigzag of the edges: ply, obj, vtp");
    picture.add_options()
      ("picture", file(), "png, drawn by povray; or pov, the scene alone")
      ("draw", po::value<std::string>()->value_name("what"),
       "nothing, ridges, umbilics (with ridges) or directions; ridges if there are any")
      ("view", po::value<std::string>()->value_name("x,y,z"),
       "direction from the object to the viewer; by the shape if not given")
      ("up", po::value<std::string>()->value_name("x,y,z"),
       "direction that is upwards in the picture: x, y, z, or three numbers; y or z by the shape if not given")
      ("width", integer(1200), "pixels")
      ("height", integer(900), "pixels");
    // clang-format on
    m_groups.push_back({"General", general});
    m_groups.push_back({"Fit", fit});
    m_groups.push_back({"Output", output});
    m_groups.push_back({"Ridges and umbilics", ridges});
    m_groups.push_back({"Picture", picture});
    for (const Option_group& group : m_groups) m_all.add(group.options);
    m_positional.add("input-file", 1);
  }

  // \throw Usage_error
  Arguments parse(int argc, const char* const argv[]) const
  {
    po::variables_map given;
    try {
      po::parsed_options parsed = po::command_line_parser(argc, argv).options(m_all).positional(m_positional).run();
      take_input_from_outputs(parsed);
      po::store(parsed, given);
    } catch (const po::error& e) {
      // Boost's message replaces %value% and the like, for ever if the word itself contains it.
      for (const std::string& word : std::vector<std::string>(argv + 1, argv + argc))
        if (word.find('%') != word.rfind('%')) throw Usage_error(word + " is not understood");
      throw Usage_error(e.what());
    }
    Arguments a;
    if (given.count("help") != 0) a.page = Page::help;
    if (given.count("manual-page") != 0) a.page = Page::manual;
    if (a.page != Page::none) return a;
    if (given.count("input-file") == 0) throw Usage_error("which mesh, or which points? --help tells the usage");
    a.input = given["input-file"].as<std::string>();
    if (given.count("box") != 0) a.page = Page::box;
    if (a.page != Page::none) return a;
    a.quiet = given.count("quiet") != 0;
    a.threads = given["threads"].as<int>();
    if (a.threads < 0) throw Usage_error("--threads must not be negative");
    set_ridges(given, a);
    set_fit(given, a);
    set_context(given, a);
    set_output(given, a);
    set_picture(given, a);
    set_default_outputs(given, a);
    return a;
  }

  const Option_groups& groups() const { return m_groups; }

private:
  // Options that take several files also take the input, if it comes last: -o a.ply b.off.
  static void take_input_from_outputs(po::parsed_options& parsed)
  {
    for (const auto& option : parsed.options)
      if (option.string_key == "input-file") return;
    for (auto option = parsed.options.rbegin(); option != parsed.options.rend(); ++option) {
      if (!is_one_of(option->string_key, {"output", "directions", "ridges-output"}) || option->value.size() < 2)
        continue;
      const std::string last = option->value.back();
      std::error_code error;
      if (has_format(last, formats_of(option->string_key)) && !std::filesystem::is_regular_file(last, error)) continue;
      option->value.pop_back();
      parsed.options.push_back(po::option("input-file", {last}));
      return;
    }
  }

  static std::vector<std::string> formats_of(const std::string& option)
  {
    if (option == "output") return {"ply", "vtp", "csv", "4ogl.txt"};
    return {"ply", "vtp", "obj"};
  }

  static void set_ridges(const po::variables_map& given, Arguments& a)
  {
    using CGAL::Jet_fitting::Ridge_selection;
    a.finds_ridges = given.count("ridges") != 0;
    if (a.finds_ridges)
      a.ridge_options.lines = choice<Ridge_selection>(given, "ridges",
                                                      {{"all", Ridge_selection::max_and_min},
                                                       {"max", Ridge_selection::max},
                                                       {"min", Ridge_selection::min},
                                                       {"crest", Ridge_selection::crest}});
    a.ridge_options.order = given["ridge-order"].as<int>();
    if (a.ridge_options.order != 3 && a.ridge_options.order != 4) throw Usage_error("--ridge-order must be 3 or 4");
    const auto threshold = [&](const char* option) {
      const double x = given[option].as<double>();
      if (!(x >= 0)) throw Usage_error("--" + std::string(option) + " must not be negative");
      return x;
    };
    a.ridge_options.least_length = threshold("min-length");
    if (given.count("min-strength") != 0) a.ridge_options.least_strength = threshold("min-strength");
    else if (a.ridge_options.lines == Ridge_selection::crest) a.ridge_options.least_strength = 3;
    a.ridge_options.least_sharpness = threshold("min-sharpness");
    a.ridge_options.significance = threshold("significance");
    a.umbilic_size = threshold("umbilic-size");
  }

  static void set_fit(const po::variables_map& given, Arguments& a)
  {
    const auto degree = [&](const char* option, std::size_t otherwise) {
      return static_cast<std::size_t>(positive<int>(given, option).value_or(static_cast<int>(otherwise)));
    };
    const auto is_given = [&given](const char* option) { return given.count(option) != 0; };
    a.leaves_choice = !is_given("degree-jet") && !is_given("nb-rings") && !is_given("nb-points") && !is_given("radius");
    a.chooses_at_any_size = is_given("automatic");
    if (a.chooses_at_any_size && !a.leaves_choice)
      throw Usage_error("--automatic chooses what -d, -a, -p and -r give: it goes with none of them");
    a.degree_jet = degree("degree-jet", (std::max)(degree("degree-monge", 2), std::size_t(a.finds_ridges ? 4 : 2)));
    a.degree_monge = degree("degree-monge", a.degree_jet);
    if (a.degree_monge > a.degree_jet) throw Usage_error("--degree-monge must not exceed --degree-jet");
    if (a.finds_ridges && a.degree_monge < static_cast<std::size_t>(a.ridge_options.order))
      throw Usage_error("ridges of order " + std::to_string(a.ridge_options.order) +
                        " need a Monge form of that degree");

    if (given.count("nb-rings") != 0) a.rings = given["nb-rings"].as<int>();
    if (given.count("nb-points") != 0 && given["nb-points"].as<int>() != 0)
      a.points = positive<int>(given, "nb-points");
    a.radius = positive<double>(given, "radius");
    if (a.rings && *a.rings < 0) throw Usage_error("--nb-rings must not be negative");
    if (a.points && a.rings.value_or(0) > 0) throw Usage_error("--nb-points does not go with --nb-rings");
    if (a.radius && (a.points || a.rings.value_or(0) > 0))
      throw Usage_error("--radius goes neither with --nb-points nor with --nb-rings");
    const std::size_t least = CGAL::Jet_fitting::number_of_jet_coefficients(a.degree_jet);
    if (a.points && static_cast<std::size_t>(*a.points) < least)
      throw Usage_error("--nb-points must be at least " + std::to_string(least) + " for degree " +
                        std::to_string(a.degree_jet));
    set_sharp_angle(given, a);
    a.flips = given.count("flip") != 0;
    a.orients_points = given.count("no-orient") == 0;

    using CGAL::Jet_fitting::Loss;
    using CGAL::Jet_fitting::Weighting;
    a.options.weighting = choice<Weighting>(given, "weights",
                                            {{"unit", Weighting::unit},
                                             {"gaussian", Weighting::gaussian},
                                             {"wendland", Weighting::wendland},
                                             {"inverse_distance", Weighting::inverse_distance}});
    a.options.loss = choice<Loss>(given, "robust",
                                  {{"none", Loss::least_squares},
                                   {"absolute", Loss::least_absolute},
                                   {"huber", Loss::huber},
                                   {"cauchy", Loss::cauchy},
                                   {"tukey", Loss::tukey}});
    a.options.standard_errors = given.count("errors") != 0 || a.ridge_options.significance > 0;
    a.options.lower_degree = given.count("lower-degree") != 0;
    a.options.keep_outliers = given.count("keep-outliers") != 0;
    a.options.cross_sharp_edges = given.count("cross-sharp-edges") != 0;
    a.options.report_quality = given.count("no-quality") == 0 || a.finds_ridges; // which tells zeros by it
  }

  static void set_context(const po::variables_map& given, Arguments& a)
  {
    if (given.count("context") == 0) return;
    a.context = given["context"].as<std::vector<std::string>>();
    if (!a.points && !a.radius)
      throw Usage_error(
          "--context needs --nb-points or --radius: how far other neighborhoods reach depends on the whole");
  }

  static void set_sharp_angle(const po::variables_map& given, Arguments& a)
  {
    if (given.count("sharp-angle") == 0) return;
    constexpr double otherwise = 40;
    const std::string& word = given["sharp-angle"].as<std::string>();
    char* end = nullptr;
    a.sharp_angle = word == "auto" ? otherwise : std::strtod(word.c_str(), &end);
    if ((end != nullptr && (end == word.c_str() || *end != 0)) || !(*a.sharp_angle > 0 && *a.sharp_angle <= 180))
      throw Usage_error("--sharp-angle " + word + ": it takes an angle in degrees, above 0 and up to 180, or auto");
  }

  static void set_output(const po::variables_map& given, Arguments& a)
  {
    const auto files = [&](const char* option) {
      std::vector<std::string> names;
      if (given.count(option) != 0) names = given[option].as<std::vector<std::string>>();
      for (const std::string& name : names) check_format(option, name, formats_of(option));
      return names;
    };
    a.outputs = files("output");
    a.direction_outputs = files("directions");
    a.ridge_outputs = files("ridges-output");
    if (!a.ridge_outputs.empty() && !a.finds_ridges) throw Usage_error("--ridges-output needs --ridges");
    a.minimal_directions = choice<bool>(given, "direction", {{"max", false}, {"min", true}});
    if (given.count("color") != 0) a.color = given["color"].as<std::string>();
    else if (a.finds_ridges || a.degree_monge < 2) a.color = "none";
    Arguments automatic = a; // before it is known whether the input allows for it
    automatic.is_automatic = a.leaves_choice;
    if (!has_color(a)) check_color(automatic);
    a.percentile = given["percentile"].as<double>();
    if (!(a.percentile >= 0 && a.percentile < 50)) throw Usage_error("--percentile must be in [0, 50)");
  }

  // The files that are written by default, and a word for names that occur twice.
  static void set_default_outputs(const po::variables_map& given, Arguments& a)
  {
    const std::string stem = std::filesystem::path(a.input).stem().string();
    if (given["verbose"].as<bool>()) a.verbose_output = stem + ".verb.txt";
    if (a.outputs.empty() && a.ridge_outputs.empty() && a.direction_outputs.empty() && a.picture.empty()) {
      a.outputs = {default_output(a.input)};
      if (a.finds_ridges) a.ridge_outputs = {stem + "_ridges.vtp"};
    }
    std::set<std::filesystem::path> files = {file_behind(a.input)};
    for (const std::string& name : a.written_files())
      if (!files.insert(file_behind(name)).second)
        throw Usage_error(name + (file_behind(name) == file_behind(a.input) ? " is the input and an output"
                                                                            : " is named twice as an output"));
  }

  // A PLY file named after the input, unless this would replace a file that is not of this program.
  static std::string default_output(const std::string& input)
  {
    const std::string stem = std::filesystem::path(input).stem().string();
    if (file_behind(stem + ".ply") == file_behind(input)) return stem + "_curvatures.ply";
    std::ifstream in(stem + ".ply", std::ios::binary);
    std::string line;
    for (int i = 0; i < 3; ++i) std::getline(in, line);
    return !in.is_open() || line == made_by ? stem + ".ply" : stem + "_curvatures.ply";
  }

  static void set_picture(const po::variables_map& given, Arguments& a)
  {
    if (given.count("picture") != 0) {
      a.picture = given["picture"].as<std::string>();
      check_format("picture", a.picture, {"png", "pov"});
    }
    a.drawn = a.finds_ridges ? Drawn::ridges : Drawn::nothing;
    if (given.count("draw") != 0)
      a.drawn = choice<Drawn>(given, "draw",
                              {{"nothing", Drawn::nothing},
                               {"ridges", Drawn::ridges},
                               {"umbilics", Drawn::ridges_and_umbilics},
                               {"directions", Drawn::directions}});
    if (a.draws_ridges() && !a.finds_ridges) throw Usage_error("--draw ridges and --draw umbilics need --ridges");
    a.view = direction(given, "view");
    a.up = direction(given, "up");
    if (a.view && a.up) {
      const std::array<double, 3>&v = *a.view, &u = *a.up;
      if (!(std::hypot(v[1] * u[2] - v[2] * u[1], v[2] * u[0] - v[0] * u[2], v[0] * u[1] - v[1] * u[0]) > 0))
        throw Usage_error("--view and --up must be two directions, not parallel");
    }
    a.width = *positive<int>(given, "width");
    a.height = *positive<int>(given, "height");
  }

  Option_groups m_groups;
  po::options_description m_all;
  po::positional_options_description m_positional;
};

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_PARSE_H
