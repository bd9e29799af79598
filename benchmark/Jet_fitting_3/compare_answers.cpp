// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Compares two files of answers (answers.h), ours and CGAL's, form by form. For each job and each order, principal
// curvatures k, third order b, fourth order c: the largest differences relative to the largest coefficient of that
// order (or to the power of the curvatures with the same dimension, where all of the order are smaller, as on a line of
// symmetry), after turning both frames alike (the sign of d1 is free), and how many forms differ by more than 1e-9. For
// up to 200 of these the samples are fitted again in 50 digits: the last columns are the largest errors of both sides
// there, and how often ours is the larger one by more than 1e-9.
// usage: compare_answers <ours> <CGAL's> [folder of CGAL's data]

#include "fit_samples.h"
#include "mesh_job.h"

#include "../../test/Jet_fitting_3/reference_fit.h"

#include <CGAL/Jet_fitting_3/neighborhoods/Vertex_gatherer.h>
#include <CGAL/Jet_fitting_3/neighborhoods/k_rings.h>

#include <cstdio>
#include <map>
#include <memory>
#include <sstream>

using Truth = test::Known_form<double>;

const double tolerance = 1e-9;
const int most_fitted_again = 200;

struct Job
{
  explicit Job(const std::string& line)
  {
    std::istringstream in(line);
    in >> kind;
    if (kind == "mesh") in >> mesh >> d >> size;
    else in >> d >> dprime >> size;
    if (!in) throw std::runtime_error("not a job: " + line);
    if (kind == "mesh") dprime = d;
  }

  std::string kind, mesh;
  int d = 0, dprime = 0, size = 0; // size: rings or points
};

Truth known(const std::vector<double>& numbers, int order)
{
  Truth form(order);
  const auto vec = [&](std::size_t i) { return test::Point(numbers.at(i), numbers.at(i + 1), numbers.at(i + 2)); };
  form.axes = {vec(0), vec(3), vec(6)};
  if (order < 2) return form;
  form.derivative(2, 0) = numbers.at(9);
  form.derivative(0, 2) = numbers.at(10);
  for (int k = 3; k <= order; ++k)
    for (int j = 0; j <= k; ++j) form.derivative(k - j, j) = numbers.at(9 + test::index_of(k - j, j) - 4);
  return form;
}

// The samples of the forms of a job, by their number.
class Samples_of_job
{
public:
  Samples_of_job(const Job& job, Meshes& meshes)
  {
    if (job.kind == "fit") {
      m_sets = neighborhoods(std::size_t(job.size));
    } else {
      m_mesh = &meshes(job.mesh);
      m_gather = std::make_unique<CGAL::Jet_fitting::Vertex_gatherer<Mesh>>(*m_mesh);
      m_rings = job.size;
    }
  }

  std::vector<test::Point> operator()(std::size_t number)
  {
    std::vector<test::Point> points;
    const auto add = [&points](const Kernel::Point_3& p) { points.emplace_back(p.x(), p.y(), p.z()); };
    if (m_mesh == nullptr) {
      for (const auto& p : m_sets.at(number)) add(p);
    } else {
      std::vector<Vertex> around;
      (*m_gather)(CGAL::Jet_fitting::k_rings(m_rings), Vertex(Mesh::size_type(number)), around);
      for (const Vertex v : around) add(m_mesh->point(v));
    }
    return points;
  }

private:
  std::vector<Samples> m_sets;
  const Mesh* m_mesh = nullptr;
  std::unique_ptr<CGAL::Jet_fitting::Vertex_gatherer<Mesh>> m_gather;
  int m_rings = 0;
};

double difference(const Truth& a, const Truth& b, int order)
{
  const test::Errors e = test::errors(a, b);
  return e.absolute[std::size_t(order)] / std::max(e.size[std::size_t(order)], std::pow(e.size[2], order - 1));
}

struct Pair
{
  std::size_t number; // within the job
  Truth ours, theirs;
};

void report(const std::string& name, const Job& job, const std::vector<Pair>& pairs, std::size_t empty, Meshes& meshes)
{
  Samples_of_job samples(job, meshes);
  std::map<std::size_t, Truth> fitted_again;
  const auto truth = [&](std::size_t number) -> const Truth& {
    const auto found = fitted_again.find(number);
    if (found != fitted_again.end()) return found->second;
    const auto wide = test::reference_fit<test::Wide>(samples(number), job.d, job.dprime).form;
    Truth form(job.dprime);
    form.axes = {test::Point(wide.axes.x), test::Point(wide.axes.y), test::Point(wide.axes.z)};
    for (std::size_t i = 0; i < form.g.size(); ++i) form.g[i] = static_cast<double>(wide.g[i]);
    return fitted_again.emplace(number, form).first->second;
  };

  for (int order = 2; order <= std::min(job.dprime, 4); ++order) {
    std::vector<std::pair<double, const Pair*>> differences;
    for (const Pair& pair : pairs) differences.emplace_back(difference(pair.ours, pair.theirs, order), &pair);
    std::sort(differences.begin(), differences.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    const auto quantile = [&](double q) { return differences[std::size_t(q * double(differences.size() - 1))].first; };
    int above = 0, again = 0, ours_worse = 0;
    double our_error = 0, their_error = 0;
    for (const auto& [d, pair] : differences) {
      if (d <= tolerance) break;
      ++above;
      if (++again > most_fitted_again) continue;
      const double ours = difference(pair->ours, truth(pair->number), order);
      const double theirs = difference(pair->theirs, truth(pair->number), order);
      our_error = std::max(our_error, ours);
      their_error = std::max(their_error, theirs);
      ours_worse += ours > theirs + tolerance;
    }
    std::printf("| %s | %c | %zu | %zu | %.1e | %.1e | %.1e | %d |", name.c_str(), "kbc"[order - 2], pairs.size(),
                empty, quantile(0.5), quantile(0.01), quantile(0), above);
    if (above > 0) std::printf(" %.1e | %.1e | %d |\n", our_error, their_error, ours_worse);
    else std::printf(" | | |\n");
  }
}

int main(int argc, char** argv)
{
  if (argc < 3) {
    std::fprintf(stderr, "usage: compare_answers <ours> <CGAL's> [folder of CGAL's data]\n");
    return 2;
  }
  Answers_reader read_ours(argv[1]), read_theirs(argv[2]);
  Meshes meshes(argc > 3 ? argv[3] : CGAL::data_file_path(""));
  std::printf(
      "| job | order | forms | only one side has | median | 99 %% | largest difference | above 1e-9 | error of ours "
      "there | of CGAL's | ours is worse |\n|---|---|---|---|---|---|---|---|---|---|---|\n");

  std::string job, our_job, their_job;
  std::vector<double> ours, theirs;
  std::vector<Pair> pairs;
  std::size_t number = 0, empty = 0;
  while (true) {
    const bool more = read_ours(our_job, ours);
    if (more != read_theirs(their_job, theirs) || (more && our_job != their_job))
      throw std::runtime_error("the files are of different jobs: " + our_job + ", " + their_job);
    if (!job.empty() && (!more || our_job != job)) {
      report(job, Job(job), pairs, empty, meshes);
      pairs.clear();
      number = empty = 0;
    }
    if (!more) return 0;
    job = our_job;
    const int order = Job(job).dprime;
    if (ours.empty() != theirs.empty()) ++empty;
    else if (!ours.empty()) pairs.push_back({number, known(ours, order), known(theirs, order)});
    ++number;
  }
}
