// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NUMERIC_MOMENT_SUMS_H
#define CGAL_JET_FITTING_3_NUMERIC_MOMENT_SUMS_H

#include <CGAL/Jet_fitting_3/numeric/Pack.h>
#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
namespace numeric {
CGAL_JET_FITTING_3_BEGIN_NATIVE

namespace moment_sums {

constexpr std::size_t lanes = (std::max)(2, native_lanes<double>());
using Lanes = Pack<double, int(lanes)>;

// The first so many numbers of a function of 0, 1, ...; zeros where there are no more.
template <class Number>
Lanes lanes_of(std::size_t count, const Number& number)
{
  if (count >= lanes) return Lanes::of_lanes([&number](int i) { return number(std::size_t(i)); });
  Lanes result = 0;
  for (std::size_t i = 0; i < count; ++i) result.set(int(i), number(i));
  return result;
}

// Samples side by side, with so many values each; where there are no more, of weight 0.
template <std::size_t values>
struct Packed_samples
{
  Lanes x, y, weight, of[values];
};

// How many are left from the first of them on.
inline std::size_t rest(std::size_t count, std::size_t first) { return first < count ? count - first : 0; }

inline Vector_3<Lanes> places(const Vector_3<double>* samples, std::size_t count)
{
  return {lanes_of(count, [samples](std::size_t i) { return samples[i].x; }),
          lanes_of(count, [samples](std::size_t i) { return samples[i].y; }),
          lanes_of(count, [samples](std::size_t i) { return samples[i].z; })};
}

inline Lanes weights(std::size_t count)
{
  return lanes_of(count, [](std::size_t) { return 1.; });
}

// With the first so many of z, z^2, z (x^2 + y^2 + z^2).
template <std::size_t values>
Packed_samples<values> with_heights(const Vector_3<double>* samples, std::size_t count)
{
  const Vector_3<Lanes> p = places(samples, count);
  Packed_samples<values> result{p.x, p.y, weights(count), {p.z}};
  if constexpr (values > 1) result.of[1] = p.z * p.z;
  if constexpr (values > 2) result.of[2] = p.z * dot(p, p);
  return result;
}

// Sums for x^i y^j at [j][i], up to an order.
template <std::size_t order>
struct Sums
{
  Lanes of[order + 1][order + 1];

  Sums()
  {
    for (std::size_t j = 0; j <= order; ++j)
      for (std::size_t i = 0; i + j <= order; ++i) of[j][i] = 0;
  }

  void add_to(double* moments) const
  {
    for (std::size_t j = 0; j <= order; ++j)
      for (std::size_t i = 0; i + j <= order; ++i)
        for (std::size_t lane = 0; lane < lanes; ++lane) moments[(i + j) * (i + j + 1) / 2 + j] += of[j][i][int(lane)];
  }
};

// Two packs at a time, so that each sum is touched half as often.
template <std::size_t order, std::size_t degree, std::size_t values>
void add_powers(const Packed_samples<values>& a, const Packed_samples<values>& b, Sums<order>& of_terms,
                Sums<degree> (&of_values)[values])
{
  Lanes powers_of_a[order + 1], powers_of_b[order + 1];
  powers_of_a[0] = a.weight;
  powers_of_b[0] = b.weight;
  for (std::size_t i = 1; i <= order; ++i) {
    powers_of_a[i] = powers_of_a[i - 1] * a.x;
    powers_of_b[i] = powers_of_b[i - 1] * b.x;
  }
  Lanes of_a = 1, of_b = 1; // y^j
  for (std::size_t j = 0; j <= order; ++j) {
    for (std::size_t i = 0; i + j <= order; ++i)
      of_terms.of[j][i] = of_terms.of[j][i] + (of_a * powers_of_a[i] + of_b * powers_of_b[i]);
    for (std::size_t r = 0; j <= degree && r < values; ++r) {
      const Lanes value_of_a = of_a * a.of[r], value_of_b = of_b * b.of[r];
      for (std::size_t i = 0; i + j <= degree; ++i)
        of_values[r].of[j][i] = of_values[r].of[j][i] + (value_of_a * powers_of_a[i] + value_of_b * powers_of_b[i]);
    }
    of_a = of_a * a.y;
    of_b = of_b * b.y;
  }
}

} // namespace moment_sums

/// Calls f(samples, first, end) for all samples, as many side by side as registers hold: a Vector_3 of packs, and the
/// numbers of the first of them and of the one after the last.
template <class Function>
void for_samples_side_by_side(const Vector_3<double>* samples, std::size_t count, const Function& f)
{
  using moment_sums::lanes;
  for (std::size_t k = 0; k < count; k += lanes)
    f(moment_sums::places(samples + k, count - k), k, (std::min)(k + lanes, count));
}

/// Adds what samples contribute to the sums of x^i y^j, up to an order, and, up to a degree, of x^i y^j times each of
/// some values. They are in the order 1, x, y, x^2, xy, y^2, ...
/// \param load load(first, n) is moment_sums::Packed_samples of the n samples from the first on, as far as they have
///        room
/// \param sums_of_values where they are, one for each of these
template <std::size_t order, std::size_t degree, std::size_t values, class Load>
void add_moments_of(std::size_t count, const Load& load, double* terms,
                    const std::array<double*, values>& sums_of_values)
{
  using namespace moment_sums;
  Sums<order> of_terms;
  Sums<degree> of_values[values];
  for (std::size_t k = 0; k < count; k += 2 * lanes)
    add_powers<order, degree, values>(load(k, count - k), load(k + lanes, rest(count, k + lanes)), of_terms, of_values);
  of_terms.add_to(terms);
  for (std::size_t r = 0; r < values; ++r) of_values[r].add_to(sums_of_values[r]);
}

/// With the first so many of z, z^2, z (x^2 + y^2 + z^2) for values.
template <std::size_t order, std::size_t degree, std::size_t values>
void add_moments(const Vector_3<double>* samples, std::size_t count, double* terms,
                 const std::array<double*, values>& sums_of_values)
{
  const auto load = [samples](std::size_t first, std::size_t n) {
    return moment_sums::with_heights<values>(samples + first, n);
  };
  add_moments_of<order, degree>(count, load, terms, sums_of_values);
}

/// With heights alone.
template <std::size_t order, std::size_t degree>
void add_moments(const Vector_3<double>* samples, std::size_t count, double* terms, double* heights)
{
  add_moments<order, degree, 1>(samples, count, terms, {heights});
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace numeric
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NUMERIC_MOMENT_SUMS_H
