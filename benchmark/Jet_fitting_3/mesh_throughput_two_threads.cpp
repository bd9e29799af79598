// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How many times faster two threads of estimate_vertex_monge_forms() are than one.
//
// A machine may give a program more or less of its processors from one second to the next, a virtual machine's host
// most of all, and more of one than of the other. So each run of two threads stands between two of one thread, one on
// each processor, and so do, in turn with them, jobs that share nothing and are as much work. What those gain is what
// there is to gain: where it is not two, the machine is measured, not the program.
// usage: mesh_throughput_two_threads [options of Google Benchmark]

#include "mesh_job.h"

#include <CGAL/estimate_vertex_monge_forms.h>

#include <tbb/global_control.h>

#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>

#include <malloc.h>
#include <sched.h>

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

// The processors that this thread may run on.
class Processors
{
public:
  Processors()
  {
    check(sched_getaffinity(0, sizeof(m_all), &m_all));
    if (CPU_COUNT(&m_all) < 2) throw std::runtime_error("two threads need two processors");
  }

  // The result of job(), run on processor i of them.
  template <class Job>
  double on(int i, const Job& job) const
  {
    int processor = 0;
    while (!CPU_ISSET(processor, &m_all) || i-- > 0) ++processor;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(processor, &one);
    check(sched_setaffinity(0, sizeof(one), &one));
    const double result = job();
    check(sched_setaffinity(0, sizeof(m_all), &m_all));
    return result;
  }

private:
  static void check(int failed)
  {
    if (failed) throw std::system_error(errno, std::generic_category(), "the processors of a thread");
  }

  cpu_set_t m_all;
};

// Times with one thread on each of two processors, and with two threads.
struct Times
{
  double first, two, second;

  // One thread's time over that of two, one thread having the mean of its speeds on the two processors.
  double gain() const { return 2 / (1 / first + 1 / second) / two; }
};

// Jobs as large as a mesh of that many vertices, half of it each, that share nothing: meshes that stay in the cache of
// a processor, over and over again.
class Jobs_apart
{
public:
  Jobs_apart(std::size_t vertices, const Fit_of_rings& fit)
    : m_repeats(vertices / m_first.mesh.number_of_vertices() / 2), m_fit(fit)
  {}

  double one_after_the_other()
  {
    return seconds([&] {
      run(m_first);
      run(m_second);
    });
  }

  double at_the_same_time()
  {
    return seconds([&] {
      std::thread other([&] { run(m_second); });
      run(m_first);
      other.join();
    });
  }

private:
  struct Small
  {
    Mesh mesh = torus_mesh(2000);
    Forms forms = mesh.add_property_map<Vertex, Form>("v:form").first;
  };

  void run(Small& small) const
  {
    for (std::size_t repeat = 0; repeat < m_repeats; ++repeat) {
      estimate<CGAL::Sequential_tag>(small.mesh, m_fit, small.forms);
      clear(small.mesh, small.forms);
    }
  }

  Small m_first, m_second;
  std::size_t m_repeats;
  Fit_of_rings m_fit;
};

// Each iteration is a turn. Counters, medians of the turns: `gain` of two threads, `gain_apart` of the jobs that share
// nothing, `gain_over_apart`, and the rate of two threads.
void two_threads_beside_one(benchmark::State& state, Mesh& mesh, const Fit_of_rings& fit)
{
  const Processors processors;
  Forms forms = mesh.add_property_map<Vertex, Form>("v:form").first;
  double sum = 0;
  const auto with_threads = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const double time = seconds([&] { estimate<CGAL::Parallel_tag>(mesh, fit, forms); });
    sum = checksum(mesh, forms);
    clear(mesh, forms);
    malloc_trim(0); // else the next call would put the freed memory in order, and two threads that of one
    return time;
  };
  const auto with_one = [&] { return with_threads(1); };
  const auto with_two = [&] { return with_threads(2); };
  Jobs_apart jobs(mesh.number_of_vertices(), fit);
  const auto one_after_the_other = [&] { return jobs.one_after_the_other(); };

  with_two(); // the first call also waits for the threads' start
  std::vector<double> time, gain, gain_apart, gain_over_apart;
  for (auto _ : state) {
    Times whole, apart;
    whole.first = processors.on(0, with_one);
    apart.first = processors.on(0, one_after_the_other);
    whole.two = with_two();
    apart.two = jobs.at_the_same_time();
    whole.second = processors.on(1, with_one);
    apart.second = processors.on(1, one_after_the_other);
    time.push_back(whole.two);
    gain.push_back(whole.gain());
    gain_apart.push_back(apart.gain());
    gain_over_apart.push_back(whole.gain() / apart.gain());
  }
  mesh.remove_property_map(forms);
  report(state, mesh, sum);
  state.counters["vertices_per_second"] = double(mesh.number_of_vertices()) / median(time);
  state.counters["gain"] = median(gain);
  state.counters["gain_apart"] = median(gain_apart);
  state.counters["gain_over_apart"] = median(gain_over_apart);
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
