// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_SAMPLE_FORMS_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_SAMPLE_FORMS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/fitting/Kept_forms.h>
#include <CGAL/Jet_fitting_3/internal/fitting/estimate_blocks.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Rows.h>
#include <CGAL/Jet_fitting_3/internal/tables/Normal_table.h>
#include <CGAL/Jet_fitting_3/internal/tables/Sample_set.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The sample of each point; no_index for points that are not finite.
template <class Number>
std::vector<Index> samples_of_points(const Sample_set<Number>& samples, std::size_t number_of_points)
{
  std::vector<Index> result(number_of_points, Index(no_index));
  for (Index s = 0; s < samples.tree().size(); ++s) result[samples.tree().number(s)] = s;
  for (const auto& copy : samples.copies()) result[copy.point] = copy.sample;
  return result;
}

/// The weight of a sample is the largest of those of its points, whatever their order.
template <class Number>
std::vector<double> weights_of_samples(const Sample_set<Number>& samples, const std::vector<double>& weights)
{
  std::vector<double> result;
  if (weights.empty()) return result;
  result = reordered(weights, samples.tree().numbers());
  for (const auto& copy : samples.copies()) result[copy.sample] = (std::max)(result[copy.sample], weights[copy.point]);
  return result;
}

/// The forms of samples.
template <class Kernel>
class Sample_forms : public Kept_forms<Kernel>
{
public:
  using Kept_forms<Kernel>::Kept_forms;

  /// Gives its form to each point that is wanted, in order, up to the first that was not reached: points at one place
  /// have the same, each on the side of its normal.
  /// \param wanted points, All_rows or Some_rows
  /// \param rows of samples that were estimated
  /// \param sample_of each point
  /// \return the reports of the points
  template <class Wanted, class Rows, class Number, class OutputIterator>
  Estimation_reports distribute(const Wanted& wanted, const Rows& rows, const Sample_set<Number>& samples,
                                const std::vector<Index>& sample_of, const Normal_table& normals_of_points,
                                Estimation_reports&& of_rows, OutputIterator output)
  {
    Estimation_reports reports{std::vector<Estimation_status>(wanted.size()),
                               std::vector<Fit_quality>(of_rows.qualities.empty() ? 0 : wanted.size()),
                               of_rows.cancelled};
    const bool is_used_once = std::is_same<Wanted, All_rows>::value && samples.copies().empty();
    for (std::size_t w = 0; w < wanted.size(); ++w) {
      const Index i = wanted[w], s = sample_of[i];
      Estimated_form<Kernel> result = s == no_index ? of_bad_point() : of_row(rows.row_of(s), of_rows, is_used_once);
      if (result.status.is_unknown()) break;
      if (s != no_index && samples.tree().number(s) != i && result.status.is_estimated())
        orient(result, normals_of_points[i]);
      reports.statuses[w] = result.status;
      if (!result.quality.empty()) reports.qualities[w] = std::move(result.quality.front());
      *output++ = std::move(result.form);
    }
    return reports;
  }

private:
  static Estimated_form<Kernel> of_bad_point() { return {{}, Status_flag::not_finite, {}}; }

  Estimated_form<Kernel> of_row(std::size_t row, const Estimation_reports& reports, bool is_last_use)
  {
    Estimated_form<Kernel> result{is_last_use ? std::move(m_forms[row]) : m_forms[row], reports.statuses[row], {}};
    if (!reports.qualities.empty()) result.quality.push_back(reports.qualities[row]);
    return result;
  }

  using Kept_forms<Kernel>::m_forms;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_SAMPLE_FORMS_H
