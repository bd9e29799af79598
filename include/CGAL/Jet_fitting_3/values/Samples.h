// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_VALUES_SAMPLES_H
#define CGAL_JET_FITTING_3_VALUES_SAMPLES_H

#include <CGAL/Jet_fitting_3/numeric/Buffer.h>
#include <CGAL/Jet_fitting_3/numeric/Row_block.h>
#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/number.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Steps
/// The sample points P+ of section 2.1.2, relative to p = samples[0], in world axes: p itself is (0, 0, 0).
/// A weight multiplies the square of its sample's residual; no weights means weights one.
/// Padded to whole blocks of rows by copies of p of weight 0.
template <class FT>
class Samples
{
  using Rows = numeric::Row_block<FT>;
  using Number = typename numeric::Lanes<FT>::Number;

public:
  /// N, p included.
  std::size_t size() const { return m_size; }
  /// N and the copies of p.
  std::size_t padded_size() const { return m_padded_size; }
  /// Sample i relative to p.
  Vector_3<FT> operator[](std::size_t i) const { return {column(0)[i], column(1)[i], column(2)[i]}; }
  /// The block of samples that begins with sample i.
  Vector_3<typename Rows::type> block(std::size_t i) const
  {
    return {Rows::load(column(0) + i), Rows::load(column(1) + i), Rows::load(column(2) + i)};
  }

  /// Whether there may be weights other than one.
  bool is_weighted() const { return m_is_weighted; }
  /// Of sample i.
  const FT& weight(std::size_t i) const { return column(3)[i]; }
  /// Of a block; 0 for copies of p.
  typename Rows::type weight_block(std::size_t i) const { return Rows::load(column(3) + i); }

  /// Sum of the weights; 1 where all are 0: callers divide by it.
  FT total_weight() const
  {
    if (!is_weighted()) return FT(double(size()));
    FT total(0);
    for (std::size_t i = 0; i < size(); ++i) total = total + weight(i);
    return numeric::select(total > FT(0), total, FT(1));
  }

  /// Coordinates are indeterminate until set, weights are one.
  void resize(std::size_t size, bool weighted = false)
  {
    m_size = size;
    m_padded_size = numeric::padded_to_blocks<FT>(size);
    m_is_weighted = weighted;
    m_table.resize(4 * m_padded_size);
    for (std::size_t c = 0; c < 4; ++c) std::fill(column(c) + size, column(c) + m_padded_size, FT(0));
    std::fill(column(3), column(3) + size, FT(1));
  }

  /// Sample i, relative to p.
  void set(std::size_t i, const Vector_3<FT>& r)
  {
    column(0)[i] = r.x;
    column(1)[i] = r.y;
    column(2)[i] = r.z;
  }

  /// From now on set_weight() may be called.
  void make_weighted() { m_is_weighted = true; }

  /// Of sample i.
  void set_weight(std::size_t i, const FT& weight) { column(3)[i] = weight; }

  /// Sample i in one lane.
  void set_lane(std::size_t i, int lane, const Vector_3<Number>& r)
  {
    numeric::Lanes<FT>::set(column(0)[i], lane, r.x);
    numeric::Lanes<FT>::set(column(1)[i], lane, r.y);
    numeric::Lanes<FT>::set(column(2)[i], lane, r.z);
  }

  /// The weight of sample i in one lane.
  void set_weight_lane(std::size_t i, int lane, const Number& weight)
  {
    numeric::Lanes<FT>::set(column(3)[i], lane, weight);
  }

  /// Multiplies all coordinates.
  void scale(const FT& factor)
  {
    FT* coordinate = column(0);
    for (std::size_t i = 0; i < 3 * m_padded_size; ++i) coordinate[i] = coordinate[i] * factor;
  }

private:
  FT* column(std::size_t c) { return m_table.data() + c * m_padded_size; } // x, y, z, weight
  const FT* column(std::size_t c) const { return m_table.data() + c * m_padded_size; }

  std::size_t m_size = 0, m_padded_size = 0;
  bool m_is_weighted = false;
  numeric::Buffer<FT, 512> m_table; // four times 128 samples
};

/// \ingroup PkgJetFitting3Steps
/// A power of two above the largest coordinate: the unit of length in which the steps compute, so that no square, no
/// power and no product of theirs can overflow or underflow, and a change of unit by 2^e changes no digit.
template <class FT>
FT unit_of_length(const Samples<FT>& samples)
{
  using Rows = numeric::Row_block<FT>;
  using numeric::larger, numeric::absolute;
  typename Rows::type x(0), y(0), z(0); // side by side, because a comparison takes several cycles
  for (std::size_t i = 0; i < samples.padded_size(); i += Rows::size) {
    const auto r = samples.block(i);
    x = larger(x, absolute(r.x));
    y = larger(y, absolute(r.y));
    z = larger(z, absolute(r.z));
  }
  return numeric::power_of_two_above(Rows::largest(larger(x, larger(y, z))));
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_VALUES_SAMPLES_H
