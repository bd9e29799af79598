// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_HELP_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_HELP_H

#include <boost/program_options.hpp>

#include <ostream>
#include <string>
#include <vector>

namespace tool {

inline constexpr char program_name[] = "Mesh_estimation";
inline constexpr char what_it_is[] = "curvatures, ridges and umbilics of a mesh or point set";
inline constexpr char what_it_does[] =
    "Estimates normals, principal curvatures and directions, and derivatives of the curvatures at every vertex of a\n"
    "mesh or point set, by fitting polynomials to neighboring points; finds ridges and umbilics of meshes.";
inline constexpr char exit_codes[] = "0, done; 2, bad arguments or input; 1, any other failure; 130, interrupted.\n"
                                     "Unless the exit code is 0, no file is written.";

struct Usage_example
{
  std::string arguments, meaning;
};

inline const std::vector<Usage_example>& usage_examples()
{
  static const std::vector<Usage_example> examples = {
      {"bunny.off -o bunny.ply",
       "curvatures and directions into one file, vertices colored by mean curvature, for MeshLab or Blender"},
      {"bunny.off -d 4 -a 3 --ridges crest --min-strength 3 --ridges-output crests.obj --picture crests.png",
       "crest lines from fits of degree 4 to three rings, into a file and as a picture"},
      {"scan.xyz -p 60 --color curvedness -o scan.vtp scan.csv",
       "the same quantities of a point set, from the 60 nearest points each, for ParaView and a spreadsheet"}};
  return examples;
}

struct Option_group
{
  std::string title;
  boost::program_options::options_description options;
};

using Option_groups = std::vector<Option_group>;

inline void print_help(std::ostream& out, const Option_groups& groups)
{
  out << "Usage: " << program_name << " [options] <mesh or points>\n\n" << what_it_does << "\n\n";
  for (const Usage_example& example : usage_examples())
    out << "  " << program_name << ' ' << example.arguments << "\n      " << example.meaning << '\n';
  for (const Option_group& group : groups) out << '\n' << group.title << ":\n" << group.options;
  out << "\nExit code: " << exit_codes << '\n';
}

// A text as roff takes it: blanks and dashes as they are, no line taken for a request.
inline std::string roff(const std::string& text)
{
  std::string escaped;
  for (const char c : text) {
    if (c == '\\') escaped += "\\e";
    else if (c == '-') escaped += "\\-";
    else if (c == '.' || c == '\'') escaped += std::string("\\&") + c;
    else escaped += c;
  }
  return escaped;
}

// The page of the manual, for man(1).
inline void print_manual_page(std::ostream& out, const Option_groups& groups)
{
  namespace style = boost::program_options::command_line_style;
  out << ".TH " << program_name << " 1\n.SH NAME\n"
      << program_name << " \\- " << roff(what_it_is) << "\n.SH SYNOPSIS\n.B " << program_name
      << "\n[options] <mesh or points>\n.SH DESCRIPTION\n"
      << roff(what_it_does) << "\n.SH OPTIONS\n";
  for (const Option_group& group : groups) {
    out << ".SS " << roff(group.title) << '\n';
    for (const auto& option : group.options.options()) {
      const std::string long_name = option->canonical_display_name(style::allow_long);
      const std::string short_name = option->canonical_display_name(style::allow_dash_for_short);
      out << ".TP\n\\fB" << (short_name[0] == '-' ? roff(short_name) + "\\fR, \\fB" : "") << roff(long_name) << "\\fR "
          << roff(option->format_parameter()) << '\n'
          << roff(option->description()) << '\n';
    }
  }
  out << ".SH EXAMPLES\n";
  for (const Usage_example& example : usage_examples())
    out << ".TP\n\\fB" << program_name << ' ' << roff(example.arguments) << "\\fR\n" << roff(example.meaning) << '\n';
  out << ".SH EXIT STATUS\n" << roff(exit_codes) << '\n';
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_HELP_H
