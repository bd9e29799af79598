// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_EXTENSION_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_EXTENSION_H

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <string>

namespace tool {

// The letters behind the last dot, in lower case.
inline std::string extension(const std::string& file)
{
  const std::size_t dot = file.find_last_of("./");
  if (dot == std::string::npos || file[dot] != '.') return "";
  std::string letters = file.substr(dot + 1);
  std::transform(letters.begin(), letters.end(), letters.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return letters;
}

// CGAL's text for its viewer of principal directions.
inline bool is_4ogl(const std::string& file)
{
  const std::string end = ".4ogl.txt";
  return file.size() > end.size() && file.compare(file.size() - end.size(), end.size(), end) == 0;
}

inline bool is_one_of(const std::string& word, std::initializer_list<const char*> words)
{
  return std::find(words.begin(), words.end(), word) != words.end();
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_EXTENSION_H
