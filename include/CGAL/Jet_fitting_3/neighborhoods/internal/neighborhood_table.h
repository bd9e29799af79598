// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NEIGHBORHOODS_INTERNAL_NEIGHBORHOOD_TABLE_H
#define CGAL_JET_FITTING_3_NEIGHBORHOODS_INTERNAL_NEIGHBORHOOD_TABLE_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Options.h>
#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/internal/Index.h>
#include <CGAL/Jet_fitting_3/neighborhoods/Neighborhood_quality.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Monge_via_jet_fitting.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// The median of those values that are numbers; not a number where they are no majority.
inline double median(std::vector<double> values)
{
  const auto end = std::partition(values.begin(), values.end(), [](double x) { return !std::isnan(x); });
  const auto count = end - values.begin();
  if (2 * count <= std::ptrdiff_t(values.size())) return not_a_number;
  std::nth_element(values.begin(), values.begin() + count / 2, end);
  return values[std::size_t(count / 2)];
}

/// Root of the mean square over the coefficients of one order; not a number where the form has none.
inline double error_of_order(std::size_t order, const Standard_errors<double>& errors)
{
  const std::size_t first = monge_offset(order), last = monge_offset(order + 1);
  if (last > errors.coefficients.size()) return not_a_number;
  double sum = 0;
  for (std::size_t i = first; i < last; ++i) sum += errors.coefficients[i] * errors.coefficients[i];
  return std::sqrt(sum / double(last - first));
}

/// Fits jets to neighborhoods of single vertices or points.
/// \tparam Tables of a mesh or a point set
template <class Tables>
class Neighborhood_estimator
{
  using Kernel = typename Tables::Kernel;
  using Estimator = CGAL::Monge_via_jet_fitting<Kernel>;

public:
  Neighborhood_estimator(const Tables& tables, const Fit_options& options)
    : m_tables(tables), m_point_weights(options.point_weights), m_options(options)
  {
    if (!m_point_weights.empty()) normalization_of_weights(m_point_weights, tables.size());
    m_options.standard_errors = true;
  }

  void set_neighborhood(const std::vector<Index>& row)
  {
    m_points.clear();
    m_options.point_weights.clear();
    m_radius = 0;
    for (const Index i : row) {
      m_points.push_back(m_tables.points[i]);
      if (!m_point_weights.empty()) m_options.point_weights.push_back(m_point_weights[i]);
      const Vector_3<double> r = m_tables.points.template offset<double>(row.front(), i);
      m_radius = (std::max)(m_radius, std::sqrt(dot(r, r)));
    }
  }

  double radius() const { return m_radius; }
  std::size_t number_of_points() const { return m_points.size(); }
  bool has_enough_points(std::size_t d) const { return number_of_points() >= number_of_jet_coefficients(d); }

  typename Estimator::Estimate fit(std::size_t d) const
  {
    return Estimator().estimate(m_points.begin(), m_points.end(), d, (std::min)(d, std::size_t(4)), m_options);
  }

private:
  const Tables& m_tables;
  const std::vector<double>& m_point_weights; // of all; m_options holds those of the neighborhood
  Fit_options m_options;
  std::vector<typename Kernel::Point_3> m_points;
  double m_radius = 0;
};

/// What the sample says about one neighborhood and one degree.
struct Quality_samples
{
  std::vector<double> points, radius, noise, condition_number, normal_error, k_error, b_error, c_error, k_change;

  template <class Tables>
  void add(const Neighborhood_estimator<Tables>& fitter, std::size_t d)
  {
    if (!fitter.has_enough_points(d)) return;
    const auto estimate = fitter.fit(d);
    if (estimate.status() == Fit_status::rank_deficient) return;
    const Standard_errors<double>& errors = estimate.standard_errors();
    const double parameters = double(number_of_jet_coefficients(d)), freedom = errors.degrees_of_freedom;
    points.push_back(double(fitter.number_of_points()));
    radius.push_back(fitter.radius());
    noise.push_back(freedom > 0 ? estimate.residual_rms() * std::sqrt((freedom + parameters) / freedom) : not_a_number);
    condition_number.push_back(estimate.condition_number());
    normal_error.push_back(std::hypot(errors.normal_along_d1, errors.normal_along_d2));
    k_error.push_back(error_of_order(2, errors));
    b_error.push_back(error_of_order(3, errors));
    c_error.push_back(error_of_order(4, errors));
    k_change.push_back(change_of_curvatures(fitter, d, estimate.details().coefficients));
  }

  /// On neighborhoods that are balanced around p an odd order hardly changes the even ones below it.
  template <class Tables>
  static double change_of_curvatures(const Neighborhood_estimator<Tables>& fitter, std::size_t d,
                                     const Monge_coefficients<double>& k)
  {
    const std::size_t next_even = d / 2 * 2 + 2;
    if (d < 2 || !fitter.has_enough_points(next_even)) return not_a_number;
    const auto estimate = fitter.fit(next_even);
    if (estimate.status() == Fit_status::rank_deficient) return not_a_number;
    const auto& other = estimate.details().coefficients;
    return std::sqrt(0.5) * std::hypot(k[0] - other[0], k[1] - other[1]);
  }

  Neighborhood_quality medians(std::size_t neighborhood, std::size_t d) const
  {
    Neighborhood_quality row;
    row.neighborhood = neighborhood;
    row.degree = d;
    row.fits = points.size();
    row.number_of_points = median(points);
    row.radius = median(radius);
    row.noise = median(noise);
    row.condition_number = median(condition_number);
    row.normal_error = median(normal_error);
    row.k_error = median(k_error);
    row.b_error = median(b_error);
    row.c_error = median(c_error);
    row.k_change = median(k_change);
    return row;
  }
};

/// \param gather(neighborhood, seed, row) appends a neighborhood, the seed first
template <class Tables, class Neighborhood, class Gather>
std::vector<Neighborhood_quality> neighborhood_table(const Tables& tables, const std::vector<Index>& seeds,
                                                     const std::vector<Neighborhood>& neighborhoods,
                                                     const std::vector<std::size_t>& degrees,
                                                     const Fit_options& options, const Gather& gather)
{
  for (const std::size_t d : degrees) check_degrees(d, 1);
  for (const Index seed : seeds)
    if (seed == no_index)
      throw Invalid_input("the sample holds a vertex or point that does not belong to the mesh or range");
  Neighborhood_estimator<Tables> fitter(tables, options);
  std::vector<Neighborhood_quality> table;
  std::vector<Index> row;
  for (std::size_t n = 0; n < neighborhoods.size(); ++n) {
    std::vector<Quality_samples> samples(degrees.size());
    for (const Index seed : seeds) {
      if (!tables.points.is_finite(seed)) continue;
      row.clear();
      gather(neighborhoods[n], seed, row);
      fitter.set_neighborhood(row);
      for (std::size_t i = 0; i < degrees.size(); ++i) samples[i].add(fitter, degrees[i]);
    }
    for (std::size_t i = 0; i < degrees.size(); ++i) table.push_back(samples[i].medians(n, degrees[i]));
  }
  return table;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NEIGHBORHOODS_INTERNAL_NEIGHBORHOOD_TABLE_H
