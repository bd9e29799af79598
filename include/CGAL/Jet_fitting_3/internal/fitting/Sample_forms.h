// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_SAMPLE_FORMS_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_SAMPLE_FORMS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/fitting/Packed_forms.h>
#include <CGAL/Jet_fitting_3/internal/fitting/estimate_blocks.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Rows.h>
#include <CGAL/Jet_fitting_3/internal/tables/Normal_table.h>
#include <CGAL/Jet_fitting_3/internal/tables/Sample_set.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
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

/// Which places in the output are for each row: points at one place share a row.
class Outputs_of_rows
{
public:
  /// One for each row; refers to the table.
  explicit Outputs_of_rows(const std::vector<Index>& output_of_row) : m_outputs(output_of_row.data()) {}

  /// \param row_of_output has no_index where there is none
  Outputs_of_rows(const std::vector<Index>& row_of_output, std::size_t number_of_rows)
    : m_ends(number_of_rows + 2), m_sorted(row_of_output.size()), m_outputs(m_sorted.data())
  {
    for (const Index row : row_of_output)
      if (row != no_index) ++m_ends[row + std::size_t(2)];
    std::partial_sum(m_ends.begin(), m_ends.end(), m_ends.begin());
    for (Index i = 0; i < row_of_output.size(); ++i)
      if (row_of_output[i] != no_index) m_sorted[m_ends[row_of_output[i] + std::size_t(1)]++] = i;
  }

  Outputs_of_rows(const Outputs_of_rows&) = delete;
  Outputs_of_rows& operator=(const Outputs_of_rows&) = delete;

  const Index* begin(std::size_t row) const { return m_outputs + (m_ends.empty() ? row : m_ends[row]); }
  const Index* end(std::size_t row) const { return m_outputs + (m_ends.empty() ? row + 1 : m_ends[row + 1]); }

private:
  std::vector<std::size_t> m_ends;
  std::vector<Index> m_sorted;
  const Index* m_outputs;
};

/// Takes the forms of samples, as they come, for the points at their places, each on the side of its normal.
/// \tparam Wanted the numbers of the points, in the order of the output: All_rows or Some_rows
template <class Kernel, class Wanted>
class Sample_forms
{
public:
  /// All is kept by reference.
  /// \param dprime the highest degree of a form
  /// \param seeds of the rows: the number of a sample for each
  template <class Rows, class Number>
  Sample_forms(std::size_t dprime, const Wanted& wanted, const Rows& seeds, const Sample_set<Number>& samples,
               const std::vector<Index>& sample_of, const Normal_table& normals_of_points, bool has_qualities)
    : m_wanted(wanted), m_outputs(outputs_of_rows(wanted, seeds, samples, sample_of)), m_normals(normals_of_points),
      m_places_are_shared(!samples.copies().empty()),
      m_forms(wanted.size(), dprime), m_reports{std::vector<Estimation_status>(wanted.size()),
                                                std::vector<Fit_quality>(has_qualities ? wanted.size() : 0),
                                                false,
                                                {}}
  {
    for (std::size_t i = 0; i < wanted.size(); ++i)
      if (sample_of[wanted[i]] == no_index) m_reports.statuses[i] = Status_flag::not_finite;
  }

  template <class Report>
  void operator()(const Estimated_block<Kernel>& block, const Report& report)
  {
    const std::size_t ahead = 8, size = block.results.size(); // prefetch distance
    for (std::size_t i = 0; i < size; ++i) {
      if (i + ahead < size) m_forms.prefetch(*m_outputs.begin(block.first + i + ahead));
      const Index *const begin = m_outputs.begin(block.first + i), *const end = m_outputs.end(block.first + i);
      for (const Index* output = begin; output != end; ++output) set(*output, block.results[i]);
    }
    report(block);
  }

  /// Writes the forms up to the first that was not reached.
  /// \return the reports of the points, with what those of the rows say of the whole
  template <class ConcurrencyTag, class OutputIterator>
  Estimation_reports write(const Estimation_reports& of_rows, OutputIterator output)
  {
    const auto is_unknown = [](Estimation_status s) { return s.is_unknown(); };
    const auto begin = m_reports.statuses.begin(), end = m_reports.statuses.end(),
               unknown = std::find_if(begin, end, is_unknown);
    std::fill(unknown, end, Estimation_status());
    m_forms.template write<ConcurrencyTag>(std::size_t(unknown - begin), output);
    m_reports.cancelled = of_rows.cancelled;
    m_reports.noise = of_rows.noise;
    return std::move(m_reports);
  }

private:
  template <class Rows, class Number>
  static Outputs_of_rows outputs_of_rows(const Wanted& wanted, const Rows& seeds, const Sample_set<Number>& samples,
                                         const std::vector<Index>& sample_of)
  {
    const bool has_all = std::is_same<Wanted, All_rows>::value;
    if (has_all && samples.copies().empty()) return Outputs_of_rows(samples.tree().numbers());
    std::vector<Index> row_of_output(wanted.size(), Index(no_index));
    for (std::size_t i = 0; i < wanted.size(); ++i)
      if (sample_of[wanted[i]] != no_index) row_of_output[i] = static_cast<Index>(seeds.row_of(sample_of[wanted[i]]));
    return Outputs_of_rows(row_of_output, seeds.size());
  }

  /// The form is on the side of one of the points; where there are others it is turned.
  void set(Index output, const Estimated_form<Kernel>& result)
  {
    m_reports.statuses[output] = result.status;
    if (!result.quality.empty()) m_reports.qualities[output] = result.quality.front();
    if (!m_places_are_shared || !result.status.is_estimated()) return m_forms.set(output, result.form);
    Monge_form<Kernel> form = result.form;
    const bool is_turned = turn_to(form, m_normals[m_wanted[output]]);
    if (is_turned && !result.quality.empty()) m_reports.qualities[output].turn();
    m_forms.set(output, form);
  }

  const Wanted& m_wanted;
  const Outputs_of_rows m_outputs;
  const Normal_table& m_normals;
  bool m_places_are_shared;
  Packed_forms<Kernel> m_forms;
  Estimation_reports m_reports;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_SAMPLE_FORMS_H
