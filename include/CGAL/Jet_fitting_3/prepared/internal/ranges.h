// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_PREPARED_INTERNAL_RANGES_H
#define CGAL_JET_FITTING_3_PREPARED_INTERNAL_RANGES_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/numeric/native.h>

#include <boost/graph/graph_traits.hpp>

#include <iterator>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

template <class Range>
using Value_of_range = std::decay_t<decltype(*std::begin(std::declval<const Range&>()))>;

/// Tells the functions for some vertices or points from those for all.
template <class Range, class Mesh, class = void>
struct Is_range_of_vertices : std::false_type
{};

template <class Range, class Mesh>
struct Is_range_of_vertices<Range, Mesh,
                            std::void_t<Value_of_range<Range>, typename boost::graph_traits<Mesh>::vertex_descriptor>>
  : std::is_convertible<Value_of_range<Range>, typename boost::graph_traits<Mesh>::vertex_descriptor>
{};

template <class Range, class = void>
struct Is_range_of_numbers : std::false_type
{};

template <class Range>
struct Is_range_of_numbers<Range, std::void_t<Value_of_range<Range>>> : std::is_integral<Value_of_range<Range>>
{};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_PREPARED_INTERNAL_RANGES_H
