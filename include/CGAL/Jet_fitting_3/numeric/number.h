// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NUMERIC_NUMBER_H
#define CGAL_JET_FITTING_3_NUMERIC_NUMBER_H

#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

/// \file
/// What a number type FT must offer to the steps: + - * / and unary -, conversion from int and double, < > ==,
/// `sqrt` and `abs` found by argument-dependent look-up, and `std::numeric_limits`; for weights by distance `exp` and
/// an explicit conversion to double too. A comparison gives a mask: bool for one number, a lane-wise mask for a Pack.
/// The steps branch on masks only through `select`, `any` and `all`, hence the same code runs on both. Nothing here
/// depends on the order of inclusion.

namespace CGAL {
namespace Jet_fitting {
namespace numeric {
CGAL_JET_FITTING_3_BEGIN_NATIVE

template <class T>
struct Non_deduced
{
  using type = T;
};

/// `FT` by its own name; lets expression templates convert on the way in.
template <class T>
using Plain = typename Non_deduced<T>::type;

/// What a comparison of two FT gives.
template <class FT>
using Mask_of = decltype(FT(0) < FT(0));

inline bool any(bool mask) { return mask; }
inline bool all(bool mask) { return mask; }

// Packs bring these, found by their arguments; named here, a user's variables of these names do not hide them.
void select_lanes() = delete;
void power_of_two_above_lanes() = delete;

/// if_true where the mask holds, if_false elsewhere. Masks other than bool bring their select_lanes().
template <class Mask, class FT>
FT select(const Mask& mask, const FT& if_true, const Plain<FT>& if_false)
{
  if constexpr (std::is_same<Mask, bool>::value) return mask ? if_true : if_false;
  else return select_lanes(mask, if_true, if_false);
}

template <class FT>
FT square_root(const FT& x)
{
  using std::sqrt;
  return FT(sqrt(x));
}

template <class FT>
FT absolute(const FT& x)
{
  using std::abs;
  return FT(abs(x));
}

template <class FT>
FT larger(const FT& a, const Plain<FT>& b)
{
  return select(a < b, FT(b), a);
}

/// -1 for negative numbers, otherwise 1.
template <class FT>
FT sign_of(const FT& x)
{
  return select(x < FT(0), FT(-1), FT(1));
}

/// Without a branch, which would be mispredicted half of the time.
inline double sign_of(double x) { return std::copysign(1.0, x + 0.0); } // -0.0 + 0.0 is 0.0

/// True for finite numbers, false for infinities and NaN.
template <class FT>
auto is_finite(const FT& x)
{
  return FT(x - x) == FT(0); // NOLINT(misc-redundant-expression)
}

/// The plain numbers that an FT consists of: itself, or the lanes of a Pack.
template <class FT>
struct Lanes
{
  using Number = FT;
  static constexpr int count = 1;
  static const FT& get(const FT& x, int) { return x; }
  static void set(FT& x, int, const FT& value) { x = value; }
};

/// f of every lane.
template <class FT, class Function>
FT by_lane(const FT& x, const Function& f)
{
  FT result(x);
  for (int i = 0; i < Lanes<FT>::count; ++i) Lanes<FT>::set(result, i, f(Lanes<FT>::get(x, i)));
  return result;
}

/// Unit round-off, as a plain number.
template <class FT>
typename Lanes<FT>::Number epsilon()
{
  return std::numeric_limits<typename Lanes<FT>::Number>::epsilon();
}

/// The leading half of the digits of v, for |v| <= 1: products of two such parts, and sums of three products, are
/// exact. For number types other than float, double and long double, v itself.
template <class FT>
FT leading_half(const FT& v)
{
  using Number = typename Lanes<FT>::Number;
  if constexpr (std::is_floating_point<Number>::value) {
    constexpr int digits = std::numeric_limits<Number>::digits, kept = (digits - 1) / 2;
    constexpr Number shift = Number(1.5) * Number(1ull << (digits - 1 - kept));
    return FT(v + FT(shift)) - FT(shift);
  } else return v;
}

/// base * factor^times. Multiplied step by step: it overflows, or loses digits to underflow, only if the result does.
template <class FT>
FT multiplied(FT base, const FT& factor, std::size_t times)
{
  for (; times > 0; --times) base = base * factor;
  return base;
}

/// The power of two p with p/2 <= x < p, for a plain number x > 0.
template <class Number>
Number next_power_of_two(const Number& x)
{
  Number p(1);
  while (!(x < p)) p = p * Number(2);
  while (x < Number(p / Number(2))) p = p / Number(2);
  return p;
}

template <class Float>
Float next_power_of_two_by_exponent(Float x)
{
  using Limits = std::numeric_limits<Float>;
  int exponent = 0;
  std::frexp(x, &exponent);
  const int least = Limits::min_exponent + 1, most = Limits::max_exponent - 2;
  return std::ldexp(Float(1), exponent < least ? least : exponent > most ? most : exponent);
}

inline float next_power_of_two(float x) { return next_power_of_two_by_exponent(x); }
inline long double next_power_of_two(long double x) { return next_power_of_two_by_exponent(x); }

/// Reads the exponent from the bits where they are those of IEC 60559: a call of frexp takes as long as a small fit's
/// change of coordinates.
inline double next_power_of_two(double x)
{
  const double least = 0x1p-1000, most = 0x1p1000;
  if (!std::numeric_limits<double>::is_iec559 || !(x > least) || !(x < most)) return next_power_of_two_by_exponent(x);
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof(double));
  bits = (bits & 0x7ff0000000000000u) + 0x0010000000000000u;
  double power;
  std::memcpy(&power, &bits, sizeof(double));
  return power;
}

/// A power of two p with p/2 <= x < p, or 1 where x is zero or not finite: scaling by it is exact.
/// It is held away from both ends of the exponent range, so that 1/p is a normal number too.
template <class FT>
FT power_of_two_above(const FT& x)
{
  if constexpr (Lanes<FT>::count > 1) return power_of_two_above_lanes(x);
  else return x > FT(0) && is_finite(x) ? next_power_of_two(x) : FT(1);
}

inline double inverse_of_power_of_two(double p)
{
  if (!std::numeric_limits<double>::is_iec559) return 1 / p;
  std::uint64_t bits;
  std::memcpy(&bits, &p, sizeof(double));
  bits = 0x7fe0000000000000u - bits;
  double inverse;
  std::memcpy(&inverse, &bits, sizeof(double));
  return inverse;
}

/// 1/p for what power_of_two_above() returns. It is on the critical path, and a division of doubles takes several times
/// as long as to turn the sign of the exponent.
template <class FT>
FT inverse_of_power_of_two(const FT& p)
{
  return FT(1) / p;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace numeric
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NUMERIC_NUMBER_H
