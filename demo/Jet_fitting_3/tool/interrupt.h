// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_INTERRUPT_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_INTERRUPT_H

#include <csignal>
#include <stdexcept>

namespace tool {

// SIGINT, of Ctrl-C, or SIGTERM; 0: go on.
inline volatile std::sig_atomic_t interrupt_requested = 0;

struct Interrupted : std::runtime_error
{
  Interrupted() : std::runtime_error("interrupted: no file was written") {}
  // As a shell reports it.
  int exit_code() const { return 128 + interrupt_requested; }
};

// From now on the first signal only asks for an end; a second one kills.
inline void catch_interrupts()
{
  for (const int number : {SIGINT, SIGTERM})
    std::signal(number, [](int signal) {
      interrupt_requested = signal;
      std::signal(signal, SIG_DFL);
    });
}

// Between the parts of a long job.
inline void stop_if_interrupted()
{
  if (interrupt_requested != 0) throw Interrupted();
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_INTERRUPT_H
