// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_VALUES_ORIENTED_SAMPLES_H
#define CGAL_JET_FITTING_3_VALUES_ORIENTED_SAMPLES_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/number.h>
#include <CGAL/Jet_fitting_3/values/Samples.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3Steps
/// The standard deviations of the noise of points with normals.
template <class FT>
struct Data_noise
{
  FT position; ///< s: of a coordinate, in length
  FT normal;   ///< s_n: of a component of the unit normal
};

/// \ingroup PkgJetFitting3Steps
/// A neighbor whose normal is more than about 100 degrees away from that of the surface is taken for one of another
/// sheet, and left out: the cosine.
constexpr double least_cosine_on_sheet = -0.2;

/// \ingroup PkgJetFitting3Steps
/// Makes unit normals of noisy vectors, which are shorter by 1 - s_n^2 in the mean, as long as those without noise.
/// \param noise s_n, which counts as 1/2 at most
template <class FT>
FT normal_factor(const FT& noise)
{
  const FT variance = noise * noise, largest(0.25);
  return FT(1) / (FT(1) - numeric::select(variance < largest, variance, largest));
}

/// \ingroup PkgJetFitting3Steps
/// Samples with unit normals, in world axes. A sample of weight 0 is not there, so its normal may be anything finite.
template <class FT>
class Oriented_samples : public Samples<FT>
{
  using Rows = numeric::Row_block<FT>;
  using Number = typename numeric::Lanes<FT>::Number;

public:
  /// As for Samples; normals are zero until set.
  void resize(std::size_t size, bool weighted = false)
  {
    Samples<FT>::resize(size, weighted);
    m_normals.resize(3 * this->padded_size());
    std::fill(m_normals.begin(), m_normals.end(), FT(0));
  }

  /// The unit normal at sample i.
  Vector_3<FT> normal(std::size_t i) const { return {column(0)[i], column(1)[i], column(2)[i]}; }

  /// The normals of a block of samples.
  Vector_3<typename Rows::type> normal_block(std::size_t i) const
  {
    return {Rows::load(column(0) + i), Rows::load(column(1) + i), Rows::load(column(2) + i)};
  }

  /// At sample i.
  void set_normal(std::size_t i, const Vector_3<FT>& n)
  {
    column(0)[i] = n.x;
    column(1)[i] = n.y;
    column(2)[i] = n.z;
  }

  /// At sample i in one lane.
  void set_normal_lane(std::size_t i, int lane, const Vector_3<Number>& n)
  {
    numeric::Lanes<FT>::set(column(0)[i], lane, n.x);
    numeric::Lanes<FT>::set(column(1)[i], lane, n.y);
    numeric::Lanes<FT>::set(column(2)[i], lane, n.z);
  }

private:
  FT* column(std::size_t c) { return m_normals.data() + c * this->padded_size(); }
  const FT* column(std::size_t c) const { return m_normals.data() + c * this->padded_size(); }

  numeric::Buffer<FT, 384> m_normals; // three times 128 samples
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_VALUES_ORIENTED_SAMPLES_H
