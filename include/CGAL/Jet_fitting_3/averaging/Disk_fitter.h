// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_AVERAGING_DISK_FITTER_H
#define CGAL_JET_FITTING_3_AVERAGING_DISK_FITTER_H

#include <CGAL/Jet_fitting_3/averaging/Bias_model.h>
#include <CGAL/Jet_fitting_3/averaging/Height.h>
#include <CGAL/Jet_fitting_3/averaging/Walker.h>
#include <CGAL/Jet_fitting_3/averaging/candidate_of_moments.h>
#include <CGAL/Jet_fitting_3/averaging/whereabouts.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// The radii of disks end here, in units.
constexpr double largest_radius = 26;

/// From the smallest one to that.
inline std::vector<double> radii_of_disks(double smallest = 2)
{
  std::vector<double> radii;
  for (double r = smallest; r < largest_radius; r *= 1.2) radii.push_back(r);
  return radii;
}

/// Which candidates of a grid are wanted.
class Selection
{
public:
  /// None.
  Selection() = default;
  explicit Selection(const Candidate_grid& grid) : m_wanted(grid.size()) {}
  /// All of the first shells.
  Selection(const Candidate_grid& grid, std::size_t shells) : Selection(grid)
  {
    for (std::size_t c = 0; c < grid.size(); ++c)
      if (grid.shell(c) < shells) add(grid, c);
  }

  /// Those that a choice uses.
  void add(const Candidate_grid& grid, const Choice& choice)
  {
    for (std::size_t c = 0; c < grid.size(); ++c)
      if (is_used(choice, c)) add(grid, c);
  }

  /// One of them.
  void add(const Candidate_grid& grid, std::size_t c)
  {
    m_wanted[c] = true;
    m_degrees.resize(std::max(m_degrees.size(), grid.shell(c) + 1));
    for (std::size_t j = 0; j <= grid.shell(c); ++j) m_degrees[j] = std::max(m_degrees[j], grid.degree(c));
  }

  bool operator[](std::size_t candidate) const { return m_wanted[candidate]; }
  /// Whether there are any of a shell.
  bool has(const Candidate_grid& grid, std::size_t shell) const
  {
    bool result = false;
    for (std::size_t c = shell; c < grid.size(); c += grid.radii.size()) result = result || m_wanted[c];
    return result;
  }
  /// The number of shells that they need.
  std::size_t shells() const { return m_degrees.size(); }
  /// The highest degree for which a shell is needed.
  std::size_t degree(std::size_t shell) const { return m_degrees[shell]; }

private:
  std::vector<bool> m_wanted;
  std::vector<std::size_t> m_degrees;
};

/// Slopes of samples, and where these are, by shells.
struct Samples_with_slopes
{
  std::vector<Vector_3<double>> places;
  std::vector<Slope> slopes;
  std::vector<std::size_t> ends; ///< ends[j] is where shell j ends
};

/// The candidates for derivatives of an order that are selected, from samples in a frame and a unit.
/// \param with_slopes those of the samples that have slopes; may be none
/// \param ends ends[j] is where shell j ends
/// \param moments without samples
/// \param taper of samples without slopes, for a disk of radius 1
inline Candidates fits_to_shells(const std::vector<Vector_3<double>>& places, const Samples_with_slopes& with_slopes,
                                 const std::vector<std::size_t>& ends, Moments moments, const Taper& taper,
                                 const Candidate_grid& grid, std::size_t order, const Selection& selection,
                                 bool with_rows)
{
  constexpr std::size_t more = Taper::order;
  constexpr std::size_t untapered = 2; // this degree serves where noise is large, and each sample counts
  Candidates result(grid.size());
  const std::vector<Vector_3<double>>& sloping = with_slopes.places;
  moments.have_all_slopes = sloping.size() == places.size();
  for (std::size_t j = 0, k = 0, l = 0; j < ends.size(); ++j) {
    if (!selection.has(grid, j)) continue; // its samples are added with those of the next
    const bool is_tapered = taper.exists() && selection.degree(j) > untapered;
    Moments weighted;
    add_for_degree(selection.degree(j), with_rows, [&](auto degree, auto highest) {
      if (is_tapered) {
        moments.add<degree + more, highest + more>(places.data() + k, ends[j] - k);
        const double square = grid.radii[j] * grid.radii[j];
        weighted = tapered(moments, {taper.xx / square, taper.yy / square}, degree, highest);
        return;
      }
      moments.add<degree, highest>(places.data() + k, ends[j] - k);
      if (sloping.empty()) return;
      moments.add_slopes<degree, highest>(sloping.data() + l, with_slopes.slopes.data() + l, with_slopes.ends[j] - l);
      l = with_slopes.ends[j];
    });
    k = ends[j];
    if (j > 0 && k - ends[j - 1] < 3) continue; // the same fit again
    for (std::size_t c = j; c < grid.size(); c += grid.radii.size()) {
      if (!selection[c]) continue;
      const std::size_t degree = grid.degree(c);
      const Moments& own = is_tapered && degree > untapered ? weighted : moments;
      result[c] = candidate(own, degree, j, grid.radii[j], order, with_rows);
    }
  }
  return result;
}

/// Fits to disks, or ellipses, around a vertex.
template <class Neighbors>
class Disk_fitter
{
public:
  explicit Disk_fitter(const Surface_points<Neighbors>& surface, Height height = Height::z)
    : m_surface(surface), m_height(height)
  {}

  Height height() const { return m_height; }

  /// The candidates at vertex i, in its unit, for derivatives of the given order that are selected.
  /// \param ratio of the axes of the ellipses
  /// \param with_rows or their values alone
  Candidates operator()(Walker<Neighbors>& walker, std::size_t i, const Local_frame& frame, double ratio,
                        const Candidate_grid& grid, std::size_t order, const Selection& selection, bool with_rows) const
  {
    typename Walker<Neighbors>::Disk& disk =
        walker.disk(i, frame, grid.radii, selection.shells(), {m_surface.units[i], ratio, least_cosine(), least, most});
    const Samples_with_slopes with_slopes = m_surface.has_slopes() ? slopes_of(disk, frame) : Samples_with_slopes();
    if (m_height == Height::potential)
      for (std::size_t k = 0; k < disk.places.size(); ++k)
        disk.places[k].z *= potential_over_z(m_surface.normals[disk.vertices[k]], frame.axes.z);
    Moments moments;
    if (m_surface.has_slopes()) {
      moments.slope_weight = m_surface.given->weights[i];
      moments.are_of_potentials = m_height == Height::potential;
    }
    const Taper taper = m_surface.has_slopes() ? Taper() : Taper{fall * ratio, fall / ratio};
    return fits_to_shells(disk.places, with_slopes, disk.ends, moments, taper, grid, order, selection, with_rows);
  }

private:
  static constexpr std::size_t least = 20, most = 2500; // vertices; with 20 degree 4 is possible
  static constexpr double fall = 0.9;                   // of weights towards the rim

  double least_cosine() const { return m_height == Height::z ? least_cosine_of_heights : least_cosine_of_potentials; }

  // Those that the normals tell; of the potential, their tangential parts.
  Samples_with_slopes slopes_of(const typename Walker<Neighbors>::Disk& disk, const Local_frame& frame) const
  {
    Samples_with_slopes result;
    for (std::size_t j = 0, k = 0; j < disk.ends.size(); ++j) {
      for (; k < disk.ends[j]; ++k) {
        const Vector_3<double> n = frame.axes.in(m_surface.given->normals[disk.vertices[k]]);
        const std::optional<Slope> slope = slope_of(n);
        if (!slope) continue;
        const double factor = -m_surface.given->factor;
        result.slopes.push_back(m_height == Height::z ? *slope : Slope{factor * n.x, factor * n.y});
        result.places.push_back(disk.places[k]);
      }
      result.ends.push_back(result.places.size());
    }
    return result;
  }

  const Surface_points<Neighbors>& m_surface;
  Height m_height;
};

/// Fits to disks for Order_choice.
template <class Neighbors>
class Fits_to_disks
{
public:
  using Vertex = std::size_t;
  using Worker = Walker<Neighbors>;

  /// \param squares_of_noise as for Surface_choice
  /// \param height potentials, which have the surface's derivatives to order 3, are taken for that order only
  Fits_to_disks(const Surface_points<Neighbors>& surface, const std::vector<double>& squares_of_noise,
                std::size_t order, Height height)
    : m_surface(surface), m_squares_of_noise(squares_of_noise), m_order(order),
      m_fitter(surface, order == 3 ? height : Height::z)
  {}

  Worker worker() const { return Worker(m_surface); }
  std::size_t order() const { return m_order; }
  Whereabouts place(Vertex i) const { return whereabouts_on_component(m_surface, i); }
  double square_of_noise(Vertex i) const { return m_squares_of_noise[i]; }
  /// Those of the fits.
  Basis_3<double> axes(Vertex i, const Basis_3<double>& axes) const { return round_axes(m_surface, i, axes); }

  Candidates operator()(Worker& walker, Vertex i, const Local_frame& frame, const Candidate_grid& grid,
                        const Selection& selection, bool with_rows) const
  {
    return m_fitter(walker, i, frame, 1, grid, m_order, selection, with_rows);
  }

private:
  const Surface_points<Neighbors>& m_surface;
  const std::vector<double>& m_squares_of_noise;
  std::size_t m_order;
  Disk_fitter<Neighbors> m_fitter;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_AVERAGING_DISK_FITTER_H
