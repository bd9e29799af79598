// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Mean curvatures and normals at every point of a torus in random order, exact and with noise: this package, Ponca's
// Monge patch, PCL's normals, and CGAL's jet_estimate_normals(). One thread.
// Needs PEERS_DIR with the sources of Ponca, and PCL (Debian: libpcl-dev); nothing of them is copied.

#include "Torus.h"

#include <CGAL/Jet_fitting_3/neighborhoods/automatic.h>
#include <CGAL/Jet_fitting_3/neighborhoods/nearest.h>
#include <CGAL/Jet_fitting_3/quantities.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/estimate_point_monge_forms.h>
#include <CGAL/jet_estimate_normals.h>
#include <CGAL/property_map.h>

#include <Ponca/Fitting>
#include <Ponca/SpatialPartitioning>
#include <Ponca/src/Common/pointTypes.h>

#include <pcl/features/normal_3d.h>
#include <pcl/search/kdtree.h>

#include <cmath>
#include <iterator>
#include <string>
#include <utility>

using Samples = std::vector<peers::Sample>;
using Answers = peers::Answers;

// This package, and CGAL.

using Kernel = CGAL::Simple_cartesian<double>;
using Point_and_normal = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using Point_map = CGAL::First_of_pair_property_map<Point_and_normal>;
using Normal_map = CGAL::Second_of_pair_property_map<Point_and_normal>;
using Form = CGAL::Monge_via_jet_fitting<Kernel>::Monge_form;

std::vector<Point_and_normal> cgal_points(const Samples& samples)
{
  std::vector<Point_and_normal> points;
  for (const auto& [p, n, h] : samples)
    points.emplace_back(Kernel::Point_3(p[0], p[1], p[2]), Kernel::Vector_3(n[0], n[1], n[2]));
  return points;
}

template <class Neighborhood>
void monge_forms(benchmark::State& state, const Samples& samples, const Neighborhood& neighborhood, unsigned degree,
                 bool use_normals)
{
  const auto points = cgal_points(samples);
  CGAL::Jet_fitting::Options options;
  options.use_normals = use_normals;
  const auto parameters = CGAL::parameters::point_map(Point_map()).degree_fitting(degree).degree_monge(2);
  std::vector<Form> forms;
  for (auto _ : state) {
    forms.clear();
    if (use_normals)
      CGAL::estimate_point_monge_forms(points, neighborhood, std::back_inserter(forms),
                                       parameters.normal_map(Normal_map()), options);
    else CGAL::estimate_point_monge_forms(points, neighborhood, std::back_inserter(forms), parameters, options);
  }
  Answers answers;
  for (const Form& form : forms) {
    const auto n = form.normal_direction();
    // without normals the side of a form is arbitrary: outwards here
    const double side = n * points[answers.normals.size()].second < 0 ? -1 : 1;
    answers.mean_curvatures.push_back(side * CGAL::Jet_fitting::mean_curvature(form));
    answers.normals.push_back({n.x(), n.y(), n.z()});
  }
  report(state, samples, answers);
}

void normals_of_cgal(benchmark::State& state, const Samples& samples, unsigned neighbors)
{
  auto points = cgal_points(samples);
  for (auto _ : state)
    CGAL::jet_estimate_normals<CGAL::Sequential_tag>(
        points, neighbors, CGAL::parameters::point_map(Point_map()).normal_map(Normal_map()).degree_fitting(2));
  Answers answers;
  for (const auto& [p, n] : points) answers.normals.push_back({n.x(), n.y(), n.z()});
  report(state, samples, answers);
}

// Ponca

using Ponca_point = Ponca::PointPositionNormal<double, 3>;
using Smooth_weight = Ponca::DistWeightFunc<Ponca_point, Ponca::SmoothWeightKernel<double>>;
using Monge_patch = Ponca::Basket<Ponca_point, Smooth_weight, Ponca::MongePatchQuadraticFit>;

// The weight vanishes at the farthest neighbor.
template <class Fit>
void fit_of_ponca(benchmark::State& state, const Samples& samples, int neighbors)
{
  std::vector<Ponca_point> points;
  for (const auto& [p, n, h] : samples) points.emplace_back(Eigen::Vector3d(p.data()), Eigen::Vector3d(n.data()));
  Answers answers;
  for (auto _ : state) {
    answers = Answers();
    const Ponca::KdTreeDense<Ponca_point> tree(points);
    std::vector<int> found;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector3d& p = points[i].pos();
      found.assign(1, int(i));
      double square = 0;
      for (const int j : tree.kNearestNeighbors(int(i), neighbors)) {
        found.push_back(j);
        square = std::max(square, (points[std::size_t(j)].pos() - p).squaredNorm());
      }
      Fit fit;
      fit.setNeighborFilter({p, std::sqrt(square)});
      fit.computeWithIds(found, points);
      const Eigen::Vector3d n = fit.primitiveGradient(p).normalized();
      const double side = n.dot(points[i].normal()) < 0 ? -1 : 1;
      answers.mean_curvatures.push_back(side * fit.kMean());
      answers.normals.push_back({n[0], n[1], n[2]});
    }
  }
  report(state, samples, answers);
}

// PCL

void normals_of_pcl(benchmark::State& state, const Samples& samples, int neighbors)
{
  const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  for (const auto& [p, n, h] : samples) cloud->push_back({float(p[0]), float(p[1]), float(p[2])});
  pcl::PointCloud<pcl::Normal> normals;
  for (auto _ : state) {
    pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
    estimation.setInputCloud(cloud);
    estimation.setSearchMethod(pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>());
    estimation.setKSearch(neighbors + 1);
    estimation.compute(normals);
  }
  Answers answers;
  for (const pcl::Normal& n : normals) answers.normals.push_back({n.normal_x, n.normal_y, n.normal_z});
  report(state, samples, answers);
}

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  for (const std::size_t size : {25000, 1000000})
    for (const double noise : {0., 0.001, 0.005}) {
      if (size > 25000 && noise > 0) continue;
      const auto add = [size, noise](const std::string& name, const auto& job) {
        const std::string full =
            "torus_" + std::to_string(size) + "/noise:" + std::to_string(noise).substr(0, 5) + '/' + name;
        benchmark::RegisterBenchmark(full.c_str(), [size, noise, job](benchmark::State& state) {
          job(state, peers::noisy(peers::scattered(size), noise));
        })->Unit(benchmark::kMillisecond);
      };
      for (const auto& [degree, neighbors] : {std::pair<unsigned, std::ptrdiff_t>{2, 19}, {4, 40}})
        for (const bool use_normals : {false, true})
          add("ours/d:" + std::to_string(degree) + "/neighbors:" + std::to_string(neighbors) +
                  (use_normals ? "/with_normals" : ""),
              [d = degree, k = neighbors, use_normals](benchmark::State& state, const Samples& samples) {
                monge_forms(state, samples, CGAL::Jet_fitting::nearest(k + 1), d, use_normals);
              });
      if (size == 25000)
        add("ours/automatic", [](benchmark::State& state, const Samples& samples) {
          monge_forms(state, samples, CGAL::Jet_fitting::automatic(), 4, false);
        });
      for (const int neighbors : {19, 40}) {
        const std::string k = "/neighbors:" + std::to_string(neighbors);
        add("Ponca/Monge_patch" + k, [neighbors](benchmark::State& state, const Samples& samples) {
          fit_of_ponca<Monge_patch>(state, samples, neighbors);
        });
        add("PCL/normals" + k, [neighbors](benchmark::State& state, const Samples& samples) {
          normals_of_pcl(state, samples, neighbors);
        });
      }
      add("CGAL/jet_estimate_normals/neighbors:19",
          [](benchmark::State& state, const Samples& samples) { normals_of_cgal(state, samples, 19); });
    }
  benchmark::RunSpecifiedBenchmarks();
}
