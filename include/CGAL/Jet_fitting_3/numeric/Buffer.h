// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NUMERIC_BUFFER_H
#define CGAL_JET_FITTING_3_NUMERIC_BUFFER_H

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

namespace CGAL {
namespace Jet_fitting {
namespace numeric {

/// A resizable array that keeps up to `inline_capacity` elements within itself, so that small fits allocate nothing.
/// resize() leaves the elements indeterminate; capacity never shrinks.
template <class T, std::size_t inline_capacity>
class Buffer
{
public:
  Buffer() {} // not defaulted: value-initialization would fill the array with zeros
  Buffer(const Buffer& other) { *this = other; }
  Buffer(Buffer&& other) noexcept(noexcept(std::declval<T&>() = std::declval<const T&>())) { *this = std::move(other); }

  Buffer& operator=(const Buffer& other)
  {
    if (this != &other) {
      resize(other.m_size);
      std::copy(other.begin(), other.end(), data());
    }
    return *this;
  }

  Buffer& operator=(Buffer&& other) noexcept(noexcept(std::declval<T&>() = std::declval<const T&>()))
  {
    if (this == &other) return *this;
    m_size = other.m_size;
    m_capacity = other.m_capacity;
    m_heap = std::move(other.m_heap);
    if (!m_heap) std::copy(other.m_inline, other.m_inline + m_size, m_inline);
    other.m_size = 0;
    other.m_capacity = inline_capacity;
    return *this;
  }

  void resize(std::size_t size)
  {
    if (size > m_capacity) {
      const std::size_t capacity = (std::max)(size, m_capacity + m_capacity / 2);
      m_heap.reset(new T[capacity]);
      m_capacity = capacity;
    }
    m_size = size;
  }

  std::size_t size() const { return m_size; }
  bool empty() const { return m_size == 0; }
  T* data() { return m_heap ? m_heap.get() : m_inline; }
  const T* data() const { return m_heap ? m_heap.get() : m_inline; }
  T* begin() { return data(); }
  T* end() { return data() + m_size; }
  const T* begin() const { return data(); }
  const T* end() const { return data() + m_size; }
  T& operator[](std::size_t i) { return data()[i]; }
  const T& operator[](std::size_t i) const { return data()[i]; }

private:
  std::size_t m_size = 0;
  std::size_t m_capacity = inline_capacity;
  std::unique_ptr<T[]> m_heap;
  T m_inline[inline_capacity];
};

} // namespace numeric
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NUMERIC_BUFFER_H
