// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXAMPLES_JET_FITTING_3_TOOL_RUN_POVRAY_H
#define CGAL_EXAMPLES_JET_FITTING_3_TOOL_RUN_POVRAY_H

#include "Output_files.h"
#include "interrupt.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

namespace tool {

// Runs a program without a terminal; an interrupt ends it. \return whether it could be started and succeeded
inline bool run_program(std::vector<std::string> words)
{
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(&word[0]);
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t no_terminal;
  posix_spawn_file_actions_init(&no_terminal);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&no_terminal, stream, "/dev/null", O_RDWR, 0);
  pid_t child;
  const int error = posix_spawnp(&child, arguments[0], &no_terminal, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&no_terminal);
  if (error != 0) return false;
  int status = 0;
  bool is_asked_to_end = false;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (interrupt_requested != 0 && !is_asked_to_end) is_asked_to_end = kill(child, SIGTERM) == 0;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  stop_if_interrupted();
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

// Draws a scene without a display. povray itself adds .png to names that do not end so. \return whether it worked
inline bool run_povray(const std::string& scene, const std::string& png, int width, int height)
{
  if (!run_program({"povray", "--version"})) throw Output_error(png, "povray, which draws pictures, is not installed");
  const std::string made = png + ".png";
  bool is_made = false;
  try {
    is_made = run_program({"povray", "+I" + scene, "+O" + made, "+FN", "+W" + std::to_string(width),
                           "+H" + std::to_string(height), "+A0.1", "+AM2", "+R3", "-D", "-GA"});
  } catch (const Interrupted&) {
    std::remove(made.c_str());
    throw;
  }
  if (!is_made) std::remove(made.c_str());
  return is_made && std::rename(made.c_str(), png.c_str()) == 0;
}

} // namespace tool

#endif // CGAL_EXAMPLES_JET_FITTING_3_TOOL_RUN_POVRAY_H
