// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_FITTING_ESTIMATE_BLOCKS_H
#define CGAL_JET_FITTING_3_INTERNAL_FITTING_ESTIMATE_BLOCKS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Estimation_status.h>
#include <CGAL/Jet_fitting_3/Estimation_summary.h>
#include <CGAL/Jet_fitting_3/internal/fitting/estimate_rows.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Neighborhood_block.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Rows.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Seeds.h>
#include <CGAL/Jet_fitting_3/internal/machine/Serial_writer.h>
#include <CGAL/Jet_fitting_3/internal/machine/parallel.h>
#include <CGAL/Jet_fitting_3/internal/tables/Normal_table.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

using Progress = std::function<bool(double)>;

/// The forms of consecutive rows.
template <class DataKernel>
struct Estimated_block
{
  Index first;
  std::vector<Estimated_form<DataKernel>> results;
};

/// Turns a form to the side of a normal. \return whether d1 was reversed: then so are the standard errors
template <class DataKernel>
bool turn_to(Monge_form<DataKernel>& form, const Vector_3<float>& normal)
{
  const auto d1 = form.maximal_principal_direction();
  form.comply_wrt_given_normal(typename DataKernel::Vector_3(normal.x, normal.y, normal.z));
  return d1 != form.maximal_principal_direction();
}

/// Turns a form, and its errors, to the side of a normal.
template <class DataKernel>
void orient(Estimated_form<DataKernel>& result, const Vector_3<float>& normal)
{
  if (turn_to(result.form, normal))
    for (Fit_quality& quality : result.quality) quality.turn();
}

/// What is known of all rows after the estimation, besides their forms.
struct Estimation_reports
{
  std::vector<Estimation_status> statuses;
  std::vector<Fit_quality> qualities; ///< if asked for
  bool cancelled;
  Noise noise; ///< that automatic() has found

  template <class DataKernel>
  void take(const Estimated_block<DataKernel>& block)
  {
    for (std::size_t i = 0; i < block.results.size(); ++i) {
      const Estimated_form<DataKernel>& result = block.results[i];
      statuses[block.first + i] = result.status;
      if (!result.quality.empty()) qualities[block.first + i] = result.quality.front();
    }
  }
};

/// The summary of a call.
/// \param items all vertices or points in their order
/// \param number_of(item) is the index of an item in the reports
template <class Item, class Items, class Number_of>
Estimation_summary<Item> summary_of(Estimation_reports&& reports, const Items& items, const Number_of& number_of)
{
  Estimation_summary<Item> summary;
  summary.cancelled = reports.cancelled;
  summary.noise = reports.noise;
  summary.set_reports(std::move(reports.statuses), std::move(reports.qualities), items, number_of);
  return summary;
}

/// Appends the row of the first seed, or rows of as many as are gathered together.
template <class Gather>
void gather_rows(Gather& gather, const Seeds& seeds, Neighborhood_block& rows)
{
  if constexpr (std::is_invocable<Gather&, Index, std::vector<Index>&>::value)
    rows.add_row([&](std::vector<Index>& row) { gather(seeds.first, row); });
  else gather(seeds, rows);
}

/// Estimates the gathered rows, which begin with row `first`, and orients their forms as the table has it.
template <class Estimate, class Rows, class Tables, class Result>
void estimate_gathered(Estimate& estimate, const Rows& rows, std::size_t first, const Neighborhood_block& gathered,
                       const Tables& tables, std::vector<Result>& results)
{
  constexpr bool at_places = Are_at_places<Rows>::value;
  if constexpr (at_places) {
    estimate(
        gathered, results, [&](std::size_t row) -> const auto& { return rows.place(first + row); });
  } else estimate(gathered, results);
  for (std::size_t row = 0; row < gathered.size(); ++row) {
    if (!results[row].status.is_estimated()) continue;
    if constexpr (at_places) orient(results[row], tables.normals[rows.oriented_by(first + row, gathered[row][0])]);
    else orient(results[row], tables.normals[rows[first + row]]);
  }
}

/// Few rows are to keep many threads busy to the end, too, and rows that are estimated one by one, which takes long.
template <class Row_estimator, class Rows>
std::size_t rows_of_block(const Rows& rows)
{
  constexpr std::size_t most = Row_estimator::rows_at_a_time() == 1 ? 64 : block_size, least = 16;
  if constexpr (std::is_same<Rows, All_rows>::value) return most;
  else return (std::min)(most, (std::max)(least, rows.size() / 64));
}

/// Gathers, estimates, orients and writes block after block.
///
/// \param tables of a mesh or a point set
/// \param estimator a Row_estimator; each thread works with a copy
/// \param make_gather() makes, for each thread, a function object: gather(i, row) appends the neighborhood of i, or
///        gather(seeds, rows) the neighborhoods of some of the seeds, for gather_rows()
/// \param write(block, report) is called by one thread at a time, but the blocks come in any order. It calls
///        report(block) once the forms of a block have been written
/// \param progress may be empty; called by one thread at a time; false cancels
/// \param all which rows: All_rows, Some_rows or Rows_at_places
template <class ConcurrencyTag, class Tables, class Row_estimator, class Make_gather, class Write, class Rows>
Estimation_reports estimate_blocks(const Tables& tables, const Row_estimator& estimator, const Make_gather& make_gather,
                                   const Write& write, const Progress& progress, const Rows& all)
{
  using Block = Estimated_block<typename Tables::Kernel>;
  const std::size_t size = all.size();
  constexpr std::size_t most_points = std::size_t(1) << 18; // of the rows that are gathered together
  Estimation_reports reports{std::vector<Estimation_status>(size),
                             std::vector<Fit_quality>(estimator.reports_quality() ? size : 0), false,
                             estimator.noise()};
  Serial_writer<Block> writer;
  std::size_t done = 0;
  const auto write_block = [&](const Block& block) {
    write(block, [&reports](const Block& written) { reports.take(written); });
    done += block.results.size();
    return !progress || progress(double(done) / double(size));
  };

  const auto is_full = [](const Neighborhood_block& rows) {
    const std::size_t points = rows.number_of_points();
    return points >= 4 * most_points || (points >= most_points && rows.size() % Row_estimator::rows_at_a_time() == 0);
  };
  const auto make_worker = [&] {
    return [&, gather = make_gather(), estimate = estimator, rows = Neighborhood_block()](std::size_t first,
                                                                                          std::size_t last) mutable {
      while (first < last) {
        rows.clear();
        while (first + rows.size() < last && !is_full(rows))
          gather_rows(gather, all.seeds(first + rows.size(), last), rows);
        Block block = writer.empty_block();
        block.first = static_cast<Index>(first);
        estimate_gathered(estimate, all, first, rows, tables, block.results);
        first += rows.size();
        if (!writer(std::move(block), write_block)) return false;
      }
      return true;
    };
  };
  for_each_block<ConcurrencyTag>(size, make_worker, rows_of_block<Row_estimator>(all));
  reports.cancelled = done < size;
  return reports;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_FITTING_ESTIMATE_BLOCKS_H
