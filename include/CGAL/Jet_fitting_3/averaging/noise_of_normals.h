// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_NOISE_OF_NORMALS_H
#define CGAL_JET_FITTING_3_AVERAGING_NOISE_OF_NORMALS_H

#include <CGAL/Jet_fitting_3/averaging/Height.h>
#include <CGAL/Jet_fitting_3/averaging/noise_of_surface.h>
#include <CGAL/Jet_fitting_3/scale/Estimated_variance.h>
#include <CGAL/Jet_fitting_3/scale/Polynomial_value.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// A fit to the slopes of normals alone, of the height of the points in the mean.
class Fit_to_slopes
{
public:
  /// \param normals slope_of() them exists
  Fit_to_slopes(std::vector<Vector_3<double>> places, std::vector<Vector_3<double>> normals, std::size_t degree)
    : m_places(std::move(places)), m_normals(std::move(normals)), m_degree(degree)
  {
    if (2 * m_places.size() < unknowns() + 8) return;
    std::vector<Slope> slopes;
    for (const Vector_3<double>& n : m_normals) slopes.push_back(*slope_of(n));
    Moments moments;
    moments.slope_weight = 1e12; // heights have no say
    add_for_degree(degree, false, [&](auto highest, auto) {
      moments.add<highest>(m_places.data(), m_places.size());
      moments.add_slopes<highest>(m_places.data(), slopes.data(), m_places.size());
    });
    const Normal_matrix matrix(moments, degree);
    if (matrix.is_regular()) m_solution = matrix.solution(moments.heights, degree);
  }

  /// The mean square of the difference of the normals from those of the fit, per degree of freedom of components, or
  /// infinity; made that of the variance as residual_variance() does.
  double variance_of_normals() const
  {
    return variance(2 * m_places.size(), unknowns(),
                    [](const scale::Polynomial_value& fitted, const auto&, const auto& normal) {
                      return square_of_difference(fitted, normal);
                    });
  }

  /// Of a normal from that of the fit, an angle; none if the samples do not determine it.
  std::optional<double> difference(const Vector_3<double>& place, const Vector_3<double>& normal) const
  {
    if (!m_solution) return std::nullopt;
    return std::sqrt(square_of_difference(fitted_at(place), normal));
  }

  /// Likewise of the heights of the points, along the normals.
  double variance_of_heights() const
  {
    return variance(m_places.size(), 1,
                    [](const scale::Polynomial_value& fitted, const auto& place, const auto& normal) {
                      const double along = (place.z - fitted.height) * normal.z;
                      return along * along;
                    });
  }

private:
  // Of a normal and that of the fit.
  static double square_of_difference(const scale::Polynomial_value& fitted, const Vector_3<double>& normal)
  {
    const Vector_3<double> n = axes_around(Vector_3<double>{-fitted.slope_u, -fitted.slope_v, 1}).z;
    const Vector_3<double> across = cross(n, normal);
    return dot(across, across);
  }

  scale::Polynomial_value fitted_at(const Vector_3<double>& place) const
  {
    return scale::value_at(m_solution->data(), m_degree, place.x, place.y);
  }

  // Without the constant.
  std::size_t unknowns() const { return number_of_jet_coefficients(m_degree) - 1; }

  template <class Square>
  double variance(std::size_t equations, std::size_t unknowns, const Square& square) const
  {
    if (!m_solution) return std::numeric_limits<double>::infinity();
    double sum = 0;
    for (std::size_t k = 0; k < m_places.size(); ++k) sum += square(fitted_at(m_places[k]), m_places[k], m_normals[k]);
    const double freedom = double(equations - unknowns);
    return scale::median_correction(freedom) * sum / freedom;
  }

  std::vector<Vector_3<double>> m_places, m_normals;
  std::size_t m_degree;
  std::optional<Coefficients> m_solution;
};

/// Of a degree to the first so many of the vertices, in a frame and per unit, without those whose normals tell no
/// slopes.
/// \param normals of length 1, one for each point; those that are unknown are 0
template <class Neighbors>
Fit_to_slopes fit_to_slopes(const Surface_points<Neighbors>& surface, const std::vector<Vector_3<double>>& normals,
                            const Local_frame& frame, const std::vector<std::size_t>& vertices, std::size_t count,
                            std::size_t degree, double unit)
{
  std::vector<Vector_3<double>> places, in_frame;
  for (std::size_t k = 0; k < count; ++k) {
    const Vector_3<double> n = frame.axes.in(normals[vertices[k]]);
    if (!slope_of(n)) continue;
    places.push_back(1 / unit * frame.in(surface.points[vertices[k]]));
    in_frame.push_back(n);
  }
  return Fit_to_slopes(std::move(places), std::move(in_frame), degree);
}

/// What fits to the slopes of normals leave to two rings and more: variance_of(fit).
/// \param normals as for fit_to_slopes()
template <class Neighbors, class Variance_of>
Size_of_noise noise_beside_slopes(const Surface_points<Neighbors>& surface,
                                  const std::vector<Vector_3<double>>& normals, const Variance_of& variance_of)
{
  constexpr std::size_t first_ring = 2;
  const auto variance = [&](const Local_frame& frame, const auto& vertices, std::size_t count, std::size_t degree,
                            double unit, Height) {
    return variance_of(fit_to_slopes(surface, normals, frame, vertices, count, degree, unit));
  };
  return noise_at_places(residuals_at_places(surface, first_ring, {4, 6}, Residuals_at_place::least_rings, variance),
                         surface.points.size(), first_ring);
}

/// That of the normals.
template <class Neighbors>
Size_of_noise noise_of_normals(const Surface_points<Neighbors>& surface, const std::vector<Vector_3<double>>& normals)
{
  return noise_beside_slopes(surface, normals, [](const Fit_to_slopes& fit) { return fit.variance_of_normals(); });
}

/// That of the points, in their units, if both ends of an edge say how far one lies above the other: not less, and more
/// by what their normals err. These heights are of third order, and nothing on planes, spheres, and circles of a torus.
template <class Neighbors>
double noise_beside_normals_of_edges(const Surface_points<Neighbors>& surface,
                                     const std::vector<Vector_3<double>>& normals)
{
  std::vector<double> squares;
  for (std::size_t i = 0; i < surface.points.size(); ++i)
    for (const std::size_t v : surface.neighbors(i)) {
      if (!(dot(normals[i], normals[i]) > 0 && dot(normals[v], normals[v]) > 0)) continue;
      const double height = dot(normals[i] + normals[v], surface.points[v] - surface.points[i]) / 2;
      squares.push_back(height * height / (2 * surface.units[i] * surface.units[i]));
    }
  return squares.empty() ? std::numeric_limits<double>::infinity()
                         : deviation_per_median * std::sqrt(scale::median(std::move(squares)));
}

/// Likewise, with what fits to the slopes say.
template <class Neighbors>
double noise_beside_normals(const Surface_points<Neighbors>& surface, const std::vector<Vector_3<double>>& normals)
{
  const auto of_heights = [](const Fit_to_slopes& fit) { return fit.variance_of_heights(); };
  return std::min(noise_beside_slopes(surface, normals, of_heights).value,
                  noise_beside_normals_of_edges(surface, normals));
}

/// At places of a surface, what given normals deviate from those of fits to three rings: which part of what those of
/// the faces deviate is in it, and the squares of both.
struct Deviations_of_normals
{
  std::vector<double> shares, squares_of_given, squares_of_faces;
};

template <std::size_t degree, class Neighbors>
Deviations_of_normals deviations_of_normals(const Surface_points<Neighbors>& surface,
                                            const std::vector<Vector_3<double>>& given,
                                            const std::vector<Vector_3<double>>& of_faces)
{
  Deviations_of_normals result;
  visit_places(surface, 3, [&](std::size_t i, const Local_frame& frame, const auto& found, const auto&) {
    const std::vector<Vector_3<double>> local =
        places_over(surface, frame, found, found.size(), surface.units[i], Height::z);
    Moments moments;
    moments.add<degree>(local.data(), local.size());
    const Normal_matrix matrix(moments, degree);
    if (local.size() < number_of_jet_coefficients(degree) + 8 || !matrix.is_regular()) return;
    const auto c = matrix.solution(moments.heights, 1);
    const std::optional<Slope> a = slope_of(frame.axes.in(given[i])), b = slope_of(frame.axes.in(of_faces[i]));
    if (!a || !b) return;
    const Slope first{a->x - c[1], a->y - c[2]}, second{b->x - c[1], b->y - c[2]};
    result.squares_of_given.push_back(first.x * first.x + first.y * first.y);
    result.squares_of_faces.push_back(second.x * second.x + second.y * second.y);
    if (result.squares_of_faces.back() > 0)
      result.shares.push_back((first.x * second.x + first.y * second.y) / result.squares_of_faces.back());
  });
  return result;
}

/// Whether normals follow from those of the faces, as far as fits tell: half of what these deviate is in given ones,
/// too, and these do not deviate by far more. Of independent normals it is nothing in the mean, whatever the noise of
/// both: the error of a least squares fit is uncorrelated with what other estimates differ from it. But a bias of the
/// fit is in both: without noise that of degree 4 may be most of it, and with noise degree 6 is too near to the
/// samples, so it must be so for both.
template <class Neighbors>
bool follow_from_faces(const Surface_points<Neighbors>& surface, const std::vector<Vector_3<double>>& given,
                       const std::vector<Vector_3<double>>& of_faces)
{
  constexpr double dependent = 0.5, far = 4; // square
  const Deviations_of_normals low = deviations_of_normals<4>(surface, given, of_faces);
  if (low.shares.empty() || !(scale::median(low.shares) > dependent) ||
      scale::median(low.squares_of_given) >= far * scale::median(low.squares_of_faces))
    return false;
  const std::vector<double> shares = deviations_of_normals<6>(surface, given, of_faces).shares;
  return shares.empty() || scale::median(shares) > dependent;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_NOISE_OF_NORMALS_H
