// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_GATHERING_NEIGHBOR_CANDIDATES_H
#define CGAL_JET_FITTING_3_INTERNAL_GATHERING_NEIGHBOR_CANDIDATES_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/internal/tables/Point_tree.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/number.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

struct Found_sample
{
  float squared; // distance, in the unit of the candidates
  Index sample;
};

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
/// their size. Squared distances of these are right to candidate_error in the length.
template <class Number>
class Neighbor_candidates
{
  using Tree = Point_tree<Number>;
  using Place = typename Tree::Place;
  using Box = typename Tree::Box;
  using Wide = typename Tree::Wide;

public:
  explicit Neighbor_candidates(const Tree& tree) : m_tree(tree) {}

  /// The radius that was gathered, in the unit.
  float radius() const { return m_radius; }

  /// Gathers, in order, the samples that are not farther than the radius from a box.
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
    m_radius = float(radius * m_per_unit);
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
  }

  /// Squared distances in the unit from a place to what was gathered.
  void measure(const Place& place)
  {
    std::array<float, 3> p;
    for (std::size_t axis = 0; axis < 3; ++axis)
      p[axis] = float((Wide(place[axis]) - Wide(m_middle[axis])) * m_per_unit);
    const float *const x = m_offsets[0].data(), *const y = m_offsets[1].data(), *const z = m_offsets[2].data();
    float* const squared = m_squared.data();
    for (std::size_t i = 0; i < m_count; ++i) {
      const float dx = x[i] - p[0], dy = y[i] - p[1], dz = z[i] - p[2];
      squared[i] = dx * dx + dy * dy + dz * dz;
    }
  }

  /// Improves a guess of the squared radius that holds at least `sought` samples, and few more unless many are at the
  /// same distance. False where some of them may not have been gathered.
  bool find_radius(std::size_t sought, float& squared) const
  {
    const bool has_all = m_count == m_tree.size();
    const float limit = has_all ? std::numeric_limits<float>::max() : narrowed(m_radius * m_radius);
    float low = 0, high = limit, tried = (std::min)(squared, limit);
    bool is_enough = false;
    for (int pass = 0; pass < 8 || !is_enough; ++pass) {
      const std::size_t n = count(tried);
      if (n >= sought) {
        high = tried;
        is_enough = true;
        if (n <= sought + sought / 16) break;
      } else {
        if (tried == limit) return false;
        low = tried;
      }
      const float next = tried * ((float(sought) + 0.5f) / float((std::max)(n, std::size_t(1))));
      if (next > low && next < high && pass < 8) tried = next;
      else tried = is_enough ? low + (high - low) / 2 : limit;
    }
    squared = high;
    return true;
  }

  /// Finds all that may be within a distance.
  void pick(float squared, std::vector<Found_sample>& found)
  {
    const float bound = widened(squared);
    Found_sample* const picked = m_picked.data();
    std::size_t n = 0;
    for (std::size_t i = 0; i < m_count; ++i) {
      picked[n] = {m_squared[i], m_samples[i]};
      n += m_squared[i] <= bound;
    }
    found.assign(picked, picked + n);
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

  std::size_t count(float squared) const
  {
    std::uint32_t result = 0;
    const float* const all = m_squared.data();
    for (std::size_t i = 0; i < m_count; ++i) result += all[i] <= squared;
    return result;
  }

  const Tree& m_tree;
  Place m_middle{};
  Wide m_per_unit = 1;
  float m_radius = 0;
  std::size_t m_count = 0;
  std::array<std::vector<float>, 3> m_offsets;
  std::vector<float> m_squared;
  std::vector<Index> m_samples;
  std::vector<Found_sample> m_picked;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_GATHERING_NEIGHBOR_CANDIDATES_H
