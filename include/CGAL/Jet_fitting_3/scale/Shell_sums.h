// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_SHELL_SUMS_H
#define CGAL_JET_FITTING_3_SCALE_SHELL_SUMS_H

#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>
#include <CGAL/Jet_fitting_3/numeric/moment_sums.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/nested_degrees.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// What a neighbor contributes, in lengths of some unit: with normals the potential of the Gauss map stands for the
/// height, see fit_gauss_map().
struct Local_sample
{
  double u, v, height, slope_u, slope_v;
  double lever;  ///< the square of what noise of the normal counts for in the height
  double square; ///< of the distance from the origin
  bool is_there; ///< not on another sheet, and its normal known
};

/// What neighbors contribute to the normal equations of all degrees up to 4: sums over them, which nest over balls and
/// over degrees. A matrix of normal equations has only moments for entries, 45 of them.
struct Shell_sums
{
  std::array<double, number_of_jet_coefficients(2 * highest_nested_degree)> moments{}; ///< of u^i v^j
  std::array<double, number_of_unknowns> heights{};                                    ///< of u^i v^j times the height
  /// @{
  /// Of u^i v^j times the slopes.
  std::array<double, number_of_unknowns> slopes_u{}, slopes_v{};
  /// @}
  double squared_heights = 0, squared_slopes = 0;
  double levers = 0; ///< of Local_sample

  /// Number of neighbors.
  double size() const { return moments[0]; }

  /// Neighbors without normals: (u, v, height).
  /// \tparam degree of fits, at most: only sums for these are formed
  template <std::size_t degree>
  void add(const Vector_3<double>* neighbors, std::size_t count)
  {
    numeric::add_moments<2 * degree, degree>(neighbors, count, moments.data(), heights.data());
    for (std::size_t k = 0; k < count; ++k) squared_heights += neighbors[k].z * neighbors[k].z;
  }

  /// Neighbors whose normals give the slopes.
  void add(const Local_sample* neighbors, std::size_t count)
  {
    using numeric::moment_sums::lanes_of;
    const auto load = [neighbors](std::size_t first, std::size_t n) {
      const auto pack = [&](const auto& number) {
        return lanes_of(n, [&](std::size_t i) { return number(neighbors[first + i]); });
      };
      return numeric::moment_sums::Packed_samples<3>{pack([](const Local_sample& s) { return s.u; }),
                                                     pack([](const Local_sample& s) { return s.v; }),
                                                     numeric::moment_sums::weights(n),
                                                     {pack([](const Local_sample& s) { return s.height; }),
                                                      pack([](const Local_sample& s) { return s.slope_u; }),
                                                      pack([](const Local_sample& s) { return s.slope_v; })}};
    };
    numeric::add_moments_of<2 * highest_nested_degree, highest_nested_degree, 3>(count, load, moments.data(),
                                                                                 {heights.data(), slopes_u.data(),
                                                                                  slopes_v.data()});
    for (std::size_t k = 0; k < count; ++k) {
      const Local_sample& s = neighbors[k];
      squared_heights += s.height * s.height;
      levers += s.lever;
      squared_slopes += s.slope_u * s.slope_u + s.slope_v * s.slope_v;
    }
  }
};

/// What fits of heights and of round heights need, see Round_fit: sums for z, z^2, and z (u^2 + v^2 + z^2), of which
/// those for z are the heights.
struct Round_sums : Shell_sums
{
  std::array<double, number_of_unknowns> of_squares{}, of_cubes{};
  std::array<std::array<double, 3>, 3> products{}; ///< of each two of the three

  /// Neighbors without normals, see Shell_sums.
  template <std::size_t degree>
  void add(const Vector_3<double>* neighbors, std::size_t count)
  {
    numeric::add_moments<2 * degree, degree, 3>(neighbors, count, moments.data(),
                                                {heights.data(), of_squares.data(), of_cubes.data()});
    using namespace numeric::moment_sums;
    std::array<std::array<Lanes, 3>, 3> sums;
    for (auto& row : sums) row.fill(0);
    for (std::size_t k = 0; k < count; k += lanes) {
      const Packed_samples<3> s = with_heights<3>(neighbors + k, count - k);
      for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = a; b < 3; ++b) sums[a][b] = sums[a][b] + s.of[a] * s.of[b];
    }
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = a; b < 3; ++b) products[a][b] += numeric::sum_of_lanes(sums[a][b]);
  }

  /// Less some of the neighbors, which were added to both.
  Round_sums& operator-=(const Round_sums& other)
  {
    const auto subtract_all = [](auto& from, const auto& what) {
      for (std::size_t k = 0; k < from.size(); ++k) from[k] -= what[k];
    };
    subtract_all(moments, other.moments);
    subtract_all(heights, other.heights);
    subtract_all(of_squares, other.of_squares);
    subtract_all(of_cubes, other.of_cubes);
    for (std::size_t a = 0; a < 3; ++a) subtract_all(products[a], other.products[a]);
    return *this;
  }
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_SHELL_SUMS_H
