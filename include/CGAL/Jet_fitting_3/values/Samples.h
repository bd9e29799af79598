// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_VALUES_SAMPLES_H
#define CGAL_JET_FITTING_3_VALUES_SAMPLES_H

#include <CGAL/Jet_fitting_3/numeric/Buffer.h>
#include <CGAL/Jet_fitting_3/numeric/number.h>
#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>

#include <cstddef>

namespace CGAL {
namespace Jet_fitting {

/// \ingroup PkgJetFitting3Steps
/// The sample points P+ of section 2.1.2, relative to p = samples[0], in world axes: p itself is (0, 0, 0).
/// A weight multiplies the square of its sample's residual; no weights means weights one.
template <class FT>
class Samples
{
  using Coordinates = numeric::Buffer<FT, 128>;

public:
  /// N, p included.
  std::size_t size() const { return m_x.size(); }
  /// Sample i relative to p.
  Vector_3<FT> operator[](std::size_t i) const { return {m_x[i], m_y[i], m_z[i]}; }

  /// Whether weights are stored.
  bool is_weighted() const { return !m_weights.empty(); }
  /// Of sample i.
  FT weight(std::size_t i) const { return is_weighted() ? m_weights[i] : FT(1); }

  /// Sum of the weights; 1 where all are 0, since it is there to divide by.
  FT total_weight() const
  {
    if (!is_weighted()) return FT(double(size()));
    FT total(0);
    for (const FT& weight : m_weights) total = total + weight;
    return numeric::select(total > FT(0), total, FT(1));
  }

  /// Coordinates and weights are indeterminate until set.
  void resize(std::size_t size, bool weighted = false)
  {
    for (Coordinates* c : {&m_x, &m_y, &m_z}) c->resize(size);
    m_weights.resize(weighted ? size : 0);
  }

  /// Sample i, relative to p.
  void set(std::size_t i, const Vector_3<FT>& r)
  {
    m_x[i] = r.x;
    m_y[i] = r.y;
    m_z[i] = r.z;
  }

  /// Gives every sample the weight one that it had without saying so.
  void make_weighted()
  {
    if (is_weighted()) return;
    m_weights.resize(size());
    for (FT& weight : m_weights) weight = FT(1);
  }

  /// Of sample i, where weights are stored.
  void set_weight(std::size_t i, const FT& weight) { m_weights[i] = weight; }

  /// The same for one lane, where FT is a Pack.
  template <class Number>
  void set_lane(std::size_t i, int lane, const Number& x, const Number& y, const Number& z)
  {
    m_x[i].set(lane, x);
    m_y[i].set(lane, y);
    m_z[i].set(lane, z);
  }

  /// The weight of sample i in one lane.
  template <class Number>
  void set_weight_lane(std::size_t i, int lane, const Number& weight)
  {
    m_weights[i].set(lane, weight);
  }

  /// @{
  /// A coordinate of all samples.
  const FT* x() const { return m_x.data(); }
  const FT* y() const { return m_y.data(); }
  const FT* z() const { return m_z.data(); }
  /// @}

  /// Multiplies all coordinates.
  void scale(const FT& factor)
  {
    for (Coordinates* c : {&m_x, &m_y, &m_z})
      for (FT& coordinate : *c) coordinate = coordinate * factor;
  }

private:
  Coordinates m_x, m_y, m_z, m_weights;
};

/// \ingroup PkgJetFitting3Steps
/// A power of two above the largest coordinate: the unit of length in which the steps compute, so that no square, no
/// power and no product of theirs can overflow or underflow, and a change of unit by 2^e changes no digit.
template <class FT>
FT unit_of_length(const Samples<FT>& samples)
{
  FT x(0), y(0), z(0); // side by side, because a comparison takes several cycles
  for (std::size_t i = 0; i < samples.size(); ++i) {
    x = numeric::larger(x, numeric::absolute(samples.x()[i]));
    y = numeric::larger(y, numeric::absolute(samples.y()[i]));
    z = numeric::larger(z, numeric::absolute(samples.z()[i]));
  }
  return numeric::power_of_two_above(numeric::larger(x, numeric::larger(y, z)));
}

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_VALUES_SAMPLES_H
