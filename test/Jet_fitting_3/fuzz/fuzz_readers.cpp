// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// libFuzzer harness for what the program Mesh_estimation reads: files of every format, and the command line.
// A file or a command line is taken, or refused by an Input_error or a Usage_error.

#include "fuzz.h"

#include "../../../demo/Jet_fitting_3/tool/parse.h"
#include "../../../demo/Jet_fitting_3/tool/read_input.h"

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <cstdlib>
#include <fstream>
#include <new>
#include <sstream>
#include <string>
#include <vector>

// A file of a few bytes may claim that it has a billion vertices: memory is then refused, as on a smaller machine.
void* operator new(std::size_t size)
{
  void* const memory = size > (std::size_t(1) << 29) ? nullptr : std::malloc(size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

void read_file(const std::string& format, const std::string& content)
{
  const std::filesystem::path folder = std::filesystem::temp_directory_path();
  const std::string file = (folder / ("jet_fitting_3_fuzz_" + std::to_string(getpid()) + "." + format)).string();
  std::ofstream(file, std::ios::binary) << content;
  try {
    const tool::Mesh mesh = tool::read_input(file).mesh;
    CGAL_FUZZ_DEMAND(mesh.number_of_vertices() > 0);
  } catch (const tool::Input_error&) {}
  std::filesystem::remove(file);
}

void read_command_line(const std::string& content)
{
  std::vector<std::string> words{"Mesh_estimation"};
  std::istringstream in(content);
  for (std::string word; std::getline(in, word);) words.push_back(word);
  std::vector<const char*> argv;
  for (const std::string& word : words) argv.push_back(word.c_str());
  try {
    tool::Command_line().parse(static_cast<int>(argv.size()), argv.data());
  } catch (const tool::Usage_error&) {}
}

/// The first byte chooses the format, the rest is the file.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if (size == 0) return 0;
  const std::string content(data + 1, data + size);
  const char* const formats[] = {"off", "obj", "ply", "stl", "ts", "xyz", "pwn"};
  const std::size_t format = data[0] % 8;
  if (format < 7) read_file(formats[format], content);
  else read_command_line(content);
  return 0;
}
