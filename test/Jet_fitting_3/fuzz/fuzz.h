// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the bytes of a fuzzer mean, and the properties that every estimation has.

#ifndef CGAL_JET_FITTING_3_TEST_FUZZ_H
#define CGAL_JET_FITTING_3_TEST_FUZZ_H

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

/// Reads numbers off the input; zeros when it has ended.
class Bytes
{
public:
  Bytes(const std::uint8_t* data, std::size_t size) : m_data(data), m_left(size) {}

  bool empty() const { return m_left == 0; }

  template <class T>
  T next()
  {
    T value{};
    const std::size_t count = sizeof(T) < m_left ? sizeof(T) : m_left;
    std::memcpy(&value, m_data, count);
    m_data += count;
    m_left -= count;
    return value;
  }

  unsigned below(unsigned bound) { return next<std::uint8_t>() % bound; }

  /// Any bit pattern, or a multiple of 1/16 in [-8, 8): duplicates, collinear and coplanar samples are then likely.
  double coordinate(bool raw) { return raw ? next<double>() : next<std::int8_t>() / 16.; }

private:
  const std::uint8_t* m_data;
  std::size_t m_left;
};

#define CGAL_FUZZ_DEMAND(condition) demand(condition, #condition, __LINE__)

inline void demand(bool condition, const char* text, int line)
{
  if (condition) return;
  std::fprintf(stderr, "line %d: %s does not hold\n", line, text);
  std::abort();
}

template <class Vector>
double product(const Vector& a, const Vector& b)
{
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

/// Orthonormal and direct to 1e-12.
template <class Vector>
void demand_frame(const Vector& x, const Vector& y, const Vector& z)
{
  const double tolerance = 1e-12;
  CGAL_FUZZ_DEMAND(std::abs(product(x, x) - 1) < tolerance && std::abs(product(y, y) - 1) < tolerance);
  CGAL_FUZZ_DEMAND(std::abs(product(z, z) - 1) < tolerance && std::abs(product(x, y)) < tolerance);
  CGAL_FUZZ_DEMAND(std::abs(product(y, z)) < tolerance && std::abs(product(z, x)) < tolerance);
  const double determinant = (x.y() * y.z() - x.z() * y.y()) * z.x() + (x.z() * y.x() - x.x() * y.z()) * z.y() +
                             (x.x() * y.y() - x.y() * y.x()) * z.z();
  CGAL_FUZZ_DEMAND(std::abs(determinant - 1) < tolerance);
}

#endif // CGAL_JET_FITTING_3_TEST_FUZZ_H
