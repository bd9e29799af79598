// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_BYTES_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_BYTES_H

#include <cstddef>
#include <cstring>
#include <ostream>
#include <vector>

namespace tool {

// Numbers as the bytes of this machine's memory, gathered before they go into a file.
class Bytes
{
public:
  explicit Bytes(std::ostream& out) : m_out(out), m_bytes(1 << 20) {}
  Bytes(const Bytes&) = delete;
  Bytes& operator=(const Bytes&) = delete;
  ~Bytes() { flush(); }

  template <class Number>
  void add(Number x)
  {
    if (m_bytes.size() - m_size < sizeof(Number)) flush();
    std::memcpy(m_bytes.data() + m_size, &x, sizeof(Number));
    m_size += sizeof(Number);
  }

private:
  void flush()
  {
    m_out.write(m_bytes.data(), std::streamsize(m_size));
    m_size = 0;
  }

  std::ostream& m_out;
  std::vector<char> m_bytes;
  std::size_t m_size = 0;
};

inline bool is_little_endian()
{
  const unsigned int one = 1;
  unsigned char first;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_BYTES_H
