// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NUMERIC_POWER_SERIES_H
#define CGAL_JET_FITTING_3_NUMERIC_POWER_SERIES_H

#include <CGAL/Jet_fitting_3/numeric/Buffer.h>
#include <CGAL/Jet_fitting_3/numeric/binary_form.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/number.h>

#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
namespace numeric {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// A truncated power series in (x, y), by its Taylor coefficients.
/// Orders `lowest` to `highest` are kept, order k as k + 1 coefficients.
template <class FT>
class Power_series
{
public:
  /// Zero, with room for these orders.
  Power_series(std::size_t lowest, std::size_t highest) : m_lowest(lowest), m_highest(highest)
  {
    m_coefficients.resize(((highest + 1) * (highest + 2) - lowest * (lowest + 1)) / 2);
    for (FT& coefficient : m_coefficients) coefficient = FT(0);
  }

  std::size_t lowest() const { return m_lowest; }   ///< first order that is kept
  std::size_t highest() const { return m_highest; } ///< last order that is kept
  /// @{
  /// The coefficients of x^k, x^(k-1) y, ..., y^k.
  FT* order(std::size_t k) { return m_coefficients.data() + (k * (k + 1) - m_lowest * (m_lowest + 1)) / 2; }
  const FT* order(std::size_t k) const { return m_coefficients.data() + (k * (k + 1) - m_lowest * (m_lowest + 1)) / 2; }
  /// @}

private:
  std::size_t m_lowest, m_highest;
  Buffer<FT, 64> m_coefficients;
};

/// The product of two series, up to the given order.
template <class FT>
Power_series<FT> product(const Power_series<FT>& a, const Power_series<FT>& b, std::size_t highest)
{
  Power_series<FT> result(a.lowest() + b.lowest(), highest);
  for (std::size_t i = a.lowest(); i <= a.highest(); ++i)
    for (std::size_t j = b.lowest(); j <= b.highest() && i + j <= highest; ++j)
      add_product(i, a.order(i), j, b.order(j), result.order(i + j));
  return result;
}

/// q = 1 / sqrt(p), for a series p that begins with a positive constant. Euler's operator E = x d/dx + y d/dy, which
/// multiplies order k by k, turns q = p^r into p E q = r q E p: a recurrence for one order after the other (J. C. P.
/// Miller's formula, homogeneous polynomials taking the place of coefficients).
template <class FT>
Power_series<FT> inverse_square_root(const Power_series<FT>& p)
{
  Power_series<FT> q(0, p.highest());
  const FT constant = p.order(0)[0];
  q.order(0)[0] = FT(1) / square_root(constant);
  Buffer<FT, 16> term;
  for (std::size_t k = 1; k <= p.highest(); ++k) {
    for (std::size_t j = 1; j <= k; ++j) {
      const FT factor = FT(0.5 * double(j) - double(k)) / FT(double(k) * constant);
      term.resize(j + 1);
      for (std::size_t i = 0; i <= j; ++i) term[i] = factor * p.order(j)[i];
      add_product(j, term.data(), k - j, q.order(k - j), q.order(k));
    }
  }
  return q;
}

/// A vector field in the plane, by the series of its components.
template <class FT>
struct Vector_field
{
  Power_series<FT> x, y;
};

/// The gradient of a series.
template <class FT>
Vector_field<FT> gradient(const Power_series<FT>& p)
{
  Vector_field<FT> field{{0, p.highest() - 1}, {0, p.highest() - 1}};
  for (std::size_t k = p.lowest() > 1 ? p.lowest() : 1; k <= p.highest(); ++k)
    for (std::size_t i = 0; i < k; ++i) {
      field.x.order(k - 1)[i] = FT(double(k - i)) * p.order(k)[i];
      field.y.order(k - 1)[i] = FT(double(i + 1)) * p.order(k)[i + 1];
    }
  return field;
}

/// |F|^2.
template <class FT>
Power_series<FT> square(const Vector_field<FT>& field)
{
  Power_series<FT> sum = product(field.x, field.x, field.x.highest());
  for (std::size_t k = 0; k <= field.y.highest(); ++k)
    for (std::size_t j = 0; j <= k; ++j) add_product(j, field.y.order(j), k - j, field.y.order(k - j), sum.order(k));
  return sum;
}

/// s F.
template <class FT>
Vector_field<FT> product(const Power_series<FT>& s, const Vector_field<FT>& field)
{
  return {product(s, field.x, field.x.highest()), product(s, field.y, field.y.highest())};
}

/// The potential of a field, with constant 0: its integral along the rays from the origin, (x F_x + y F_y) / k in order
/// k. A field need not be a gradient. Its order k - 1 is a tensor symmetric in k - 1 places; the k-th derivatives of
/// the potential are that tensor made symmetric in all k. So of all gradients this one's is the closest: the projection
/// that is orthogonal in the norm of tensors (Frobenius, Bombieri), independent of axes.
template <class FT>
Power_series<FT> potential(const Vector_field<FT>& field)
{
  Power_series<FT> p(1, field.x.highest() + 1);
  for (std::size_t k = 1; k <= p.highest(); ++k) {
    const FT inverse = FT(1) / FT(double(k));
    for (std::size_t i = 0; i < k; ++i) {
      p.order(k)[i] = p.order(k)[i] + inverse * field.x.order(k - 1)[i];
      p.order(k)[i + 1] = p.order(k)[i + 1] + inverse * field.y.order(k - 1)[i];
    }
  }
  return p;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace numeric
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NUMERIC_POWER_SERIES_H
