// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXAMPLES_JET_FITTING_3_TOOL_PARSE_H
#define CGAL_EXAMPLES_JET_FITTING_3_TOOL_PARSE_H

#include "Arguments.h"
#include "extension.h"

#include <CGAL/Jet_fitting_3/values/Jet.h>
#include <CGAL/Surface_mesh.h> // data_file_path()

#include <boost/program_options.hpp>

#include <array>
#include <cmath>
#include <initializer_list>
#include <map>
#include <optional>
#include <ostream>
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

inline std::array<double, 3> direction(const po::variables_map& given, const char* option)
{
  std::array<double, 3> d;
  char comma = ',';
  std::istringstream in(given[option].as<std::string>());
  for (std::size_t i = 0; i < 3; ++i) {
    if (i > 0) in >> comma;
    in >> d[i];
    if (!in || comma != ',') throw Usage_error("--" + std::string(option) + " takes three numbers, as in 1,0,0.5");
  }
  return d;
}

using Extensions = std::initializer_list<const char*>;

inline void check_extension(const std::string& option, const std::string& file, const Extensions& formats)
{
  if (is_one_of(extension(file), formats)) return;
  std::string words;
  for (const char* format : formats) words += (words.empty() ? "." : ", .") + std::string(format);
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
    po::options_description general("General"), fit("Fit"), output("Output"), ridges("Ridges and umbilics"),
        picture("Picture");
    // clang-format off
    general.add_options()
      ("help,h", "this page")
      ("input-file,f", file(), "mesh (off, obj, ply, stl, vtp) or points (xyz, pwn, off, ply, las); "
                               "meshes/ellipe0.003.off of CGAL's data unless given")
      ("threads,t", integer(0), "0: all there are")
      ("quiet,q", "no progress bar, no summary");
    fit.add_options()
      ("degree-jet,d", po::value<int>()->value_name("d"), "degree of the jet (2; 4 for ridges)")
      ("degree-monge,m", po::value<int>()->value_name("m"), "degree of the Monge form, at most d (d)")
      ("nb-rings,a", po::value<int>()->value_name("n"),
       "neighbors: n rings; 0: as many rings as the fit needs at least. Without any of these three options: as many "
       "rings as have twice the points that the fit needs; for points: so many nearest ones")
      ("nb-points,p", po::value<int>()->value_name("n"), "neighbors: the n nearest points; 0: no effect")
      ("radius,r", po::value<double>()->value_name("x"), "neighbors: the points within this distance")
      ("sharp-angle", po::value<double>()->value_name("degrees"),
       "neighborhoods do not cross edges at which the normals of the two faces make a larger angle")
      ("weights", word("kind", "unit"), "of the neighbors by their distance: unit, gaussian, wendland, inverse_distance")
      ("robust", word("loss", "none"), "to outliers: none, absolute, huber, cauchy, tukey; needs some five times the "
                                       "points that the fit needs at least")
      ("errors", "standard errors of all coefficients, among the quantities")
      ("no-quality", "neither condition numbers nor residuals, which take half as long as the fits")
      ("lower-degree", "where the points do not suffice for degree d, fit a lower one instead of skipping the vertex");
    output.add_options()
      ("output,o", files(), "all quantities at all vertices, with colors: ply (binary), vtp, csv. Without any output file "
                            "or picture: <input>.4ogl.txt in this folder, a line for each vertex: the vertex, the point of the "
                            "fitted surface, d1 and d2 as segments, k1, k2")
      ("verbose,v", po::value<bool>()->value_name("0|1")->default_value(false),
       "the Monge forms as text too: <input>.verb.txt")
      ("directions", files(), "principal directions as line segments: ply, obj, vtp")
      ("direction", word("max|min", "max"), "which, in files and pictures")
      ("color,c", word("quantity", "H"), "color by k1, k2, H, K, shape_index, curvedness, b0, ..., c4, "
                                         "condition_number, ...; or none")
      ("percentile", number(2, "2"), "the range of colors leaves out this percentage of the vertices at either end");
    ridges.add_options()
      ("ridges", po::value<std::string>()->value_name("kind"), "find ridges: max (of k1), min (of k2), all or crest")
      ("ridge-order", integer(4), "3 or 4: order of the derivatives that tell maxima from minima")
      ("min-length", number(0, "0"), "leave out shorter ridges")
      ("min-strength", number(0, "0"), "and weaker ones: the strength is the integral of the curvature along the line")
      ("min-sharpness", number(0, "0"), "and less sharp ones (order 4)")
      ("significance", number(0, "0"), "leave out what noise may have drawn: a ridge counts where the derivative of the "
                                       "curvature changes its sign by so many standard errors; 2 is a good value")
      ("umbilic-size", number(2, "2"), "umbilics closer to each other than that, in mean edge lengths, become one")
      ("ridges-output", files(), "ridge lines: ply, obj, vtp");
    picture.add_options()
      ("picture", file(), "png, drawn by povray; or pov, the scene alone")
      ("draw", po::value<std::string>()->value_name("what"),
       "nothing, ridges, umbilics (with ridges) or directions; ridges if there are any")
      ("view", word("x,y,z", "0.3,-0.6,0.8"), "direction from the object to the viewer")
      ("up", word("x,y,z", "0,0,1"), "direction that is upwards in the picture")
      ("width", integer(1200), "pixels")
      ("height", integer(900), "pixels");
    // clang-format on
    m_all.add(general).add(fit).add(output).add(ridges).add(picture);
    m_positional.add("input-file", 1);
  }

  // \return nothing if help was asked for. \throw Usage_error
  std::optional<Arguments> parse(int argc, const char* const argv[]) const
  {
    po::variables_map given;
    try {
      po::store(po::command_line_parser(argc, argv).options(m_all).positional(m_positional).run(), given);
    } catch (const po::error& e) {
      // Boost's message replaces %value% and the like, for ever if the word itself contains it.
      for (const std::string& word : std::vector<std::string>(argv + 1, argv + argc))
        if (word.find('%') != word.rfind('%')) throw Usage_error(word + " is not understood");
      throw Usage_error(e.what());
    }
    if (given.count("help") != 0) return {};

    Arguments a;
    a.input = given.count("input-file") != 0 ? given["input-file"].as<std::string>()
                                             : CGAL::data_file_path("meshes/ellipe0.003.off");
    a.quiet = given.count("quiet") != 0;
    a.verbose = given["verbose"].as<bool>();
    a.threads = given["threads"].as<int>();
    if (a.threads < 0) throw Usage_error("--threads must not be negative");
    set_ridges(given, a);
    set_fit(given, a);
    set_output(given, a);
    set_picture(given, a);
    return a;
  }

  void print_help(std::ostream& out, const std::string& program) const
  {
    out << "Usage: " << program << " [options] [mesh or points]\n\n"
        << "Estimates normals, principal curvatures and directions, and derivatives of the curvatures at every vertex "
           "of a\n"
           "mesh or point set, by fitting polynomials to neighboring points; finds ridges and umbilics of meshes.\n\n"
        << "  " << program << " bunny.off -o bunny.ply\n"
        << "      curvatures and directions into one file, vertices colored by mean curvature, for MeshLab or "
           "Blender\n"
        << "  " << program << " bunny.off -d 4 -a 3 --ridges crest --min-strength 1 --ridges-output crests.obj \\\n"
        << "      --picture crests.png --view 0,0,1 --up 0,1,0\n"
        << "      crest lines from fits of degree 4 to three rings, into a file and as a picture\n"
        << "  " << program << " scan.xyz -p 60 --color curvedness -o scan.vtp scan.csv\n"
        << "      the same quantities of a point set, from the 60 nearest points each, for ParaView and a "
           "spreadsheet\n\n"
        << m_all
        << "\nExit code: 0, done; 2, bad arguments or input; 1, any other failure; 130, interrupted by Ctrl-C.\n"
        << "Unless the exit code is 0, no file is written.\n";
  }

private:
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
    a.ridge_options.least_strength = threshold("min-strength");
    a.ridge_options.least_sharpness = threshold("min-sharpness");
    a.ridge_options.significance = threshold("significance");
    a.umbilic_size = threshold("umbilic-size");
  }

  static void set_fit(const po::variables_map& given, Arguments& a)
  {
    const auto degree = [&](const char* option, std::size_t otherwise) {
      return static_cast<std::size_t>(positive<int>(given, option).value_or(static_cast<int>(otherwise)));
    };
    a.degree_jet = degree("degree-jet", a.finds_ridges ? 4 : 2);
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
    if (a.radius && (a.points || a.rings.value_or(0) > 0))
      throw Usage_error("--radius goes neither with --nb-points nor with --nb-rings");
    const std::size_t least = CGAL::Jet_fitting::number_of_jet_coefficients(a.degree_jet);
    if (a.points && static_cast<std::size_t>(*a.points) < least)
      throw Usage_error("--nb-points must be at least " + std::to_string(least) + " for degree " +
                        std::to_string(a.degree_jet));
    a.sharp_angle = positive<double>(given, "sharp-angle");

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
    a.options.report_quality = given.count("no-quality") == 0;
  }

  static void set_output(const po::variables_map& given, Arguments& a)
  {
    const auto files = [&](const char* option, const Extensions& formats) {
      std::vector<std::string> names;
      if (given.count(option) != 0) names = given[option].as<std::vector<std::string>>();
      for (const std::string& name : names) check_extension(option, name, formats);
      return names;
    };
    a.outputs = files("output", {"ply", "vtp", "csv"});
    a.direction_outputs = files("directions", {"ply", "vtp", "obj"});
    a.ridge_outputs = files("ridges-output", {"ply", "vtp", "obj"});
    if (!a.ridge_outputs.empty() && !a.finds_ridges) throw Usage_error("--ridges-output needs --ridges");
    a.minimal_directions = choice<bool>(given, "direction", {{"max", false}, {"min", true}});
    a.color = given["color"].as<std::string>();
    a.percentile = given["percentile"].as<double>();
    if (!(a.percentile >= 0 && a.percentile < 50)) throw Usage_error("--percentile must be in [0, 50)");
  }

  static void set_picture(const po::variables_map& given, Arguments& a)
  {
    if (given.count("picture") != 0) {
      a.picture = given["picture"].as<std::string>();
      check_extension("picture", a.picture, {"png", "pov"});
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
    const std::array<double, 3>&v = a.view, &u = a.up;
    if (!(std::hypot(v[1] * u[2] - v[2] * u[1], v[2] * u[0] - v[0] * u[2], v[0] * u[1] - v[1] * u[0]) > 0))
      throw Usage_error("--view and --up must be two directions, not parallel");
    a.width = *positive<int>(given, "width");
    a.height = *positive<int>(given, "height");
  }

  po::options_description m_all;
  po::positional_options_description m_positional;
};

} // namespace tool

#endif // CGAL_EXAMPLES_JET_FITTING_3_TOOL_PARSE_H
