// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_GATHERING_ROWS_H
#define CGAL_JET_FITTING_3_INTERNAL_GATHERING_ROWS_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/Index.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Seeds.h>
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

/// Which rows are estimated: of all vertices or samples. Row i has seed i.
class All_rows
{
public:
  explicit All_rows(std::size_t size) : m_size(size) {}

  std::size_t size() const { return m_size; }
  Index operator[](std::size_t i) const { return static_cast<Index>(i); }
  /// The seeds of rows first, ..., last - 1 or fewer, with consecutive numbers.
  Seeds seeds(std::size_t first, std::size_t last) const { return {Index(first), Index(last)}; }
  std::size_t row_of(Index seed) const { return seed; }

private:
  std::size_t m_size;
};

/// Of some of them, in any order.
class Some_rows
{
public:
  explicit Some_rows(std::vector<Index> seeds) : m_seeds(std::move(seeds)) {}

  std::size_t size() const { return m_seeds.size(); }
  Index operator[](std::size_t i) const { return m_seeds[i]; }

  Seeds seeds(std::size_t first, std::size_t last) const
  {
    const std::size_t most = 64; // each of them is looked at again where fewer are gathered
    last = (std::min)(last, first + most);
    std::size_t end = first + 1;
    while (end < last && m_seeds[end] == m_seeds[end - 1] + 1) ++end;
    return {m_seeds[first], m_seeds[end - 1] + 1};
  }

  /// Which row has this seed, the size if none; the seeds are in ascending order.
  std::size_t row_of(Index seed) const
  {
    const auto found = std::lower_bound(m_seeds.begin(), m_seeds.end(), seed);
    return found != m_seeds.end() && *found == seed ? std::size_t(found - m_seeds.begin()) : size();
  }

private:
  std::vector<Index> m_seeds;
};

/// In ascending order, each once.
inline std::vector<Index> distinct(std::vector<Index> numbers)
{
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

/// Where numbers occur first in a list.
class Positions
{
public:
  explicit Positions(const std::vector<Index>& numbers) : m_size(numbers.size())
  {
    for (std::size_t i = 0; i < m_size; ++i) m_positions.emplace_back(numbers[i], i);
    std::sort(m_positions.begin(), m_positions.end());
  }

  /// The size of the list for a number that is not in it.
  std::size_t operator()(std::size_t number) const
  {
    const auto found = std::lower_bound(m_positions.begin(), m_positions.end(), number,
                                        [](const auto& entry, std::size_t n) { return entry.first < n; });
    return found != m_positions.end() && found->first == number ? found->second : m_size;
  }

private:
  std::size_t m_size;
  std::vector<std::pair<std::size_t, std::size_t>> m_positions;
};

/// Rows whose forms are wanted at places that are no samples: at the foot of place i on the jet of row i.
template <class Point>
class Rows_at_places
{
public:
  /// \param seeds of the rows; none where the rows are gathered around the places
  Rows_at_places(std::vector<Point> places, std::vector<Index> seeds)
    : m_places(std::move(places)), m_seeds(std::move(seeds))
  {}

  std::size_t size() const { return m_places.size(); }
  Index operator[](std::size_t i) const { return m_seeds.empty() ? static_cast<Index>(i) : m_seeds[i]; }
  Seeds seeds(std::size_t first, std::size_t) const { return {(*this)[first], (*this)[first] + 1}; }
  const Point& place(std::size_t i) const { return m_places[i]; }
  /// Whose normal orients form i, given the first sample of its row.
  Index oriented_by(std::size_t i, Index first_sample) const { return m_seeds.empty() ? first_sample : m_seeds[i]; }

private:
  std::vector<Point> m_places;
  std::vector<Index> m_seeds;
};

/// Whether forms are wanted at places.
template <class Rows>
struct Are_at_places : std::false_type
{};

template <class Point>
struct Are_at_places<Rows_at_places<Point>> : std::true_type
{};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_GATHERING_ROWS_H
