// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_PACKED_FORMS_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_PACKED_FORMS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Monge_form.h>
#include <CGAL/Jet_fitting_3/internal/machine/parallel.h>
#include <CGAL/Jet_fitting_3/internal/machine/prefetch.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/values/Monge_coefficients.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Forms that come in any order and are handed out in the order of their numbers. They are kept as plain numbers, which
/// takes no allocation for each, and in pieces that are given up as they are handed out.
template <class Kernel>
class Packed_forms
{
  using Form = Monge_form<Kernel>;
  using FT = typename Kernel::FT;
  static constexpr std::size_t frame_size = 12; // the numbers of origin, d1, d2, n
  static constexpr std::uint16_t is_empty = 65535;
  /// From about here on allocators ask the system for memory, and give it back at once.
  static constexpr std::size_t piece_bytes = std::size_t(1) << 25;

public:
  /// All are empty. \param degree the highest
  Packed_forms(std::size_t size, std::size_t degree)
    : m_stride(frame_size + number_of_monge_coefficients(degree)),
      m_piece_size(1 + piece_bytes / (m_stride * sizeof(FT))), m_numbers_of_coefficients(size, is_empty)
  {
    for (std::size_t i = 0; i < size; i += m_piece_size)
      m_pieces.push_back(std::unique_ptr<FT[]>(new FT[m_stride * (std::min)(m_piece_size, size - i)]));
  }

  void prefetch(std::size_t i) { internal::prefetch(numbers(i), m_stride * sizeof(FT)); }

  void set(std::size_t i, const Form& form)
  {
    FT* out = numbers(i);
    const auto append = [&out](const auto& v) {
      for (int axis = 0; axis < 3; ++axis) *out++ = v.cartesian(axis);
    };
    append(form.origin());
    append(form.maximal_principal_direction());
    append(form.minimal_principal_direction());
    append(form.normal_direction());
    std::copy(form.coefficients().begin(), form.coefficients().end(), out);
    m_numbers_of_coefficients[i] = static_cast<std::uint16_t>(form.coefficients().size());
  }

  /// Afterwards there are none. Forms are made by one thread while those before are written by another.
  /// \param count how many are handed out
  template <class ConcurrencyTag, class OutputIterator>
  void write(std::size_t count, OutputIterator output)
  {
    std::vector<Form> made, next;
    std::size_t i = 0;
    const auto make = [&] {
      next.clear();
      for (const std::size_t end = (std::min)(count, i + block_size); i < end; ++i) next.push_back(form(i));
      for (std::size_t piece = 0; piece < i / m_piece_size; ++piece) m_pieces[piece].reset();
    };
    const auto write = [&] {
      for (Form& form : made) *output++ = std::move(form);
    };
    do {
      do_both<ConcurrencyTag>(write, make); // the second in this thread: in others allocating is slower
      made.swap(next);
    } while (!made.empty());
  }

private:
  FT* numbers(std::size_t i) { return m_pieces[i / m_piece_size].get() + m_stride * (i % m_piece_size); }

  Form form(std::size_t i)
  {
    if (m_numbers_of_coefficients[i] == is_empty) return Form();
    using Vector_3 = typename Form::Vector_3;
    const FT* const x = numbers(i);
    Form form({x[0], x[1], x[2]}, Vector_3(x[3], x[4], x[5]), Vector_3(x[6], x[7], x[8]), Vector_3(x[9], x[10], x[11]));
    form.coefficients().assign(x + frame_size, x + frame_size + m_numbers_of_coefficients[i]);
    return form;
  }

  std::size_t m_stride, m_piece_size;
  std::vector<std::uint16_t> m_numbers_of_coefficients;
  std::vector<std::unique_ptr<FT[]>> m_pieces; // not initialized: the system makes pages when they are touched
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_PACKED_FORMS_H
