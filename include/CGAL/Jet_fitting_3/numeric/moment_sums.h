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

// Some of them side by side; where there are no more, of weight 0.
struct Samples
{
  Lanes x = 0, y = 0, z = 0, weight = 0;

  Samples(const Vector_3<double>* samples, std::size_t first, std::size_t count)
  {
    if (first + lanes <= count) { // none has to be asked whether it is there
      for (std::size_t i = 0; i < lanes; ++i) set(i, samples[first + i]);
      weight = 1;
    } else {
      for (std::size_t i = 0; i < lanes && first + i < count; ++i) {
        set(i, samples[first + i]);
        weight.set(int(i), 1);
      }
    }
  }

  void set(std::size_t i, const Vector_3<double>& s)
  {
    x.set(int(i), s.x);
    y.set(int(i), s.y);
    z.set(int(i), s.z);
  }
};

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

// z, z^2, z (x^2 + y^2 + z^2), the first so many.
template <std::size_t rights>
struct Rights
{
  Lanes of[rights];

  explicit Rights(const Samples& s)
  {
    of[0] = s.z;
    if constexpr (rights > 1) of[1] = s.z * s.z;
    if constexpr (rights > 2) of[2] = s.z * (s.x * s.x + s.y * s.y + of[1]);
  }
};

// Two packs at a time, so that each sum is touched half as often.
template <std::size_t order, std::size_t degree, std::size_t rights>
void add_powers(const Samples& a, const Samples& b, Sums<order>& of_terms, Sums<degree> (&of_rights)[rights])
{
  const Rights<rights> rights_of_a(a), rights_of_b(b);
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
    for (std::size_t r = 0; j <= degree && r < rights; ++r) {
      const Lanes right_of_a = of_a * rights_of_a.of[r], right_of_b = of_b * rights_of_b.of[r];
      for (std::size_t i = 0; i + j <= degree; ++i)
        of_rights[r].of[j][i] = of_rights[r].of[j][i] + (right_of_a * powers_of_a[i] + right_of_b * powers_of_b[i]);
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
  for (std::size_t k = 0; k < count; k += lanes) {
    const moment_sums::Samples some(samples, k, count);
    f(Vector_3<moment_sums::Lanes>{some.x, some.y, some.z}, k, (std::min)(k + lanes, count));
  }
}

/// Adds what samples contribute to the sums of x^i y^j, up to an order, and, up to a degree, of x^i y^j times the first
/// so many of z, z^2, z (x^2 + y^2 + z^2). They are in the order 1, x, y, x^2, xy, y^2, ...
/// \param sums_of_rights where they are, one for each of these
template <std::size_t order, std::size_t degree, std::size_t rights>
void add_moments(const Vector_3<double>* samples, std::size_t count, double* terms,
                 const std::array<double*, rights>& sums_of_rights)
{
  using namespace moment_sums;
  Sums<order> of_terms;
  Sums<degree> of_rights[rights];
  for (std::size_t k = 0; k < count; k += 2 * lanes) {
    const Samples a(samples, k, count), b(samples, k + lanes, count);
    add_powers(a, b, of_terms, of_rights);
  }
  of_terms.add_to(terms);
  for (std::size_t r = 0; r < rights; ++r) of_rights[r].add_to(sums_of_rights[r]);
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
