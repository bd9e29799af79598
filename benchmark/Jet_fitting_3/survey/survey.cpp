// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The survey of 2026 on differential estimators for point clouds, run again for the automatic choice: its surfaces, its
// noise, its measure of errors, beside its best estimators, each of which has its best radius on each surface, knowing
// the truth. The points are not the survey's own.
//
//     survey PUBLISHED.tsv [SURFACE|all [SIGMA|all [POINTS [EVERY]]]]
//
// Root mean squares and medians over every EVERY-th point (20). "seed": position and normal noise from one seed, as in
// the survey: the normal's noise is ten times the point's, vector by vector. "free": independent.

#include "samples.h"

#include <CGAL/Jet_fitting_3/clouds/Cloud_scale.h>
#include <CGAL/Jet_fitting_3/solvers/Orthogonal_solver.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <tuple>

namespace jets = CGAL::Jet_fitting;
namespace scale = CGAL::Jet_fitting::scale;
using survey::Vector;

namespace {

// [surface, sigma, quantity]: the best of all, the best of those that use no normals.
using Published = std::map<std::tuple<std::string, double, std::string>, std::pair<double, double>>;

Published read_published(const char* name)
{
  Published published;
  std::ifstream file(name);
  if (!file) throw std::runtime_error(std::string(name) + " cannot be read");
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string surface, quantity, by;
    double sigma, all, positions;
    if (words >> surface >> sigma >> quantity >> all >> by >> positions)
      published[{surface, sigma, quantity}] = {all, positions};
  }
  return published;
}

survey::Found found(const scale::Estimate_at_scale& e)
{
  const double k1 = e.coefficients[0], k2 = e.coefficients[1];
  return {(k1 + k2) / 2, k1, k2, e.monge_axes.x, e.monge_axes.y, e.monge_axes.z};
}

struct Row
{
  std::array<double, survey::number_of_quantities> rms, median;
};

struct Within
{
  const survey::Grid* grid;
  const std::vector<Vector>* points;
  void operator()(std::size_t i, double radius, scale::Indices& near) const { (*grid)((*points)[i], radius, near); }
};

Row run(const survey::Surface& surface, const std::vector<Vector>& exact, double sigma, bool with_normals,
        bool one_seed, std::size_t every)
{
  const auto [points, normals] = survey::noisy_samples(surface, exact, sigma, one_seed);
  const survey::Grid grid(points, .08);
  const scale::Cloud cloud{points.data(), with_normals ? normals.data() : nullptr, points.size()};
  const scale::Cloud_scale<Within> automatic(cloud, Within{&grid, &points});
  jets::Orthogonal_solver<double> solver;
  scale::Indices near;
  std::array<std::vector<double>, survey::number_of_quantities> all;
  for (std::size_t i = 0; i < points.size(); i += every) {
    const auto e = survey::errors(found(automatic.estimate(i, 2, solver, near)), survey::truth(surface, exact[i]));
    for (std::size_t q = 0; q < e.size(); ++q) all[q].push_back(e[q]);
  }
  Row row;
  for (std::size_t q = 0; q < all.size(); ++q) {
    double squares = 0;
    for (const double e : all[q]) squares += e * e;
    row.rms[q] = std::sqrt(squares / double(all[q].size()));
    row.median[q] = scale::median(all[q]);
  }
  return row;
}

void print(const std::string& surface, double sigma, const std::string& from, const Row& row,
           const Published& published)
{
  std::printf("%-13s %-6g %-10s", surface.c_str(), sigma, from.c_str());
  for (std::size_t q = 0; q < survey::number_of_quantities; ++q) {
    const auto peer = published.find({surface, sigma, survey::quantities[q]});
    std::printf("  %s %.3g (%.3g)", survey::quantities[q], row.rms[q], row.median[q]);
    if (peer != published.end()) std::printf(" | %.3g", from == "positions" ? peer->second.second : peer->second.first);
  }
  std::printf("\n");
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
  const auto argument = [&](int k, const char* otherwise) { return std::string(argc > k ? argv[k] : otherwise); };
  if (argc < 2) {
    std::cerr << "usage: survey PUBLISHED.tsv [SURFACE|all [SIGMA|all [POINTS [EVERY]]]]\n";
    return 1;
  }
  const Published published = read_published(argv[1]);
  const std::string which = argument(2, "all"), level = argument(3, "all");
  const std::size_t size = std::stoul(argument(4, "50000")), every = std::stoul(argument(5, "20"));
  std::cout << "surface sigma data: quantity RMS (median) | the survey's best\n";
  for (const auto& [name, surface] : survey::surfaces()) {
    if (which != "all" && which != name) continue;
    const std::vector<Vector> exact = survey::spread_points(surface, size);
    for (const double sigma : survey::sigmas(level)) {
      print(name, sigma, "positions", run(surface, exact, sigma, false, false, every), published);
      print(name, sigma, "free", run(surface, exact, sigma, true, false, every), published);
      if (sigma > 0) print(name, sigma, "seed", run(surface, exact, sigma, true, true, every), published);
    }
  }
}
