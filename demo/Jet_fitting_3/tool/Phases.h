// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_PHASES_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_PHASES_H

#include "Progress.h"
#include "interrupt.h"

#include <CGAL/Real_timer.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tool {

// The parts of the work, one after the other: shown while they last, timed, and the places where an interrupt ends it.
class Phases
{
public:
  explicit Phases(bool quiet)
  {
    if (!quiet) m_progress.emplace();
    m_timer.start();
  }

  // \throw Interrupted
  void begin(const std::string& name)
  {
    end();
    m_seconds.emplace_back(name, 0);
    if (m_progress) m_progress->begin(name);
  }

  void show(double fraction)
  {
    if (m_progress) m_progress->show(fraction);
  }

  // \throw Interrupted
  void end()
  {
    stop_if_interrupted();
    if (!m_seconds.empty()) m_seconds.back().second = m_timer.time();
    m_timer.reset();
  }

  // Nothing is shown any more. \return what took how long
  const std::vector<std::pair<std::string, double>>& finish()
  {
    end();
    m_progress.reset();
    return m_seconds;
  }

private:
  std::optional<Progress> m_progress;
  CGAL::Real_timer m_timer;
  std::vector<std::pair<std::string, double>> m_seconds;
};

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_PHASES_H
