// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_MACHINE_IDLE_SEARCHES_H
#define CGAL_JET_FITTING_3_INTERNAL_MACHINE_IDLE_SEARCHES_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/machine/parallel.h>

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

/// Searches own buffers: each call borrows one that no other thread uses.
template <class Search>
class Idle_searches
{
public:
  using Borrowed = std::unique_ptr<Search>;

  /// One of which is_preferred(search) is true, if there is one, else any; a new one, make(), if none is idle.
  template <class Make, class Is_preferred>
  Borrowed borrow(const Make& make, const Is_preferred& is_preferred)
  {
    const std::lock_guard<Spin_mutex> lock(m_mutex);
    if (m_searches.empty()) return make();
    for (auto& search : m_searches)
      if (is_preferred(*search)) std::swap(search, m_searches.back());
    Borrowed search = std::move(m_searches.back());
    m_searches.pop_back();
    return search;
  }

  void give_back(Borrowed search)
  {
    const std::lock_guard<Spin_mutex> lock(m_mutex);
    m_searches.push_back(std::move(search));
  }

private:
  Spin_mutex m_mutex;
  std::vector<Borrowed> m_searches;
};

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_MACHINE_IDLE_SEARCHES_H
