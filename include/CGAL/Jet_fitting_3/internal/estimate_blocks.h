// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_ESTIMATE_BLOCKS_H
#define CGAL_JET_FITTING_3_INTERNAL_ESTIMATE_BLOCKS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Estimation_status.h>
#include <CGAL/Jet_fitting_3/internal/fit_block.h>
#include <CGAL/Jet_fitting_3/internal/parallel.h>

#include <cstddef>
#include <functional>
#include <mutex>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

using Progress = std::function<bool(double)>;

/// Gathers, fits, orients and stores block after block.
///
/// \param make_gather() makes, for each thread, a function object: gather(i, row) appends the neighborhood of i
/// \param fit(block, fits), a Block_fitter; each thread works with a copy
/// \param orient(i, form)
/// \param store(first, fits) is called by one thread at a time, but the blocks come in any order
/// \param progress may be empty; called by one thread at a time. \return false if it cancelled
template <class ConcurrencyTag, class DataKernel, class Make_gather, class Block_fitter, class Orient, class Store>
bool estimate_blocks(std::size_t size, const Make_gather& make_gather, const Block_fitter& fit, const Orient& orient,
                     const Store& store, const Progress& progress)
{
  Brief_mutex mutex;
  std::size_t done = 0;
  bool cancelled = false;

  const auto make_worker = [&] {
    return [&, gather = make_gather(), fitter = fit, block = Neighborhood_block(),
            fits = std::vector<Fit<DataKernel>>()](std::size_t first, std::size_t last) mutable {
      block.clear();
      for (std::size_t i = first; i < last; ++i)
        block.add_row([&](std::vector<Index>& row) { gather(static_cast<Index>(i), row); });
      fitter(block, fits);
      for (std::size_t i = first; i < last; ++i)
        if (fits[i - first].status.is_estimated()) {
          Fit<DataKernel>& fit_of_i = fits[i - first];
          const auto d1 = fit_of_i.form.maximal_principal_direction();
          orient(static_cast<Index>(i), fit_of_i.form);
          if (d1 != fit_of_i.form.maximal_principal_direction())
            for (Fit_quality& quality : fit_of_i.quality) quality.standard_errors.turn();
        }

      const std::lock_guard<Brief_mutex> lock(mutex);
      if (cancelled) return false;
      store(first, fits);
      done += last - first;
      cancelled = progress && !progress(double(done) / double(size));
      return !cancelled;
    };
  };
  for_each_block<ConcurrencyTag>(size, make_worker);
  return !cancelled || done == size;
}

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_ESTIMATE_BLOCKS_H
