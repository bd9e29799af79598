// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_SYSTEM_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_SYSTEM_H

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#ifdef _WIN32
#include <io.h>
#include <process.h>
#else
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <thread>
#endif

// All that differs from one operating system to another.
namespace tool {

#ifdef _WIN32

inline bool is_terminal(std::FILE* stream) { return _isatty(_fileno(stream)) != 0; }

// \return whether the program could be started and succeeded
template <class Is_to_end>
bool run_program(const std::vector<std::string>& words, const Is_to_end&)
{
  std::vector<const char*> arguments;
  for (const std::string& word : words) arguments.push_back(word.c_str());
  arguments.push_back(nullptr);
  return _spawnvp(_P_WAIT, arguments[0], arguments.data()) == 0;
}

#else

inline bool is_terminal(std::FILE* stream) { return isatty(fileno(stream)) != 0; }

// Runs a program without a terminal, and ends it when is_to_end() becomes true. \return whether it could be started and
// succeeded
template <class Is_to_end>
bool run_program(std::vector<std::string> words, const Is_to_end& is_to_end)
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
    if (!is_asked_to_end && is_to_end()) is_asked_to_end = kill(child, SIGTERM) == 0;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

#endif

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_SYSTEM_H
