// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXAMPLES_JET_FITTING_3_TOOL_PROGRESS_BAR_H
#define CGAL_EXAMPLES_JET_FITTING_3_TOOL_PROGRESS_BAR_H

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <string>
#include <utility>

namespace tool {

// A line on stderr that shows the fraction that is done: on a terminal only, and from the first second on.
class Progress_bar
{
public:
  Progress_bar(std::string label, bool quiet)
    : m_label(std::move(label)), m_is_shown(!quiet && isatty(STDERR_FILENO) != 0), m_start(Clock::now())
  {}
  Progress_bar(const Progress_bar&) = delete;
  Progress_bar& operator=(const Progress_bar&) = delete;
  ~Progress_bar() { erase(); }

  void show(double fraction)
  {
    const std::chrono::duration<double> elapsed = Clock::now() - m_start;
    const int percent = static_cast<int>(100 * fraction);
    if (!m_is_shown || elapsed.count() < 1 || percent == m_percent) return;
    m_percent = percent;
    const std::size_t done = static_cast<std::size_t>(fraction * width);
    const std::string bar = std::string(done, '#') + std::string(width - done, '.');
    std::fprintf(stderr, "\r%s [%s] %3d %%, %.0f s left ", m_label.c_str(), bar.c_str(), percent,
                 elapsed.count() * (1 - fraction) / fraction);
  }

private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t width = 40;

  void erase()
  {
    if (m_percent >= 0) std::fprintf(stderr, "\r\033[K");
  }

  std::string m_label;
  bool m_is_shown;
  Clock::time_point m_start;
  int m_percent = -1;
};

} // namespace tool

#endif // CGAL_EXAMPLES_JET_FITTING_3_TOOL_PROGRESS_BAR_H
