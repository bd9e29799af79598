// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_MACHINE_PARALLEL_H
#define CGAL_JET_FITTING_3_INTERNAL_MACHINE_PARALLEL_H

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
#include <tbb/task_arena.h>
#endif

namespace CGAL {
namespace Jet_fitting {
namespace internal {

/// For critical sections shorter than waking a thread: waiters spin.
#ifdef CGAL_LINKED_WITH_TBB
using Spin_mutex = tbb::spin_mutex;
#else
struct Spin_mutex
{
  void lock() {}
  void unlock() {}
};
#endif

/// Fixed, so that the results are the same bits whatever the number of threads.
constexpr std::size_t block_size = 1024;

#ifdef CGAL_LINKED_WITH_TBB
/// Takes blocks, as many threads as the arena has, each with its own worker. Where a worker calls code of the user that
/// waits for parallel work of its own, the thread does not begin another block meanwhile: it is isolated, and where the
/// user leaves the isolation by entering the arena once more, it sees that it is busy.
template <class Make_worker>
void take_blocks_in_parallel(std::size_t size, const Make_worker& make_worker, std::size_t block)
{
  std::atomic<std::size_t> next(0);
  std::atomic<bool> go_on(true);
  tbb::enumerable_thread_specific<bool> busy(false);
  const auto take_blocks = [&] {
    auto worker = make_worker();
    while (go_on) {
      const std::size_t first = block * next++;
      if (first >= size || !worker(first, (std::min)(first + block, size))) go_on = false;
    }
  };
  const auto join = [&](std::size_t) {
    bool& is_busy = busy.local();
    if (is_busy || !go_on) return;
    is_busy = true;
    try {
      tbb::this_task_arena::isolate(take_blocks);
    } catch (...) {
      go_on = is_busy = false;
      throw;
    }
    is_busy = false;
  };
  const std::size_t threads = std::size_t(tbb::this_task_arena::max_concurrency());
  tbb::parallel_for(std::size_t(0), (std::min)(threads, (size + block - 1) / block), join, tbb::simple_partitioner());
}
#endif

/// Runs worker(first, last) for every block of the numbers below size, until one returns false. make_worker() is called
/// once for each thread. Blocks are begun in order, whichever thread takes them.
/// \param block how many numbers are a block
template <class ConcurrencyTag, class Make_worker>
void for_each_block(std::size_t size, const Make_worker& make_worker, std::size_t block = block_size)
{
  if constexpr (std::is_convertible<ConcurrencyTag, Parallel_tag>::value) {
#ifdef CGAL_LINKED_WITH_TBB
    take_blocks_in_parallel(size, make_worker, block);
#else
    static_assert(!std::is_convertible<ConcurrencyTag, Parallel_tag>::value,
                  "Parallel_tag needs TBB: link with CGAL::TBB_support, or take Parallel_if_available_tag");
#endif
  } else {
    auto worker = make_worker();
    for (std::size_t first = 0; first < size && worker(first, (std::min)(first + block, size)); first += block) {}
  }
}

/// Calls body(k) for each k below count, a few at a time, with a body for each thread.
template <class ConcurrencyTag>
struct For_each_with_body
{
  template <class Make_body>
  void operator()(std::size_t count, const Make_body& make_body) const
  {
    constexpr std::size_t at_a_time = 8;
    const auto make_worker = [&] {
      return [body = make_body()](std::size_t first, std::size_t last) mutable {
        for (; first < last; ++first) body(first);
        return true;
      };
    };
    for_each_block<ConcurrencyTag>(count, make_worker, at_a_time);
  }
};

/// Calls visit(i) for every number i below size.
/// \param block how many numbers a thread takes at a time
template <class ConcurrencyTag, class Visit>
void for_each_number(std::size_t size, const Visit& visit, std::size_t block = block_size)
{
  const auto make_worker = [&] {
    return [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) visit(i);
      return true;
    };
  };
  for_each_block<ConcurrencyTag>(size, make_worker, block);
}

/// Runs two tasks, at the same time if there are threads. One does not begin within the other.
template <class ConcurrencyTag, class First, class Second>
void do_both(const First& first, const Second& second)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (std::is_convertible<ConcurrencyTag, Parallel_tag>::value)
    return tbb::parallel_invoke([&] { tbb::this_task_arena::isolate(first); },
                                [&] { tbb::this_task_arena::isolate(second); });
#endif
  first();
  second();
}

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_MACHINE_PARALLEL_H
