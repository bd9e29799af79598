// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How many times faster two threads of estimate_vertex_monge_forms() are than one.
//
// A machine may give a program more or less of its two processors from one second to the next, a virtual machine's host
// most of all. So one and two threads take turns, and after each turn the same is done with jobs that share nothing. What
// those gain is what there is to gain: where it is not two, the machine is measured, not the program.
// usage: mesh_throughput_two_threads [options of Google Benchmark]

#include "mesh_job.h"

#include <CGAL/estimate_vertex_monge_forms.h>

#include <tbb/global_control.h>

#include <chrono>
#include <thread>

template <class ConcurrencyTag>
void estimate(Mesh& mesh, const Fit_of_rings& fit, Forms& forms)
{
  CGAL::estimate_vertex_monge_forms<ConcurrencyTag>(mesh, CGAL::Jet_fitting::k_rings(fit.rings), forms,
                                                    CGAL::parameters::degree_fitting(fit.d).degree_monge(fit.d));
}

template <class Job>
double seconds(const Job& job)
{
  const auto start = std::chrono::steady_clock::now();
  job();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values)
{
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// A mesh that stays in the cache of a processor.
class Small_job
{
public:
  void run(const Fit_of_rings& fit)
  {
    for (int repeat = 0; repeat < 10; ++repeat) {
      estimate<CGAL::Sequential_tag>(m_mesh, fit, m_forms);
      clear(m_mesh, m_forms);
    }
  }

private:
  Mesh m_mesh = torus_mesh(2000);
  Forms m_forms = m_mesh.add_property_map<Vertex, Form>("v:form").first;
};

// One thread's time over that of two, for jobs that share nothing.
class Jobs_apart
{
public:
  double gain(const Fit_of_rings& fit)
  {
    const auto run_first = [&] { m_first.run(fit); };
    const auto run_second = [&] { m_second.run(fit); };
    const double one_after_the_other = seconds(run_first) + seconds(run_second);
    return one_after_the_other / seconds([&] {
             std::thread other(run_second);
             run_first();
             other.join();
           });
  }

private:
  Small_job m_first, m_second;
};

// Each iteration is a turn. Counters, medians of the turns: `gain`, one thread's time over two threads'; `gain_apart`, that
// of the jobs that share nothing; and the rate of two threads.
void two_threads_beside_one(benchmark::State& state, Mesh& mesh, const Fit_of_rings& fit)
{
  Forms forms = mesh.add_property_map<Vertex, Form>("v:form").first;
  double sum = 0;
  const auto time_of_threads = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const double time = seconds([&] { estimate<CGAL::Parallel_tag>(mesh, fit, forms); });
    sum = checksum(mesh, forms);
    clear(mesh, forms);
    return time;
  };

  time_of_threads(2); // the first call also waits for memory and for the threads' start
  Jobs_apart apart;
  apart.gain(fit);
  std::vector<double> time, gain, gain_apart;
  for (auto _ : state) {
    const double one = time_of_threads(1);
    time.push_back(time_of_threads(2));
    gain.push_back(one / time.back());
    gain_apart.push_back(apart.gain(fit));
  }
  mesh.remove_property_map(forms);
  report(state, mesh, sum);
  state.counters["vertices_per_second"] = double(mesh.number_of_vertices()) / median(time);
  state.counters["gain"] = median(gain);
  state.counters["gain_apart"] = median(gain_apart);
}

int main(int argc, char** argv)
{
  Meshes meshes(""); // none is read from a file
  benchmark::Initialize(&argc, argv);
  for (const int size : {100000, 1000000})
    for (const Fit_of_rings& fit : fits_of_rings) {
      const std::string mesh = "torus_" + std::to_string(size);
      add_mesh_benchmark("two_threads", mesh, fit, [&meshes, mesh, fit](benchmark::State& state) {
        two_threads_beside_one(state, meshes(mesh), fit);
      })->Iterations(size > 100000 ? 5 : 15);
    }
  benchmark::RunSpecifiedBenchmarks();
}
