// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_OUTPUT_FILES_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_OUTPUT_FILES_H

#include <filesystem>
#include <fstream>
#include <list>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace tool {

class Output_error : public std::runtime_error
{
public:
  Output_error(const std::string& file, const std::string& what) : std::runtime_error(file + ": " + what) {}
};

// The file that a name stands for: where symbolic links lead to, whether there is a file already or not.
inline std::filesystem::path file_behind(const std::string& name)
{
  namespace fs = std::filesystem;
  std::error_code error;
  fs::path path = name;
  for (int links = 0; links < 40 && fs::is_symlink(path, error); ++links)
    path = path.parent_path() / fs::read_symlink(path, error); // an absolute one replaces the folder
  const fs::path folder = fs::weakly_canonical(path.has_parent_path() ? path.parent_path() : ".", error);
  return error ? path : folder / path.filename();
}

// Files that appear under their names together, when all of them are complete: until commit() each has a temporary name
// in the same folder. Without commit() nothing is left behind. A file that is replaced leaves its permissions to the
// new one, and a symbolic link stays one.
class Output_files
{
public:
  Output_files() = default;
  Output_files(const Output_files&) = delete;
  Output_files& operator=(const Output_files&) = delete;

  ~Output_files()
  {
    for (File& file : m_files) {
      file.stream.close();
      std::error_code ignored;
      std::filesystem::remove(file.temporary(), ignored);
    }
  }

  // write(stream) fills the file. \throw Output_error
  template <class Write>
  void add(const std::string& name, const Write& write)
  {
    File& file = m_files.emplace_back(name);
    file.stream.open(file.temporary(), std::ios::binary);
    if (!file.stream) throw Output_error(name, "cannot be opened for writing");
    keep_permissions(file);
    write(file.stream);
    file.stream.close();
    if (!file.stream) throw Output_error(name, "could not be written to its end: is the disk full?");
  }

  // make(temporary_name) makes the file by other means, and \return true if it did.
  template <class Make>
  void add_made(const std::string& name, const Make& make)
  {
    const File& file = m_files.emplace_back(name);
    if (!make(file.temporary())) throw Output_error(name, "could not be made");
    keep_permissions(file);
  }

  // Where the file that was added last is until commit().
  std::string temporary() const { return m_files.back().temporary(); }

  // \return the names of the files
  std::vector<std::string> commit()
  {
    std::vector<std::string> names;
    for (const File& file : m_files) {
      std::error_code error;
      std::filesystem::rename(file.temporary(), file.target, error);
      if (error) throw Output_error(file.name, error.message());
      names.push_back(file.name);
    }
    m_files.clear();
    return names;
  }

private:
  struct File
  {
    explicit File(const std::string& file_name) : name(file_name), target(file_behind(file_name)), buffer(1 << 20)
    {
      stream.rdbuf()->pubsetbuf(buffer.data(), std::streamsize(buffer.size()));
    }
    std::string temporary() const { return target.string() + ".part"; }

    std::string name;
    std::filesystem::path target;
    std::vector<char> buffer;
    std::ofstream stream;
  };

  static void keep_permissions(const File& file)
  {
    namespace fs = std::filesystem;
    std::error_code ignored;
    const fs::file_status replaced = fs::status(file.target, ignored);
    if (fs::exists(replaced)) fs::permissions(file.temporary(), replaced.permissions(), ignored);
  }

  std::list<File> m_files;
};

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_OUTPUT_FILES_H
