// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_UNIT_CLOUD_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_UNIT_CLOUD_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/fitting/outliers.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Ball_search.h>
#include <CGAL/Jet_fitting_3/internal/machine/parallel.h>
#include <CGAL/Jet_fitting_3/internal/tables/Sample_tables.h>
#include <CGAL/Jet_fitting_3/internal/tables/Unit_normals.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/number.h>
#include <CGAL/Jet_fitting_3/scale/Cloud.h>
#include <CGAL/Jet_fitting_3/scale/near_copies.h>
#include <CGAL/Jet_fitting_3/scale/sides_and_links.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// See Automatic_scale: several at a time.
template <class ConcurrencyTag>
struct For_each_sample
{
  template <class Body>
  void operator()(std::size_t count, const Body& body) const
  {
    constexpr std::size_t at_a_time = 8;
    for_each_number<ConcurrencyTag>(count, body, at_a_time);
  }
};

/// Samples as automatic() and estimate_noise() take them: near the origin, half of them within 1 in each coordinate,
/// with a search for neighbors. The tables must outlive it.
template <class Kernel>
class Unit_cloud
{
  using Tables = Sample_tables<Kernel>;

public:
  using Search = Ball_search<typename Tables::Number>;

  /// \param normals in the order of the samples, or none
  Unit_cloud(const Tables& tables, const Unit_normals& normals)
    : m_places(offsets_from_middle(tables)), m_per_length(brought_to_unit_size(m_places)), m_normals(values(normals)),
      m_search(tables.samples, m_per_length)
  {
    m_search.leave_out(scale::near_copies(cloud(), m_search));
  }

  Unit_cloud(const Unit_cloud&) = delete;
  Unit_cloud& operator=(const Unit_cloud&) = delete;

  scale::Cloud cloud() const
  {
    return {m_places.data(), m_normals.empty() ? nullptr : m_normals.data(), m_places.size(),
            m_outliers.empty() ? nullptr : m_outliers.data()};
  }
  bool is_outlier(Index sample) const { return !m_outliers.empty() && m_outliers[sample]; }

  /// Leaves out the outliers, and normals that are wrong. \param for_each see Automatic_scale
  template <class For_each>
  void leave_out_outliers(const For_each& for_each)
  {
    const Outliers found = outliers(cloud(), m_search, least_radii(), for_each);
    if (number_of(found.points) > 0) m_outliers = found.points;
    m_search.leave_out(m_outliers);
    m_wrong_normals = number_of(found.normals);
    for (std::size_t i = 0; i < m_normals.size(); ++i)
      if (found.normals[i]) m_normals[i] = {0, 0, 0};
  }
  /// Leaves out, from then on, as neighbors of a sample those beyond a sharp edge. \param for_each see Automatic_scale
  template <class For_each>
  void keep_to_sides(const For_each& for_each)
  {
    constexpr scale::Allowed_turn turn = scale::Allowed_turn::by_smaller_curvature;
    m_search.keep_to_sides(scale::sides_and_links(cloud(), turn, m_search, least_radii(), for_each).linked);
  }

  /// Those that are left out.
  std::size_t wrong_normals() const { return m_wrong_normals; }

  const Search& search() const { return m_search; }
  /// How many units one length is.
  double per_length() const { return m_per_length; }

private:
  /// Of balls around all samples that hold the least neighbors, outliers among them.
  const std::vector<double>& least_radii()
  {
    if (m_least_radii.empty())
      m_least_radii =
          radii_of_balls(cloud(), m_search, scale::spread_indices(m_places.size(), 1), across_lines(cloud(), m_search));
    return m_least_radii;
  }

  static std::vector<Vector_3<double>> offsets_from_middle(const Tables& tables)
  {
    std::vector<Vector_3<double>> result(tables.size());
    if (tables.size() == 0) return result;
    const auto middle = tables.points.middle();
    for (Index s = 0; s < tables.size(); ++s) result[s] = tables.points.template offset<double>(middle, s);
    return result;
  }

  /// In a unit in which half of them are of size 1 at most. Places that are very far away are brought to where squares
  /// do not overflow. \return how many units one length is
  static double brought_to_unit_size(std::vector<Vector_3<double>>& places)
  {
    std::vector<double> sizes;
    for (const Vector_3<double>& p : places) sizes.push_back((std::max)({std::abs(p.x), std::abs(p.y), std::abs(p.z)}));
    if (sizes.empty()) return 1;
    const auto median = sizes.begin() + std::ptrdiff_t(sizes.size() / 2);
    std::nth_element(sizes.begin(), median, sizes.end());
    const double per_length = 1 / numeric::power_of_two_above(*median), most = 0x1p300;
    const auto in_units = [&](double x) { return (std::min)((std::max)(per_length * x, -most), most); };
    for (Vector_3<double>& p : places) p = {in_units(p.x), in_units(p.y), in_units(p.z)};
    return per_length;
  }

  static std::size_t number_of(const std::vector<char>& flags)
  {
    return std::size_t(std::count(flags.begin(), flags.end(), char(1)));
  }

  static std::vector<Vector_3<double>> values(const Unit_normals& normals)
  {
    std::vector<Vector_3<double>> result;
    for (Index i = 0; i < normals.size(); ++i) result.push_back(normals[i]);
    return result;
  }

  std::vector<Vector_3<double>> m_places; // of the samples, in units
  double m_per_length;
  std::vector<Vector_3<double>> m_normals;
  std::vector<char> m_outliers; // flags, if they are left out
  std::size_t m_wrong_normals = 0;
  std::vector<double> m_least_radii; // once they are asked for
  Search m_search;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_UNIT_CLOUD_H
