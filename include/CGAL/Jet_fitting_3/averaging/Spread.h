// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_SPREAD_H
#define CGAL_JET_FITTING_3_AVERAGING_SPREAD_H

#include <CGAL/Jet_fitting_3/numeric/native.h>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Numbers with variances, and by how much they differ beyond these.
class Spread
{
public:
  void add(double value, double variance)
  {
    if (m_count == 0) m_first = value; // of which little may differ
    const double w = 1 / variance, difference = value - m_first;
    m_count += 1;
    m_weights += w;
    m_sum += w * difference;
    m_squares += w * difference * difference;
  }

  double mean() const { return m_weights > 0 ? m_first + m_sum / m_weights : 0; }
  /// The mean square of what they differ from their mean, less their variance, by weight.
  double excess() const { return m_weights > 0 ? (m_squares - m_sum * m_sum / m_weights - m_count) / m_weights : 0; }

private:
  double m_first = 0, m_count = 0, m_weights = 0, m_sum = 0, m_squares = 0;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_SPREAD_H
