// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_SCALE_SURFACE_DISK_H
#define CGAL_JET_FITTING_3_SCALE_SURFACE_DISK_H

#include <CGAL/Jet_fitting_3/numeric/Vector_3.h>
#include <CGAL/Jet_fitting_3/scale/Candidate.h>
#include <CGAL/Jet_fitting_3/scale/Estimated_variance.h>
#include <CGAL/Jet_fitting_3/values/Basis_3.h>
#include <CGAL/Jet_fitting_3/values/Local_frame.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace averaging {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// A tangent plane: a point on the surface near a vertex, and the normal there.
struct Tangent_plane
{
  Vector_3<double> origin, normal;
  double lean = 0; ///< how far the middle of three rings lies beside the vertex, in units: about 1 at a border
  double bend = 0; ///< the mean square of the principal curvatures, per square of the unit
};

/// How edges around a vertex differ by direction: those along one are so many times as long as those across it.
struct Stretch
{
  Vector_3<double> direction; ///< of length 1, if the ratio is not 1
  double ratio = 1;
};

/// Normals as data, of length 1; those that are unknown are 0.
struct Given_normals
{
  std::vector<Vector_3<double>> normals;
  std::vector<double> weights; ///< of the square of a slope, that of a height in the unit of the vertex being 1
  double factor = 1;           ///< makes noisy normals as long in the mean as those without noise
  double noise = 0;
  bool suffice_in_one_ring = false; ///< they count as much there as positions for a fit of degree 4

  bool is_known(std::size_t i) const { return dot(normals[i], normals[i]) > 0; }
};

/// Whether the given normals are better than others: these differ from them by more than the given ones' noise, and as
/// much of their own, explains.
inline bool are_better(const Given_normals& given, const std::vector<Vector_3<double>>& normals)
{
  std::vector<double> squares;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const Vector_3<double> across = cross(given.normals[i], normals[i]);
    if (given.is_known(i)) squares.push_back(dot(across, across));
  }
  const double of_two_squares = 2 * std::log(2.); // the median of the sum of two squares of normal variables
  return !squares.empty() && scale::median(squares) > of_two_squares * 2 * given.noise * given.noise;
}

/// Points of a surface whose neighbors are known. Arrays are not owned.
/// \tparam Neighbors neighbors(i) is a range of the numbers of the vertices to which the surface continues from i
template <class Neighbors>
struct Surface_points
{
  const std::vector<Vector_3<double>>& points;
  const std::vector<Vector_3<double>>& normals; ///< of length 1, smooth enough to tell where the surface turns
  Neighbors neighbors;
  const std::vector<double>& units;                   ///< at all points, of radii: the length of the edges around
  const std::vector<Tangent_plane>* planes = nullptr; ///< at all points, if they are known
  const std::vector<Stretch>* stretches = nullptr;    ///< at all points; null: edges are as long in all directions
  const Given_normals* given = nullptr;               ///< if they are data

  double stretch(std::size_t i) const { return stretches ? (*stretches)[i].ratio : 1; }
};

/// The slopes that a normal in a frame tells. None are told by normals that are unknown, or lean far.
inline std::optional<Slope> slope_of(const Vector_3<double>& normal)
{
  constexpr double least_cosine = 0.2;
  if (!(normal.z > least_cosine)) return std::nullopt;
  return Slope{-normal.x / normal.z, -normal.y / normal.z};
}

/// Any axes with this z, which need not have length 1.
inline Basis_3<double> axes_around(const Vector_3<double>& direction)
{
  const Vector_3<double> z = 1 / std::sqrt(dot(direction, direction)) * direction;
  const Vector_3<double> other = std::abs(z.x) < 0.7 ? Vector_3<double>{1, 0, 0} : Vector_3<double>{0, 1, 0};
  const Vector_3<double> x = cross(other, z);
  const Vector_3<double> unit_x = 1 / std::sqrt(dot(x, x)) * x;
  return {unit_x, cross(z, unit_x), z};
}

/// In which edges at point i are as long in all directions: areas stay, the axes are no longer of length 1. A plane at
/// the point whose normal is axes.z.
template <class Neighbors>
Basis_3<double> round_axes(const Surface_points<Neighbors>& surface, std::size_t i, const Basis_3<double>& axes)
{
  if (surface.stretch(i) == 1) return axes;
  const Stretch& stretch = (*surface.stretches)[i];
  const Vector_3<double> in_plane = stretch.direction - dot(stretch.direction, axes.z) * axes.z;
  const double square = dot(in_plane, in_plane);
  if (!(square > 0)) return axes;
  const double across = std::sqrt(stretch.ratio), along = 1 / across;
  const auto map = [&](const Vector_3<double>& a) {
    return across * a + (along - across) * (dot(a, in_plane) / square) * in_plane;
  };
  return {map(axes.x), map(axes.y), axes.z};
}

/// Any axes of this kind with this z, which need not have length 1.
template <class Neighbors>
Basis_3<double> axes_around(const Surface_points<Neighbors>& surface, std::size_t i, const Vector_3<double>& direction)
{
  return round_axes(surface, i, axes_around(direction));
}

/// As far as the surface turns by 60 degrees heights over the tangent plane are polynomials of low degree.
constexpr double least_cosine_of_heights = 0.5;

/// Potentials are polynomials of low degree farther.
constexpr double least_cosine_of_potentials = 0.3;

/// Collects vertices around one; keeps its tables from call to call. One a thread.
template <class Neighbors>
class Walker
{
public:
  explicit Walker(const Surface_points<Neighbors>& surface) : m_surface(surface), m_seen(surface.points.size(), 0) {}

  /// The vertices at most so many edges away, ring by ring; ends[k] is where ring k ends.
  void rings(std::size_t seed, std::size_t number, std::vector<std::size_t>& found, std::vector<std::size_t>& ends)
  {
    ++m_turn;
    found.assign(1, seed);
    ends.assign(1, 1);
    m_seen[seed] = m_turn;
    for (std::size_t k = 0, begin = 0; k < number; ++k) {
      const std::size_t end = found.size();
      for (; begin < end; ++begin)
        for (const std::size_t v : m_surface.neighbors(found[begin]))
          if (see(v)) found.push_back(v);
      ends.push_back(found.size());
    }
  }

  /// The first rings, of `fewest` to six, that have so many vertices, and one ring more.
  /// \return the number of the rings without that one
  std::size_t first_rings(std::size_t seed, std::size_t fewest, std::size_t least, std::vector<std::size_t>& found,
                          std::vector<std::size_t>& ends)
  {
    constexpr std::size_t most = 6;
    rings(seed, most + 1, found, ends);
    std::size_t number = fewest;
    while (number < most && ends[number] < least) ++number;
    return number;
  }

  /// Some of the vertices around one, from inside out.
  struct Disk
  {
    std::vector<std::size_t> vertices;
    std::vector<Vector_3<double>> places; ///< in the frame and the unit
    std::vector<std::size_t> ends;        ///< ends[s] is where shell s ends
  };

  /// What belongs to a disk.
  struct Extent
  {
    double unit;         ///< of the radii and places, in length
    double ratio;        ///< of the axes of the ellipse
    double least_cosine; ///< of the angle between a normal and the axis z
    std::size_t least;   ///< so many vertices are found even if the surface turns too far
    std::size_t most;    ///< a shell that exceeds it is left out
  };

  /// The part of the surface around the seed within ellipses around the axis z of the frame, up to the first `shells`
  /// radii, or those before the surface turns too far. Their areas are those of disks, their y axes are longer than
  /// their x axes. Is there until the next call.
  Disk& disk(std::size_t seed, const Local_frame& frame, const std::vector<double>& radii, std::size_t shells,
             const Extent& extent)
  {
    Disk& disk = m_disk;
    ++m_turn;
    disk.vertices.clear();
    disk.places.clear();
    disk.ends.clear();
    m_shells.resize(std::max(m_shells.size(), shells));
    for (Shell& shell : m_shells) shell.clear();
    std::vector<double> squares(radii.begin(), radii.begin() + std::ptrdiff_t(shells));
    for (double& r : squares) r *= r;
    const double per_unit = 1 / extent.unit;
    const Basis_3<double>& axes = frame.axes;
    const Local_frame in_units{frame.origin, {per_unit * axes.x, per_unit * axes.y, per_unit * axes.z}};
    const Ellipse ellipse{extent.ratio, 1 / extent.ratio, extent.least_cosine * per_unit};
    double reach = std::numeric_limits<double>::infinity(); // square
    m_seen[seed] = m_turn;
    if (shells > 0) m_shells[0].push_back({seed, in_units.in(m_surface.points[seed])});
    for (std::size_t s = 0; s < shells; ++s) {
      const bool is_enough = disk.vertices.size() >= extent.least;
      const auto is_too_large = [&] { return disk.vertices.size() + m_shells[s].size() > extent.most; };
      for (std::size_t k = 0; k < m_shells[s].size() && !is_too_large() && !(is_enough && squares[s] > reach); ++k)
        reach = std::min(reach, visit_neighbors(m_shells[s][k].vertex, in_units, squares, s, ellipse));
      if (is_too_large() || (is_enough && squares[s] > reach)) return disk;
      for (const Found& found : m_shells[s]) {
        disk.vertices.push_back(found.vertex);
        disk.places.push_back(found.place);
      }
      disk.ends.push_back(disk.vertices.size());
    }
    return disk;
  }

private:
  bool see(std::size_t v)
  {
    const bool is_new = m_seen[v] != m_turn;
    m_seen[v] = m_turn;
    return is_new;
  }

  struct Found
  {
    std::size_t vertex;
    Vector_3<double> place;
  };
  using Shell = std::vector<Found>;

  // Its squared radius is xx x^2 + yy y^2; normals have this z at least.
  struct Ellipse
  {
    double xx, yy, least_z;
  };

  // Puts them into shell s, or those farther out. Returns the smallest squared distance of those whose normals
  // are tilted too far.
  double visit_neighbors(std::size_t vertex, const Local_frame& frame, const std::vector<double>& squares,
                         std::size_t s, const Ellipse& ellipse)
  {
    double reach = std::numeric_limits<double>::infinity();
    for (const std::size_t v : m_surface.neighbors(vertex)) {
      if (!see(v)) continue;
      const Vector_3<double> q = frame.in(m_surface.points[v]);
      const double square = ellipse.xx * q.x * q.x + ellipse.yy * q.y * q.y;
      if (square > squares.back()) continue;
      if (dot(m_surface.normals[v], frame.axes.z) < ellipse.least_z) {
        reach = std::min(reach, square);
        continue;
      }
      std::size_t own = s;
      while (square > squares[own]) ++own;
      m_shells[own].push_back({v, q});
    }
    return reach;
  }

  const Surface_points<Neighbors>& m_surface;
  std::vector<std::size_t> m_seen;
  std::size_t m_turn = 0;
  std::vector<Shell> m_shells;
  Disk m_disk;
};

/// The tangent plane at a vertex, by two fits of degree 2 to three rings; the origin is on the second one.
template <class Neighbors>
Tangent_plane tangent_plane(const Surface_points<Neighbors>& surface, Walker<Neighbors>& walker, std::size_t i)
{
  const double unit = surface.units[i];
  std::vector<std::size_t> found, ends;
  walker.rings(i, 3, found, ends);
  std::vector<Vector_3<double>> places(found.size());
  Local_frame frame{surface.points[i], axes_around(surface, i, surface.normals[i])};
  double lean = 0, bend = 0;
  for (int round = 0; round < 2; ++round) {
    for (std::size_t k = 0; k < found.size(); ++k) places[k] = 1 / unit * frame.in(surface.points[found[k]]);
    Moments moments;
    moments.add<2>(places.data(), places.size());
    const Normal_matrix matrix(moments, 2);
    if (!matrix.is_regular()) break;
    const auto c = matrix.solution(moments.heights, 2);
    if (round > 0) frame.origin = frame.origin + frame.axes.out({0, 0, unit * c[0]});
    frame.axes = axes_around(surface, i, frame.axes.out({-c[1], -c[2], 1}));
    lean = std::hypot(moments.terms[1], moments.terms[2]) / moments.size();
    bend = 2 * c[3] * c[3] + c[4] * c[4] + 2 * c[5] * c[5];
  }
  return {frame.origin, frame.axes.z, lean, bend};
}

/// A tangent plane by degree 4.
struct Finer_plane
{
  Tangent_plane plane;
  double square_of_turn; ///< from that of degree 2, in variances of the turn
};

/// To as few rings as determine the slopes about as well as whole disks do: three, and at borders, where these may hold
/// too few rows of vertices, up to six.
/// \param coarse the plane by degree 2
/// \return none where they do not suffice
template <class Neighbors>
std::optional<Finer_plane> finer_plane(const Surface_points<Neighbors>& surface, Walker<Neighbors>& walker,
                                       std::size_t i, const Tangent_plane& coarse, double square_of_noise)
{
  constexpr double most = 16; // times the variance of degree 2, with the same vertices; on whole disks 8 to 16
  constexpr std::size_t least = 20;
  const double unit = surface.units[i];
  const Local_frame frame{coarse.origin, axes_around(surface, i, coarse.normal)};
  const auto variance_of_slopes = [](const Normal_matrix& m) { return m.variance(1, 0) + m.variance(1, 1); };
  std::vector<std::size_t> found, ends;
  walker.rings(i, 6, found, ends);
  std::vector<Vector_3<double>> places;
  for (const std::size_t rings : {3, 4, 5, 6}) {
    for (std::size_t k = places.size(); k < ends[rings]; ++k)
      places.push_back(1 / unit * frame.in(surface.points[found[k]]));
    if (places.size() < least) continue;
    Moments moments;
    moments.add<4>(places.data(), places.size());
    const Normal_matrix matrix(moments, 4), lower(moments, 2);
    if (!matrix.is_regular() || !lower.is_regular()) continue;
    const double variance = variance_of_slopes(matrix);
    if (!(variance < most * variance_of_slopes(lower))) continue;
    const Coefficients c = matrix.solution(moments.heights, 1);
    Tangent_plane plane = coarse;
    plane.origin = frame.origin + frame.axes.out({0, 0, unit * c[0]});
    plane.normal = axes_around(surface, i, frame.axes.out({-c[1], -c[2], 1})).z;
    return Finer_plane{plane, (c[1] * c[1] + c[2] * c[2]) / (variance * square_of_noise)};
  }
  return std::nullopt;
}

/// Whether planes by degree 4 differ from those by degree 2 by far more than by noise: in the median of some vertices
/// by 30 standard deviations. All of a surface are of one kind, since a potential sees how the normals of
/// neighbors err beside each other.
template <class Neighbors>
bool need_finer_planes(const Surface_points<Neighbors>& surface, const std::vector<Tangent_plane>& planes,
                       const std::vector<double>& squares_of_noise)
{
  constexpr std::size_t some = 300;
  constexpr double far = 30 * 30;
  Walker<Neighbors> walker(surface);
  std::vector<double> squares;
  for (std::size_t k = 0; k < some; ++k) {
    const std::size_t i = k * planes.size() / some;
    if (i >= planes.size()) break;
    const auto finer = finer_plane(surface, walker, i, planes[i], squares_of_noise[i]);
    if (finer) squares.push_back(finer->square_of_turn);
  }
  return !squares.empty() && scale::median(squares) > far;
}

/// Its frame, in which edges are round; the plane is taken from the surface if it is there.
template <class Neighbors>
Local_frame tangent_frame(const Surface_points<Neighbors>& surface, Walker<Neighbors>& walker, std::size_t i)
{
  const Tangent_plane plane = surface.planes ? (*surface.planes)[i] : tangent_plane(surface, walker, i);
  return {plane.origin, axes_around(surface, i, plane.normal)};
}

/// The tangent planes at all vertices, by degree 4 where there is next to no noise: then potentials err by what normals
/// do. \param squares_of_noise, for_each as for Surface_choice
template <class Neighbors, class For_each>
std::vector<Tangent_plane> tangent_planes(const Surface_points<Neighbors>& surface,
                                          const std::vector<double>& squares_of_noise, const For_each& for_each)
{
  std::vector<Tangent_plane> planes(surface.points.size());
  const auto set_all = [&](const auto& set) {
    for_each(planes.size(),
             [&] { return [&, walker = Walker<Neighbors>(surface)](std::size_t i) mutable { set(walker, i); }; });
  };
  set_all([&](Walker<Neighbors>& walker, std::size_t i) { planes[i] = tangent_plane(surface, walker, i); });
  if (need_finer_planes(surface, planes, squares_of_noise))
    set_all([&](Walker<Neighbors>& walker, std::size_t i) {
      const auto finer = finer_plane(surface, walker, i, planes[i], squares_of_noise[i]);
      if (finer) planes[i] = finer->plane;
    });
  return planes;
}

/// Normals averaged with those of the neighbors, rounds[i] times that of i, or until they would turn farther: what is
/// beyond is another part of the surface, as around a tip.
/// \param least_cosine of the angle by which a normal may turn
template <class Neighbors>
std::vector<Vector_3<double>> smoothed(const std::vector<Vector_3<double>>& own, const Neighbors& neighbors,
                                       const std::vector<int>& rounds, double least_cosine = -1)
{
  std::vector<Vector_3<double>> normals = own;
  const int most = rounds.empty() ? 0 : *std::max_element(rounds.begin(), rounds.end());
  for (int round = 0; round < most; ++round) {
    const std::vector<Vector_3<double>> before = normals;
    for (std::size_t i = 0; i < normals.size(); ++i) {
      if (rounds[i] <= round) continue;
      for (const std::size_t v : neighbors(i)) normals[i] = normals[i] + before[v];
      const double length = std::sqrt(dot(normals[i], normals[i]));
      const bool is_near = length > 0 && dot(normals[i], own[i]) >= least_cosine * length;
      normals[i] = is_near ? 1 / length * normals[i] : before[i];
    }
  }
  return normals;
}

CGAL_JET_FITTING_3_END_NATIVE
} // namespace averaging
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_SCALE_SURFACE_DISK_H
