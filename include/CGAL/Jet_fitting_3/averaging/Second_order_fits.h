// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_SECOND_ORDER_FITS_H
#define CGAL_JET_FITTING_3_AVERAGING_SECOND_ORDER_FITS_H

#include <CGAL/Jet_fitting_3/averaging/Bias_model.h>
#include <CGAL/Jet_fitting_3/averaging/Disk_fitter.h>
#include <CGAL/Jet_fitting_3/averaging/Second_order_estimate.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// For each of these weights are chosen: z_xx, sqrt(2) z_xy and z_yy in principal axes, and all of them together.
inline constexpr std::array<Target, 4> targets_of_order_2{{{0, 1}, {1, 2}, {2, 3}, {0, 3}}};
constexpr std::size_t number_of_components = 3;
constexpr std::size_t together = 3; ///< the number of the last

/// Ratios of the axes of the ellipses in which candidates are fitted. The first ones are disks.
inline constexpr std::array<double, 4> shapes{1, 1.6, 2.6, 4.2};

/// Those of each shape, as far as they are there.
using Candidates_of_shapes = std::array<Candidates, shapes.size()>;

/// Candidates for derivatives of order 2 of one height at vertices, and choices among them.
template <class Neighbors>
class Second_order_fits
{
public:
  using Surface = Surface_points<Neighbors>;

  /// \param squares_of_noise as for Surface_choice
  Second_order_fits(const Surface& surface, const std::vector<double>& squares_of_noise, const Candidate_grid& grid,
                    Height height)
    : m_surface(surface), m_squares_of_noise(squares_of_noise), m_grid(grid), m_fitter(surface, height)
  {}

  const Surface& surface() const { return m_surface; }
  const Candidate_grid& grid() const { return m_grid; }
  Height height() const { return m_fitter.height(); }
  double square_of_noise(std::size_t i) const { return m_squares_of_noise[i]; }
  Walker<Neighbors> walker() const { return Walker<Neighbors>(m_surface); }

  /// Those that are selected, at vertex i.
  Candidates operator()(Walker<Neighbors>& walker, std::size_t i, const Local_frame& frame, std::size_t shape,
                        const Selection& selection, bool with_rows) const
  {
    return m_fitter(walker, i, frame, shapes[shape], m_grid, 2, selection, with_rows);
  }

  /// All, with rows.
  Candidates all(Walker<Neighbors>& walker, std::size_t i, const Local_frame& frame, std::size_t shape) const
  {
    return (*this)(walker, i, frame, shape, every(), true);
  }

  /// The same in disks, for slopes.
  Candidates all_for_slopes(Walker<Neighbors>& walker, std::size_t i, const Local_frame& frame) const
  {
    return m_fitter(walker, i, frame, 1, m_grid, 1, every(), true);
  }

  Comparisons compare(const Candidates& candidates, std::size_t i, const Target& target) const
  {
    return compare_all(candidates, m_grid, target, m_squares_of_noise[i]);
  }

  /// Among candidates of vertex i.
  /// \param own what comparing them says
  /// \param of_all the model for all components, or null
  Choice choose(const Bias_model& model, const Comparisons& own, const Candidates& candidates, std::size_t i,
                std::size_t shape, std::size_t target, const Bias_model* of_all) const
  {
    Choice choice =
        choose_with_own_say(candidates, own, model, of_all, m_grid, targets_of_order_2[target], m_squares_of_noise[i]);
    choice.shape = shape;
    return choice;
  }

  Choice choose(const Bias_model& model, const Candidates& candidates, std::size_t i, std::size_t shape,
                std::size_t target, const Bias_model* of_all) const
  {
    return choose(model, compare(candidates, i, targets_of_order_2[target]), candidates, i, shape, target, of_all);
  }

private:
  Selection every() const { return Selection(m_grid, m_grid.radii.size()); }

  const Surface& m_surface;
  const std::vector<double>& m_squares_of_noise;
  Candidate_grid m_grid;
  Disk_fitter<Neighbors> m_fitter;
};

/// By the weights of a choice. \param values values(candidate) are so many
template <std::size_t size, class Values>
std::array<double, size> mean_of(const Candidates& candidates, const Choice& choice, const Values& values)
{
  std::array<double, size> result{};
  double sum = 0;
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    if (!is_used(choice, c)) continue;
    sum += choice.weights[c];
    for (std::size_t k = 0; k < size; ++k) result[k] += choice.weights[c] * values(candidates[c])[k];
  }
  for (double& value : result) value /= sum;
  return result;
}

/// Of z_xx, sqrt(2) z_xy, z_yy.
inline std::array<double, 3> mean(const Candidates& candidates, const Choice& choice)
{
  return mean_of<3>(
      candidates, choice, [](const Candidate& c) -> const auto& { return c.values; });
}

/// Of z_x, z_y.
inline std::array<double, 2> mean_slopes(const Candidates& candidates, const Choice& choice)
{
  return mean_of<2>(
      candidates, choice, [](const Candidate& c) -> const auto& { return c.slopes; });
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_SECOND_ORDER_FITS_H
