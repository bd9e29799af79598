// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_ESTIMATION_STATUS_H
#define CGAL_JET_FITTING_3_ESTIMATION_STATUS_H

#include <cstdint>
#include <ostream>

namespace CGAL {
namespace Jet_fitting {

/// \ingroup PkgJetFitting3Results
/// What there is to know about the estimation at one vertex or point. Several may hold at once.
enum class Status_flag : std::uint16_t
{
  /// A form was written. Without it: skipped, for one of the next four reasons or the last two; or not reached, if
  /// nothing is set.
  estimated = 1,
  /// No point in the neighborhood but the vertex itself.
  isolated = 2,
  /// A coordinate, or a result, is infinite or not a number.
  not_finite = 4,
  /// Fewer than (d+1)(d+2)/2 points for the degree d that was asked for.
  too_few_points = 8,
  /// The points do not determine a jet of the degree d that was asked for: they coincide, or lie on an algebraic curve.
  /// With automatic(), where normals of a point set are data, also: a fit leans more than 45 degrees from the tangent
  /// plane.
  rank_deficient = 16,
  /// With Options::lower_degree: a smaller degree was fitted, because of one of the last two.
  degree_lowered = 32,
  /// The points lie mostly on one side, as at a boundary: the mean of their offsets is longer than 0.45 times the root
  /// of their mean squared distance (0.6 in the middle of a half disc's straight side). Errors are then many times
  /// larger.
  one_sided = 64,
  /// Principal directions mean little. Either k1 and k2 differ by less than a tenth of the larger one, and by no more
  /// than the residual leaves open, which is about 3 d rms / h^2 (h^2 being the variance of the points in their plane),
  /// or both are below that, as on a plane. With automatic(), e^2 being bias^2 + standard_deviation^2 of Chosen_scale:
  /// they differ by at most a tenth of the larger one and by at most 3 e, or both are at most 2 e.
  near_umbilic = 128,
  /// The variance of the points across their plane is above a quarter of that along its narrower axis: the direction
  /// in which heights are measured may be far from the normal.
  pca_ambiguous = 256,
  /// A robust loss was asked for, and there are fewer than 5 N_d points: too few to tell outliers from the surface.
  few_points_for_robust_loss = 512,
  /// Of a place that is no sample: the jet has no point closest to it over the samples. The place is beside them, or
  /// too far away.
  beside_samples = 1024,
  /// With automatic(), unless Options::keep_outliers is set: a point is far from a robust fit of degree 2 to the 45
  /// nearest, or a vertex of a mesh from such a fit to the rings around, or from these; while most of the others there
  /// are not. It is no neighbor of others, and has no form.
  outlier = 2048
};

/// \ingroup PkgJetFitting3Results
/// A set of Status_flag.
class Estimation_status
{
public:
  Estimation_status() = default;
  /// The set of this flag alone.
  Estimation_status(Status_flag flag) : m_flags(bits(flag)) {}

  /// Whether the flag is in the set.
  bool has(Status_flag flag) const { return (m_flags & bits(flag)) != 0; }
  /// Whether there is a form.
  bool is_estimated() const { return has(Status_flag::estimated); }
  /// Neither estimated nor skipped: the call was cancelled before.
  bool is_unknown() const { return m_flags == 0; }

  /// The sum of the flags' values, which do not change from version to version.
  std::uint16_t to_integer() const { return m_flags; }

  /// Adds the flags of the other set.
  Estimation_status& operator|=(Estimation_status other)
  {
    m_flags = static_cast<std::uint16_t>(m_flags | other.m_flags);
    return *this;
  }

  /// @{
  /// Whether the flags are the same.
  friend bool operator==(Estimation_status a, Estimation_status b) { return a.m_flags == b.m_flags; }
  friend bool operator!=(Estimation_status a, Estimation_status b) { return !(a == b); }
  /// @}

private:
  static std::uint16_t bits(Status_flag flag) { return static_cast<std::uint16_t>(flag); }

  std::uint16_t m_flags = 0;
};

/// \ingroup PkgJetFitting3Results
/// The flags of both.
inline Estimation_status operator|(Estimation_status a, Estimation_status b) { return a |= b; }

/// Writes the flags in words, separated by commas.
inline std::ostream& operator<<(std::ostream& out, Estimation_status status)
{
  const struct
  {
    Status_flag flag;
    const char* name;
  } words[] = {{Status_flag::estimated, "estimated"},
               {Status_flag::isolated, "isolated"},
               {Status_flag::not_finite, "not finite"},
               {Status_flag::too_few_points, "too few points"},
               {Status_flag::rank_deficient, "rank deficient"},
               {Status_flag::degree_lowered, "degree lowered"},
               {Status_flag::one_sided, "one-sided"},
               {Status_flag::near_umbilic, "near umbilic"},
               {Status_flag::pca_ambiguous, "pca ambiguous"},
               {Status_flag::few_points_for_robust_loss, "few points for the robust loss"},
               {Status_flag::beside_samples, "beside the samples"},
               {Status_flag::outlier, "outlier"}};
  const char* separator = "";
  for (const auto& word : words) {
    if (!status.has(word.flag)) continue;
    out << separator << word.name;
    separator = ", ";
  }
  return status.is_unknown() ? out << "unknown" : out;
}

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_ESTIMATION_STATUS_H
