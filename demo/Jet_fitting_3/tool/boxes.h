// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_BOXES_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_BOXES_H

#include "Box.h"
#include "Input_error.h"
#include "each_point.h"
#include "extension.h"

#include <filesystem>
#include <fstream>
#include <limits>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

// Lists of files of points with the box of each, a line each: xmin ymin zmin xmax ymax zmax, name.
namespace tool {

struct Boxed_file
{
  std::string name;
  Box box; // nothing of the file is outside
};

inline Box box_of_points(const std::string& file)
{
  Box box;
  each_point(file, [&box](const Oriented_point& p) {
    if (is_finite(p.first)) box.add(p.first, 0);
  });
  return box;
}

inline void write_box(std::ostream& out, const std::string& file)
{
  const Box box = box_of_points(file);
  out.precision(17);
  for (const auto* corner : {&box.low, &box.high})
    for (const double c : *corner) out << c << ' ';
  out << file << '\n';
}

// A name is meant in the folder of the list, unless it is absolute. \throw Input_error
inline std::vector<Boxed_file> read_boxes(const std::string& list)
{
  std::ifstream in(list);
  if (!in) throw Input_error(list, "there is no such file, or it may not be read");
  std::vector<Boxed_file> files;
  const std::filesystem::path folder = std::filesystem::path(list).parent_path();
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    Boxed_file file;
    std::string word;
    bool is_complete = true;
    for (auto* corner : {&file.box.low, &file.box.high})
      for (double& c : *corner) {
        is_complete = is_complete && words >> word;
        if (is_complete) c = std::strtod(word.c_str(), nullptr); // of an empty file: infinite
      }
    if (!is_complete || !std::getline(words >> std::ws, file.name))
      throw Input_error(list, "line " + std::to_string(files.size() + 1) + " is not six numbers and a name");
    file.name = (folder / file.name).string();
    files.push_back(file);
  }
  return files;
}

// With the boxes that are known; without one a file may have points anywhere.
inline std::vector<Boxed_file> boxed_files(const std::vector<std::string>& names)
{
  const double everywhere = std::numeric_limits<double>::infinity();
  std::vector<Boxed_file> files;
  for (const std::string& name : names) {
    if (extension(name) == "boxes") {
      const std::vector<Boxed_file> listed = read_boxes(name);
      files.insert(files.end(), listed.begin(), listed.end());
    } else files.push_back({name, {{-everywhere, -everywhere, -everywhere}, {everywhere, everywhere, everywhere}}});
  }
  return files;
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_BOXES_H
