// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// libFuzzer harness for the class, with CGAL's kernels and without: any degrees, counts, options and coordinates.
// No signal, no exception but Invalid_input, frames orthonormal, k1 >= k2, everything finite unless the numbers
// themselves run out, and a pack gives what a single number gives.

#include "fuzz.h"

#include <CGAL/Jet_fitting_3/numeric/Pack.h>
#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

using namespace CGAL::Jet_fitting;

struct Vector
{
  Vector(double x, double y, double z) : c{{x, y, z}} {}
  double x() const { return c[0]; }
  double y() const { return c[1]; }
  double z() const { return c[2]; }
  std::array<double, 3> c;
};

struct Plain_kernel
{
  using FT = double;
  using Point_3 = Vector;
  using Vector_3 = Vector;
};

struct Converters
{
  struct D2L_converter
  {
    double operator()(double x) const { return x; }
  };
  using L2D_converter = D2L_converter;
};

using Plain_fit = CGAL::Jet_fitting::Monge_via_jet_fitting<Plain_kernel, Plain_kernel, Converters, Jacobi_svd<double>>;
using Cgal_kernel = CGAL::Simple_cartesian<double>;
using Cgal_fit = CGAL::Monge_via_jet_fitting<Cgal_kernel>;

struct Task
{
  std::size_t d, dprime;
  bool raw, given_frame;
  Fit_options options;
};

template <class Estimate>
void demand_soundness(const Estimate& e, const Task& task)
{
  const auto& form = e.monge_form();
  CGAL_FUZZ_DEMAND(form.degree() == task.dprime);
  CGAL_FUZZ_DEMAND(e.rank() <= number_of_jet_coefficients(task.d));
  CGAL_FUZZ_DEMAND(e.condition_number() >= 0.999999);
  const auto x = e.pca_basis(0), y = e.pca_basis(1), z = e.pca_basis(2);
  demand_frame(x.second, y.second, z.second);
  demand_frame(form.maximal_principal_direction(), form.minimal_principal_direction(), form.normal_direction());
  for (const double c : form.coefficients()) CGAL_FUZZ_DEMAND(task.raw ? !std::isnan(c) : std::isfinite(c));
  if (task.dprime >= 2) CGAL_FUZZ_DEMAND(form.principal_curvatures(0) >= form.principal_curvatures(1));
}

template <class Fit>
void estimate(const std::vector<typename Fit::Estimate::Local_vector_3>& vectors, const Task& task)
{
  using Vector_3 = typename Fit::Vector_3;
  std::vector<typename Fit::Point_3> points;
  for (const auto& v : vectors) points.emplace_back(v.x(), v.y(), v.z());
  const typename Fit::Given_basis basis{{Vector_3(0, 0, 1), Vector_3(1, 0, 0), Vector_3(0, 1, 0)}};
  const Fit fit;
  demand_soundness(task.given_frame
                       ? fit.estimate(points.begin(), points.end(), task.d, task.dprime, basis, task.options)
                       : fit.estimate(points.begin(), points.end(), task.d, task.dprime, task.options),
                   task);
}

/// The second lane sees the samples in another order of magnitude; both agree with the scalar path to rounding, in a
/// given frame, since that of the PCA may be ill-determined.
void demand_packs(const std::vector<Vector>& points, std::size_t d)
{
  using Pack = numeric::Pack<double, 2>;
  Samples<Pack> packs;
  Samples<double> numbers;
  packs.resize(points.size());
  numbers.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector_3<double> r{points[i].x() - points[0].x(), points[i].y() - points[0].y(),
                             points[i].z() - points[0].z()};
    if (!std::isfinite(r.x + r.y + r.z)) return;
    numbers.set(i, r);
    packs.set_lane(i, 0, r);
    packs.set_lane(i, 1, 0.125 * r);
  }
  Abstaining_solver<Pack> pack_solver;
  Orthogonal_solver<double> solver;
  const auto in_world = [](const auto& samples) {
    using FT = std::decay_t<decltype(samples[0].x)>;
    const FT one(1), zero(0);
    return fitting_basis(samples, Basis_3<FT>{{one, zero, zero}, {zero, one, zero}, {zero, zero, one}});
  };
  const auto p = CGAL::Jet_fitting::estimate(packs, d, d, in_world, pack_solver, {});
  const auto e = CGAL::Jet_fitting::estimate(numbers, d, d, in_world, solver, {});
  if (!p.fit.solution.trusted[0] || !p.fit.solution.trusted[1] || e.rank() < number_of_jet_coefficients(d)) return;
  double largest = 0, difference = 0;
  for (std::size_t j = 0; j < e.fit.solution.y.size(); ++j) {
    largest = (std::max)(largest, std::abs(e.fit.solution.y[j]));
    for (const int lane : {0, 1})
      difference = (std::max)(difference, std::abs(p.fit.solution.y[j][lane] - e.fit.solution.y[j]));
  }
  const double condition = e.condition_number(), epsilon = std::numeric_limits<double>::epsilon();
  const double bound =
      64 * epsilon * double(points.size()) * condition * (largest + condition * std::sqrt(e.fit.solution.square_sum));
  CGAL_FUZZ_DEMAND(difference <= bound + std::numeric_limits<double>::min());
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Bytes bytes(data, size);
  Task task;
  task.d = bytes.below(10);
  task.dprime = bytes.below(10);
  const std::size_t count = bytes.below(100);
  task.raw = bytes.below(2) == 1;
  task.given_frame = bytes.below(8) == 0;
  task.options.weighting = static_cast<Weighting>(bytes.below(4));
  task.options.loss = static_cast<Loss>(bytes.below(5));
  task.options.standard_errors = bytes.below(4) == 0;
  const unsigned door = bytes.below(4);
  if (bytes.below(4) == 0)
    for (std::size_t i = 0; i < count; ++i) task.options.point_weights.push_back(bytes.coordinate(task.raw));

  std::vector<Vector> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = bytes.coordinate(task.raw), y = bytes.coordinate(task.raw), z = bytes.coordinate(task.raw);
    points.emplace_back(x, y, z);
  }

  try {
    if (door == 0) {
      std::vector<Cgal_kernel::Vector_3> vectors;
      for (const Vector& p : points) vectors.emplace_back(p.x(), p.y(), p.z());
      estimate<Cgal_fit>(vectors, task);
    } else {
      estimate<Plain_fit>(points, task);
    }
    if (door == 1) demand_packs(points, task.d);
  } catch (const Invalid_input&) { // documented
  }
  return 0;
}
