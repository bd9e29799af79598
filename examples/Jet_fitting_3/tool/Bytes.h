// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXAMPLES_JET_FITTING_3_TOOL_BYTES_H
#define CGAL_EXAMPLES_JET_FITTING_3_TOOL_BYTES_H

#include <cstring>
#include <ostream>
#include <string>

namespace tool {

// Numbers as the bytes of this machine's memory, gathered before they go into a file.
class Bytes
{
public:
  explicit Bytes(std::ostream& out) : m_out(out) { m_bytes.reserve(limit + 4096); }
  Bytes(const Bytes&) = delete;
  Bytes& operator=(const Bytes&) = delete;
  ~Bytes() { flush(); }

  template <class Number>
  void add(Number x)
  {
    char raw[sizeof(Number)];
    std::memcpy(raw, &x, sizeof(Number));
    m_bytes.append(raw, sizeof(Number));
    if (m_bytes.size() >= limit) flush();
  }

private:
  static constexpr std::size_t limit = 1 << 20;

  void flush()
  {
    m_out.write(m_bytes.data(), std::streamsize(m_bytes.size()));
    m_bytes.clear();
  }

  std::ostream& m_out;
  std::string m_bytes;
};

inline bool is_little_endian()
{
  const unsigned int one = 1;
  unsigned char first;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

} // namespace tool

#endif // CGAL_EXAMPLES_JET_FITTING_3_TOOL_BYTES_H
