// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXAMPLES_JET_FITTING_3_TOOL_INTERRUPT_H
#define CGAL_EXAMPLES_JET_FITTING_3_TOOL_INTERRUPT_H

#include <csignal>
#include <stdexcept>

namespace tool {

struct Interrupted : std::runtime_error
{
  Interrupted() : std::runtime_error("interrupted: no file was written") {}
};

inline volatile std::sig_atomic_t interrupt_requested = 0;

// From now on the first Ctrl-C only asks for an end; a second one kills.
inline void catch_interrupts()
{
  std::signal(SIGINT, [](int) {
    interrupt_requested = 1;
    std::signal(SIGINT, SIG_DFL);
  });
}

// Between the parts of a long job.
inline void stop_if_interrupted()
{
  if (interrupt_requested != 0) throw Interrupted();
}

} // namespace tool

#endif // CGAL_EXAMPLES_JET_FITTING_3_TOOL_INTERRUPT_H
