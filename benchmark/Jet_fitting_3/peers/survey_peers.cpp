// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The survey's own estimators on the points of survey/survey.cpp, to stand beside what that prints.
//
//     survey_peers [SURFACE|all [SIGMA|all [POINTS [EVERY]]]]
//
// For each quantity the least root mean square error over estimators and radii, knowing the truth, with their names.
// "positions": of those that use no normals. Needs PEERS_DIR with the sources of the survey's benchmark in survey/
// (STORM-IRIT/pcloud-differential-estimation-benchmark, commit 499e0e3) and of Ponca in ponca/ (commit 19ef58f).
// Nothing of them is copied.

#include "../survey/samples.h"

#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>

#include <Eigen/Dense>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

using Scalar = double; // for the survey's headers
#include <ponca_estimators/adapters/EstimatorFactory.h>
#include <ponca_estimators/adapters/declarations.h>

using survey::Vector;

namespace {

Vector vector_of(const VectorType& v) { return {v[0], v[1], v[2]}; }
template <class V>
Vector vector_of_cgal(const V& v)
{
  return {v.x(), v.y(), v.z()};
}

std::optional<survey::Found> found_by(BaseEstimator& estimator, int i)
{
  Quantity<Scalar> q;
  estimator(i, q);
  if (q.non_stable || !std::isfinite(q.k1) || !std::isfinite(q.k2)) return std::nullopt;
  return survey::Found{q.mean, q.k1, q.k2, vector_of(q.d1), vector_of(q.d2), vector_of(q.normal)};
}

// As the survey has it: degree 4, no weights.
std::optional<survey::Found> found_by_jet(int i)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  std::vector<Kernel::Point_3> near;
  const auto add = [&near](int k) {
    const VectorType p = ponca_kdtree->points()[std::size_t(k)].pos();
    near.emplace_back(p[0], p[1], p[2]);
  };
  add(i);
  for (const int k : ponca_kdtree->rangeNeighbors(i, radius)) add(k);
  if (near.size() < 15) return std::nullopt;
  CGAL::Monge_via_jet_fitting<Kernel> fit;
  const auto form = fit(near.begin(), near.end(), 4, 2);
  const double k1 = form.principal_curvatures(0), k2 = form.principal_curvatures(1);
  return survey::Found{(k1 + k2) / 2,
                       k1,
                       k2,
                       vector_of_cgal(form.maximal_principal_direction()),
                       vector_of_cgal(form.minimal_principal_direction()),
                       vector_of_cgal(form.normal_direction())};
}

struct Best
{
  double error = std::numeric_limits<double>::infinity();
  std::string name;
  double radius = 0;
};
using Best_of_quantities = std::array<Best, survey::number_of_quantities>;

// Those that say nothing of a curvature, by definition, do not count for it.
bool is_estimated(const std::string& name, const std::string& quantity)
{
  return quantity != "K1" || (name != "UnorientedSphere" && name != "PC-MLS");
}

// Not where more than a tenth of the points have no estimate.
template <class Find>
void compare(Best_of_quantities& best, const std::string& name, const Find& find, const survey::Surface& surface,
             const std::vector<Vector>& exact, std::size_t every)
{
  std::array<double, survey::number_of_quantities> squares{};
  double count = 0, asked = 0;
  for (std::size_t i = 0; i < exact.size(); i += every) {
    asked += 1;
    const std::optional<survey::Found> found = find(int(i));
    if (!found) continue;
    count += 1;
    const auto e = survey::errors(*found, survey::truth(surface, exact[i]));
    for (std::size_t q = 0; q < e.size(); ++q) squares[q] += e[q] * e[q];
  }
  if (count < 0.9 * asked) return;
  for (std::size_t q = 0; q < squares.size(); ++q) {
    const double error = std::sqrt(squares[q] / count);
    if (is_estimated(name, survey::quantities[q]) && error < best[q].error) best[q] = {error, name, radius};
  }
}

void take_best(Best_of_quantities& best, const Best_of_quantities& other)
{
  for (std::size_t q = 0; q < best.size(); ++q)
    if (other[q].error < best[q].error) best[q] = other[q];
}

void print(const std::string& surface, double sigma, const char* from, const Best_of_quantities& best)
{
  std::printf("%-13s %-6g %-10s", surface.c_str(), sigma, from);
  for (std::size_t q = 0; q < best.size(); ++q)
    std::printf("  %s %.3g %s %g", survey::quantities[q], best[q].error, best[q].name.c_str(), best[q].radius);
  std::printf("\n");
  std::fflush(stdout);
}

void build_tree(const survey::Samples& samples)
{
  std::vector<VectorType> points, normals;
  for (const Vector& p : samples.points) points.emplace_back(p.x, p.y, p.z);
  for (const Vector& n : samples.normals) normals.emplace_back(n.x, n.y, n.z);
  buildKdTree<PPAdapter, VectorType>(points, normals, ponca_kdtree);
}

using Factory = EstimatorFactory<SmoothWeightFunc>;

void run(Factory& factory, const std::string& name, const survey::Surface& surface, const std::vector<Vector>& exact,
         double sigma, std::size_t every)
{
  Best_of_quantities positions;
  for (const bool from_one_seed : {false, true}) {
    if (from_one_seed && sigma == 0) continue;
    build_tree(survey::noisy_samples(surface, exact, sigma, from_one_seed));
    Best_of_quantities best;
    for (const double r : {.05, .075, .1, .125, .15, .2}) {
      radius = r;
      for (const char* estimator : {"ShapeOperator", "ASO", "AvgHexagram", "VarifoldsMeanPlane", "3DQuadric", "2-Monge",
                                    "WaveJets", "OrientedWaveJets", "UnorientedSphere", "PC-MLS", "Cov2D"}) {
        const std::shared_ptr<BaseEstimator> e = factory.getEstimator(estimator);
        if (!e->isOriented() && from_one_seed) continue; // positions are the same
        compare(
            e->isOriented() ? best : positions, estimator, [&e](int i) { return found_by(*e, i); }, surface, exact,
            every);
      }
      if (!from_one_seed) compare(positions, "JetFitting", found_by_jet, surface, exact, every);
    }
    take_best(best, positions);
    if (!from_one_seed) print(name, sigma, "positions", positions);
    print(name, sigma, from_one_seed ? "seed" : "free", best);
  }
}

} // namespace

int main(int argc, char** argv)
{
  const auto argument = [&](int k, const char* otherwise) { return std::string(argc > k ? argv[k] : otherwise); };
  const std::string which = argument(1, "all"), level = argument(2, "all");
  const std::size_t size = std::stoul(argument(3, "50000")), every = std::stoul(argument(4, "20"));
  Factory factory;
  for (const auto& [name, surface] : survey::surfaces()) {
    if (which != "all" && which != name) continue;
    const std::vector<Vector> exact = survey::spread_points(surface, size);
    for (const double sigma : survey::sigmas(level)) run(factory, name, surface, exact, sigma, every);
  }
}
