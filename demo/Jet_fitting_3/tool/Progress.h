// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_PROGRESS_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_PROGRESS_H

#include "system.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <string>
#include <thread>

namespace tool {

// A line on a stream that says what is being done, for how long, and the fraction if it is known. A thread of its own
// writes it, so that it comes in time whatever the others do: each second over the last one on a terminal, every ten
// seconds as a new line elsewhere.
class Progress
{
public:
  using Duration = std::chrono::milliseconds;

  explicit Progress(std::FILE* stream = stderr)
    : Progress(stream, is_terminal(stream), Duration(is_terminal(stream) ? 1000 : 10000))
  {}

  Progress(std::FILE* stream, bool erases, Duration interval)
    : m_stream(stream), m_erases(erases), m_interval(interval), m_start(Clock::now()),
      m_thread([this] { write_lines(); })
  {}

  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  ~Progress()
  {
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      m_is_over = true;
    }
    m_end.notify_all();
    m_thread.join();
  }

  // What is done from now on.
  void begin(const std::string& phase)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_phase = phase;
    m_start = Clock::now();
    m_fraction = -1;
  }

  // How much of it is done.
  void show(double fraction) { m_fraction = fraction; }

private:
  using Clock = std::chrono::steady_clock;

  void write_lines()
  {
    std::unique_lock<std::mutex> lock(m_mutex);
    bool is_written = false;
    while (!m_end.wait_for(lock, m_interval, [this] { return m_is_over; })) {
      if (m_phase.empty()) continue;
      std::fprintf(m_stream, m_erases ? "\r%s\033[K" : "%s\n", line().c_str());
      std::fflush(m_stream);
      is_written = true;
    }
    if (is_written && m_erases) std::fprintf(m_stream, "\r\033[K");
  }

  std::string line() const
  {
    const double seconds = std::chrono::duration<double>(Clock::now() - m_start).count(), fraction = m_fraction;
    char text[80];
    if (fraction > 0)
      std::snprintf(text, sizeof text, " %3.0f %%, %.0f s, %.0f s left", 100 * fraction, seconds,
                    seconds * (1 - fraction) / fraction);
    else std::snprintf(text, sizeof text, ", %.0f s", seconds);
    return m_phase + text;
  }

  std::FILE* m_stream;
  bool m_erases;
  Duration m_interval;
  std::mutex m_mutex; // of the next three
  std::string m_phase;
  Clock::time_point m_start;
  bool m_is_over = false;
  std::atomic<double> m_fraction{-1}; // unknown
  std::condition_variable m_end;
  std::thread m_thread; // the last: it uses the others
};

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_PROGRESS_H
