// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_GATHERING_NEIGHBOR_CANDIDATES_H
#define CGAL_JET_FITTING_3_INTERNAL_GATHERING_NEIGHBOR_CANDIDATES_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/gathering/Bucket_sort.h>
#include <CGAL/Jet_fitting_3/internal/tables/Point_tree.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/number.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Bounds the error of a distance between two offsets of candidates, in their unit.
constexpr float candidate_error = 0x1p-17f;

/// The square of a length that is a little longer.
inline float widened(float squared)
{
  const float length = std::sqrt(squared) + 2 * candidate_error;
  return length * length;
}

inline float narrowed(float squared)
{
  const float length = (std::max)(std::sqrt(squared) - 2 * candidate_error, 0.f);
  return length * length;
}

/// From one box to another, along each axis.
template <class Wide, class Box>
std::array<Wide, 3> gap(const Box& a, const Box& b)
{
  std::array<Wide, 3> result;
  for (std::size_t axis = 0; axis < 3; ++axis)
    result[axis] =
        numeric::larger(numeric::larger(Wide(a.low[axis]) - Wide(b.high[axis]), Wide(b.low[axis]) - Wide(a.high[axis])),
                        0);
  return result;
}

/// The samples near a box, found by one traversal, as offsets in single precision from its middle in a unit of about
/// their size. Squared distances of these are right to candidate_error in the length. They are in an order that depends
/// on no other samples, that of their coordinates, which selections from them keep: sums over these are then the same
/// bits in every set. A selection has their positions here.
template <class Number>
class Neighbor_candidates
{
  using Tree = Point_tree<Number>;
  using Place = typename Tree::Place;
  using Box = typename Tree::Box;
  using Wide = typename Tree::Wide;

public:
  using Positions = std::vector<std::uint32_t>;

  explicit Neighbor_candidates(const Tree& tree) : m_tree(tree) {}

  /// The radius that was gathered, in the unit.
  float radius() const { return m_radius; }
  float in_unit(Wide length) const { return float(length * m_per_unit); }

  Index sample(std::uint32_t position) const { return m_samples[position]; }
  /// Its squared distance from the place that was measured last.
  float squared(std::uint32_t position) const { return m_squared[position]; }

  /// Gathers the samples that are not farther than the radius from a box.
  void gather(const Box& box, Wide radius)
  {
    Place half;
    Wide extent = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      m_middle[axis] = box.low[axis] / 2 + box.high[axis] / 2;
      half[axis] = (std::max)(box.high[axis] - m_middle[axis], m_middle[axis] - box.low[axis]);
      extent = (std::max)(extent, Wide(half[axis]));
    }
    m_per_unit = 1 / numeric::power_of_two_above((std::min)(extent + radius, (std::numeric_limits<Wide>::max)()));
    m_radius = in_unit(radius);
    const Wide bound = (radius * m_per_unit) * (radius * m_per_unit) * Wide(1 + 0x1p-20);
    const auto is_near = [&](const Box& other) {
      const std::array<Wide, 3> d = gap<Wide>(box, other);
      const Wide x = d[0] * m_per_unit, y = d[1] * m_per_unit, z = d[2] * m_per_unit;
      return x * x + y * y + z * z <= bound;
    };
    m_count = 0;
    const std::array<float, 3> half_box{float(half[0] * m_per_unit), float(half[1] * m_per_unit),
                                        float(half[2] * m_per_unit)};
    m_tree.for_each_leaf(is_near, [&](Index first, Index last) { gather_leaf(first, last, half_box); });
    put_in_order();
  }

  /// Squared distances from a place to what was gathered and may be within this one, all in the unit.
  void measure(const Place& place, float within = 0x1p100f)
  {
    std::array<float, 3> p;
    for (std::size_t axis = 0; axis < 3; ++axis)
      p[axis] = float((Wide(place[axis]) - Wide(m_middle[axis])) * m_per_unit);
    m_x = p[0];
    m_measured = within;
    set_range(within);
    const float *const x = m_offsets[0].data(), *const y = m_offsets[1].data(), *const z = m_offsets[2].data();
    float* const squared = m_squared.data();
    for (std::size_t i = m_first; i < m_last; ++i) {
      const float dx = x[i] - p[0], dy = y[i] - p[1], dz = z[i] - p[2];
      squared[i] = dx * dx + dy * dy + dz * dz;
    }
  }

  /// Improves a guess of the squared radius that holds at least `sought` samples, and few more unless many are at the
  /// same distance. False where some of them may not have been gathered, or measured.
  bool find_radius(std::size_t sought, float& squared) const
  {
    const bool has_all = m_last - m_first == m_tree.size();
    const float limit =
        has_all ? std::numeric_limits<float>::max() : (std::min)(m_measured, narrowed(m_radius * m_radius));
    float low = 0, high = limit, tried = (std::min)(squared, limit);
    std::size_t less = 0, more = 0; // how many are within low and high, the latter once there are enough
    for (int pass = 0; pass < 8 || more == 0; ++pass) {
      const std::size_t n = count(tried);
      if (n < sought) {
        if (tried == limit) return false;
        low = tried;
        less = n;
      } else {
        high = tried;
        more = n;
        if (n == sought || (pass > 2 && n <= sought + sought / 16)) break;
      }
      const float middle = more > 0 ? low + (high - low) / 2 : limit, missing = float(sought - less) + 0.5f;
      const float next = more > 0   ? low + (high - low) * (missing / float(more - less))
                         : less > 0 ? low * (1 + missing / float(less))
                                    : middle;
      tried = next > low && next < high && pass < 8 ? next : middle;
    }
    squared = high;
    return true;
  }

  /// Finds all that may be within a distance.
  void pick(float squared, Positions& picked)
  {
    const float bound = widened(squared);
    set_range(squared);
    std::size_t n = 0;
    for (std::size_t i = m_first; i < m_last; ++i) {
      m_picked[n] = static_cast<std::uint32_t>(i);
      n += m_squared[i] <= bound;
    }
    picked.assign(m_picked.begin(), m_picked.begin() + std::ptrdiff_t(n));
  }

private:
  void gather_leaf(Index first, Index last, const std::array<float, 3>& half_box)
  {
    constexpr std::size_t size = Tree::leaf_size;
    if (m_samples.size() < m_count + size) {
      m_samples.resize(2 * (m_count + size));
      m_squared.resize(m_samples.size());
      m_picked.resize(m_samples.size());
      for (std::vector<float>& offsets : m_offsets) offsets.resize(m_samples.size());
    }
    std::array<std::array<float, size>, 3> offsets;
    std::array<float, size> squared{}; // of the distances from the box
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Number* const coordinates = m_tree.coordinates(axis).data() + first;
      const Wide middle = m_middle[axis], per_unit = m_per_unit;
      const float half = half_box[axis];
      float* const offset = offsets[axis].data(); // a fixed number is faster: what is beyond the leaf is not used
      for (std::size_t i = 0; i < size; ++i) offset[i] = float((Wide(coordinates[i]) - middle) * per_unit);
      for (std::size_t i = 0; i < size; ++i) {
        const float beyond = std::abs(offset[i]) - half;
        squared[i] += beyond > 0 ? beyond * beyond : 0;
      }
    }
    const float bound = widened(m_radius * m_radius);
    for (std::size_t i = 0; i < last - first; ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) m_offsets[axis][m_count] = offsets[axis][i];
      m_samples[m_count] = first + static_cast<Index>(i);
      m_count += squared[i] <= bound;
    }
  }

  /// Rounded offsets along the first axis are in the order of the coordinates, but for those that became equal.
  void put_in_order()
  {
    const Positions& order = m_sort(m_offsets[0].data(), m_count, [this](std::uint32_t a, std::uint32_t b) {
      return m_tree.is_before_in_space(m_samples[a], m_samples[b]);
    });
    for (std::vector<float>& offsets : m_offsets) {
      for (std::size_t i = 0; i < m_count; ++i) m_squared[i] = offsets[order[i]];
      offsets.swap(m_squared);
    }
    m_unsorted.swap(m_samples);
    m_samples.resize(m_unsorted.size());
    for (std::size_t i = 0; i < m_count; ++i) m_samples[i] = m_unsorted[order[i]];
  }

  /// Of what may be within a distance from the place that is measured.
  void set_range(float squared)
  {
    const float reach = std::sqrt(squared) + 2 * candidate_error;
    m_first = m_sort.rank_from(m_x - reach);
    m_last = m_sort.rank_to(m_x + reach);
  }

  std::size_t count(float squared) const
  {
    std::uint32_t result = 0;
    const float* const all = m_squared.data();
    for (std::size_t i = m_first; i < m_last; ++i) result += all[i] <= squared;
    return result;
  }

  const Tree& m_tree;
  Bucket_sort m_sort;
  Place m_middle{};
  Wide m_per_unit = 1;
  float m_radius = 0;
  std::size_t m_count = 0;
  std::size_t m_first = 0, m_last = 0; // of those that are measured
  float m_measured = 0;                // the squared distance within which all of these are
  float m_x = 0;                       // first coordinate of the place from which they are measured
  std::array<std::vector<float>, 3> m_offsets;
  std::vector<float> m_squared;
  Positions m_picked;
  std::vector<Index> m_samples, m_unsorted;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_GATHERING_NEIGHBOR_CANDIDATES_H
