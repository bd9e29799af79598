// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_PARALLEL_H
#define CGAL_JET_FITTING_3_INTERNAL_PARALLEL_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <type_traits>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/partitioner.h>
#include <tbb/spin_mutex.h>
#endif

namespace CGAL {
namespace Jet_fitting {
namespace internal {

/// For work that is done by one thread at a time, and in less time than it takes to wake a thread: the others wait awake.
#ifdef CGAL_LINKED_WITH_TBB
using Brief_mutex = tbb::spin_mutex;
#else
struct Brief_mutex
{
  void lock() {}
  void unlock() {}
};
#endif

/// Fixed, so that the results are the same bits whatever the number of threads.
constexpr std::size_t block_size = 1024;

/// Runs worker(first, last) for every block of the numbers below size, until one returns false. make_worker() is called
/// once for each thread. Blocks are begun in order, whichever thread takes them.
template <class ConcurrencyTag, class Make_worker>
void for_each_block(std::size_t size, const Make_worker& make_worker)
{
  const auto end = [size](std::size_t first) { return (std::min)(first + block_size, size); };
  if constexpr (std::is_convertible<ConcurrencyTag, Parallel_tag>::value) {
#ifdef CGAL_LINKED_WITH_TBB
    tbb::enumerable_thread_specific<decltype(make_worker())> workers(make_worker);
    std::atomic<std::size_t> next(0);
    std::atomic<bool> go_on(true);
    const auto take_next = [&](std::size_t) {
      const std::size_t first = block_size * next++;
      if (go_on && !workers.local()(first, end(first))) go_on = false;
    };
    // One at a time: a thread that took several at the end would be waited for.
    tbb::parallel_for(std::size_t(0), (size + block_size - 1) / block_size, take_next, tbb::simple_partitioner());
#else
    static_assert(!std::is_convertible<ConcurrencyTag, Parallel_tag>::value,
                  "Parallel_tag needs TBB: link with CGAL::TBB_support, or take Parallel_if_available_tag");
#endif
  } else {
    auto worker = make_worker();
    for (std::size_t first = 0; first < size && worker(first, end(first)); first += block_size) {}
  }
}

/// Calls visit(i) for every number i below size.
template <class ConcurrencyTag, class Visit>
void for_each_number(std::size_t size, const Visit& visit)
{
  for_each_block<ConcurrencyTag>(size, [&] {
    return [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) visit(i);
      return true;
    };
  });
}

/// Runs two tasks, at the same time if there are threads.
template <class ConcurrencyTag, class First, class Second>
void do_both(const First& first, const Second& second)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (std::is_convertible<ConcurrencyTag, Parallel_tag>::value) return tbb::parallel_invoke(first, second);
#endif
  first();
  second();
}

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_PARALLEL_H
