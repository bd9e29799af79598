// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_SECOND_ORDER_H
#define CGAL_JET_FITTING_3_SCALE_SECOND_ORDER_H

#include <CGAL/Jet_fitting_3/numeric/binary_form.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>
#include <CGAL/Jet_fitting_3/scale/Nested_fit.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Round heights over a tangent plane, z - (k1 + k2) z^2 / 2 + k1 k2 z |p|^2 / 4 at the place p = (u, v, z), are a
/// polynomial of degree 2 on planes, spheres, and cylinders, and along all principal sections that are circles. They
/// have the slopes and second derivatives of heights, and on spheres and cylinders the same noise everywhere. k1 and k2
/// are those that the fit finds.
struct Roundness
{
  double sum = 0, product = 0; ///< of k1 and k2

  /// The factors of z, z^2, and z |p|^2.
  std::array<double, 3> factors() const { return {1, -sum / 2, product / 4}; }

  /// \tparam FT a number or a pack
  template <class FT>
  FT height(const Vector_3<FT>& p) const
  {
    return p.z * (1 - sum * p.z / 2 + product * dot(p, p) / 4);
  }
};

/// How the jet of the surface at the origin follows from that of its round heights where they are not 0 there: the
/// height, and how much less, then by which factor more are slopes and second derivatives, of xx and yy. Products of
/// slopes are left out.
struct Over_origin
{
  double height, less, factor;

  Over_origin(double round_height, const Roundness& round)
    : height(round_height * (1 + round.sum * round_height / 2)), less(round.product * height / 2),
      factor(1 / (1 - round.sum * height))
  {}
};

/// What a candidate says of the slopes and second derivatives at the origin: (J_x, J_y, J_xx, sqrt(2) J_xy, J_yy). The
/// squares of the first two, and of the last three, add up to the same in all axes.
struct Second_order
{
  double height = 0;       ///< at the origin
  Roundness round;         ///< of the round heights that were fitted; 0 if that was to heights
  double noise_factor = 1; ///< of noise in the samples over that of the covariance
  double misfit = 1;       ///< what the fit leaves, over what noise would, in variances
  std::array<double, 5> value{};
  Covariance covariance{};
};

/// The fits of a radius, and their numbers of neighbors.
struct Fits_of_radius
{
  std::array<double, 3> sizes{};
  std::array<Second_order, 3> fits;
};

/// Values times factors, and the lengths of a fit in a unit.
inline Second_order scaled(Second_order s, const std::array<double, 5>& factors, double unit)
{
  s.height *= unit;
  s.round.sum /= unit;
  s.round.product /= unit * unit;
  for (std::size_t a = 0; a < 5; ++a) {
    s.value[a] *= factors[a];
    for (std::size_t b = 0; b < 5; ++b) s.covariance[a][b] *= factors[a] * factors[b];
  }
  return s;
}

/// What samples say that do not determine the jet: covariances are infinite.
inline Second_order undetermined()
{
  Second_order result;
  for (auto& row : result.covariance) row.fill(std::numeric_limits<double>::infinity());
  return result;
}

/// From a fit that determines the degree, with the unit in which its lengths were measured, and its covariance().
inline Second_order second_order(const Nested_fit& fit, std::size_t degree, double unit, const Covariance& covariance)
{
  Second_order result;
  result.height = fit.coefficient(0, degree);
  result.noise_factor = result.misfit = fit.noise_factor(degree);
  for (std::size_t a = 0; a < 5; ++a) result.value[a] = fit.coefficient(a + 1, degree);
  result.covariance = covariance;
  return scaled(result, {1, 1, 2 / unit, std::sqrt(2.) / unit, 2 / unit}, unit);
}

inline Second_order second_order(const Nested_fit& fit, std::size_t degree, double unit)
{
  return fit.determines(degree) ? second_order(fit, degree, unit, fit.covariance(degree)) : undetermined();
}

/// With a variance that contains misfit: what a fit leaves is noise of its estimates, because samples are spread by
/// chance, but far less than noise of its size where it is smooth. Half of it counts.
inline Second_order with_misfit_as_noise(Second_order s)
{
  const double factor = std::max(1., s.noise_factor / 2);
  for (auto& row : s.covariance)
    for (double& c : row) c *= factor;
  s.noise_factor /= factor;
  return s;
}

/// Of both slopes together.
inline double variance_of_slopes(const Second_order& fit) { return fit.covariance[0][0] + fit.covariance[1][1]; }

/// The values in axes that are turned by an angle from x to y, with the variances of each.
struct Turned_second_order
{
  double height, noise_factor, misfit;
  Roundness round;
  std::array<double, 5> value;
  double slopes_variance;         ///< of both slopes together
  std::array<double, 3> variance; ///< of the second derivatives
};

/// In turned axes.
inline Turned_second_order turned(const Second_order& s, double cosine, double sine)
{
  const auto turn = numeric::second_derivatives_map(cosine, sine).rows;
  Turned_second_order t;
  t.height = s.height;
  t.noise_factor = s.noise_factor;
  t.misfit = s.misfit;
  t.round = s.round;
  t.value[0] = cosine * s.value[0] + sine * s.value[1];
  t.value[1] = cosine * s.value[1] - sine * s.value[0];
  t.slopes_variance = variance_of_slopes(s);
  for (std::size_t i = 0; i < 3; ++i) {
    t.value[2 + i] = t.variance[i] = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      t.value[2 + i] += turn[i][k] * s.value[2 + k];
      for (std::size_t l = 0; l < 3; ++l) t.variance[i] += turn[i][k] * turn[i][l] * s.covariance[2 + k][2 + l];
    }
    if (!(t.variance[i] < std::numeric_limits<double>::infinity())) // a difference of infinities
      t.variance[i] = std::numeric_limits<double>::infinity();
  }
  return t;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_SECOND_ORDER_H
