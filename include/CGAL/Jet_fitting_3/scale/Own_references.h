// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_OWN_REFERENCES_H
#define CGAL_JET_FITTING_3_SCALE_OWN_REFERENCES_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/scale/Bias_table.h>
#include <CGAL/Jet_fitting_3/scale/Local_ladder.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace scale {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The fits of degree 4 to the balls around one point, from positions alone. What differs from a smaller one by more
/// than its noise and the bias that the places around know of it has a bias that they do not know: on a detail that is
/// unlike what is around it, as a bump in a plane. So Lepski (1991) chooses a scale.
class Own_references
{
  // What of fits is compared: both slopes, the second derivatives together, or one of them.
  struct Part
  {
    std::size_t first, end; // of the targets
    double likely;          // squared errors by which they differ at most, but in 1 of 100 cases or so
  };

public:
  /// \param table of the places around
  Own_references(const Local_ladder& local, const Bias_table& table, const Ladder& ladder) : m_table(table)
  {
    if (ladder.with_normals) return;
    for (std::size_t k = ladder.first_reference; k < std::min(local.candidates.size(), biases(0).size()); ++k)
      if (const Rung& rung = local.candidates[k]; rung.has_neighbors_for(4))
        m_references.push_back({k, &rung.of_degree(4)});
  }

  /// What they prove of a candidate for a target.
  double squared_bias(const Turned_second_order& fit, Shape shape, std::size_t target, std::size_t degree,
                      std::size_t rung) const
  {
    const Part part = part_of(shape, target);
    const auto end = std::find_if(m_references.begin(), m_references.end(), [&](const Reference& r) {
      return degree < highest_nested_degree ? r.rung > rung : r.rung >= rung;
    });
    double most = 0;
    for (auto r = m_references.begin(); r != end; ++r) {
      const double square = squared_difference(fit, *r->fit, part);
      const double known = part.likely * (variance(*r->fit, part) + known_bias(r->rung, part));
      if (square > most + known) most = std::max(most, square - known - error_of_neighbors(r, end, part, square));
    }
    return most;
  }

private:
  struct Reference
  {
    std::size_t rung;
    const Turned_second_order* fit;
  };
  using Iterator = std::vector<Reference>::const_iterator;

  // Ellipses are long for one of the second derivatives, and err in the others.
  static Part part_of(Shape shape, std::size_t target)
  {
    if (target == 0) return {0, 1, 4};
    if (is_ellipse(shape)) return {target, target + 1, 9};
    return {1, number_of_targets, 4};
  }

  // \param of of(target)
  template <class Of_target>
  static double summed(const Part& part, const Of_target& of)
  {
    double sum = 0;
    for (std::size_t target = part.first; target < part.end; ++target) sum += of(target);
    return sum;
  }

  static double squared_difference(const Turned_second_order& a, const Turned_second_order& b, const Part& part)
  {
    return summed(part,
                  [&](std::size_t target) { return scale::squared_difference(found(a, target), found(b, target)); });
  }

  static double variance(const Turned_second_order& fit, const Part& part)
  {
    return summed(part, [&](std::size_t target) { return scale::variance(fit, target); });
  }

  // Of degree 4 in balls.
  const std::vector<Squared_bias>& biases(std::size_t target) const { return m_table[target].in(Shape::ball)[2]; }

  double known_bias(std::size_t rung, const Part& part) const
  {
    return summed(part, [&](std::size_t target) { return biases(target)[rung].value; });
  }

  // Of a reference, that of neighbors which err alike, by the next larger ones.
  static double error_of_neighbors(Iterator reference, Iterator end, const Part& part, double square)
  {
    const double noise = variance(*reference->fit, part);
    double most = 0;
    for (auto larger = reference + 1; larger != end && larger->rung <= reference->rung + Roughness::larger; ++larger) {
      const double less = std::max(0., noise - variance(*larger->fit, part));
      most = std::max(most, squared_difference(*larger->fit, *reference->fit, part) - less);
    }
    return Roughness::squared_error(most, square - noise);
  }

  const Bias_table& m_table;
  std::vector<Reference> m_references; // from small to large
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace scale
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_OWN_REFERENCES_H
