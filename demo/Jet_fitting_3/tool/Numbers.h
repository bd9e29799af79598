// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_NUMBERS_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_NUMBERS_H

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <system_error>
#include <type_traits>

namespace tool {

// The numbers in a text, and its lines, without those that are blank or comments.
class Numbers
{
public:
  explicit Numbers(const std::string& text) : m_begin(text.data()), m_at(text.data()), m_end(text.data() + text.size())
  {}

  // At the start of the next line, or at the next number, that there is. \return whether there is any
  bool skip_to_content()
  {
    for (; m_at != m_end; ++m_at) {
      if (*m_at == '#') skip_line();
      if (m_at == m_end) return false;
      if (!is_blank(*m_at) && *m_at != '\n') return true;
    }
    return false;
  }

  // Whether there is nothing more in this line.
  bool ends_line()
  {
    while (m_at != m_end && is_blank(*m_at)) ++m_at;
    return m_at == m_end || *m_at == '\n' || *m_at == '#';
  }

  void skip_line() { m_at = std::find(m_at, m_end, '\n'); }

  // The letters and digits up to a blank.
  std::string read_word()
  {
    const char* const begin = m_at;
    while (m_at != m_end && !is_blank(*m_at) && *m_at != '\n') ++m_at;
    return {begin, m_at};
  }

  // Of this line. If there is none, the reader stays where it is.
  template <class Number>
  bool read(Number& number)
  {
    if (ends_line()) return false;
    const char* const begin = m_at;
    if (*m_at == '+' && m_at + 1 != m_end && m_at[1] != '-') ++m_at;
    if (convert(number) && std::isfinite(double(number)) &&
        (m_at == m_end || is_blank(*m_at) || *m_at == '\n' || *m_at == '#'))
      return true;
    m_at = begin;
    m_due = std::is_same<Number, double>::value ? "finite number" : "whole number from 0 on";
    return false;
  }

  // The word that was refused as a number, if any was, and its line. The last one may have been cut short.
  std::string refused()
  {
    const auto line = 1 + std::count(m_begin, m_at, '\n');
    const std::string word = read_word();
    if (m_due == nullptr || m_at == m_end) return "";
    return "line " + std::to_string(line) + ": '" + word + "' is no " + m_due;
  }

private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

  template <class Number>
  bool convert(Number& number)
  {
    const auto [after, error] = std::from_chars(m_at, m_end, number);
    m_at = after;
    return error == std::errc();
  }

#ifndef __cpp_lib_to_chars // from_chars knows integers only
  bool convert(double& number)
  {
    char* after = nullptr;
    number = std::strtod(m_at, &after); // the text ends with a zero
    const bool is_number = after != m_at;
    m_at = after;
    return is_number;
  }
#endif

  const char *m_begin, *m_at, *m_end, *m_due = nullptr; // the last: what a number should have been that was refused
};

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_NUMBERS_H
