// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How many times faster two threads of estimate_vertex_monge_forms() are than one.
//
// A machine may give a program more or less of its processors from one second to the next, a virtual machine's host most
// of all, and more of one than of the other. So each run of two threads stands between two of one thread, one on each
// processor, and after each such turn the same is done with jobs that share nothing. What those gain is what there is to
// gain: where it is not two, the machine is measured, not the program.
// usage: mesh_throughput_two_threads [options of Google Benchmark]

#include "mesh_job.h"

#include <CGAL/estimate_vertex_monge_forms.h>

#include <tbb/global_control.h>

#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>

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

struct Turn
{
  double two;  // the time with two threads
  double gain; // the time of one over it, one having the mean of its speeds on two processors
};

// \param with_one, with_two return how long they took
template <class With_one, class With_two>
Turn turn(const Processors& processors, const With_one& with_one, const With_two& with_two)
{
  const double first = processors.on(0, with_one), two = with_two(), second = processors.on(1, with_one);
  return {two, 2 / (1 / first + 1 / second) / two};
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

// Two jobs that share nothing.
class Jobs_apart
{
public:
  double one_after_the_other(const Fit_of_rings& fit)
  {
    return seconds([&] {
      m_first.run(fit);
      m_second.run(fit);
    });
  }

  double at_the_same_time(const Fit_of_rings& fit)
  {
    return seconds([&] {
      std::thread other([&] { m_second.run(fit); });
      m_first.run(fit);
      other.join();
    });
  }

private:
  Small_job m_first, m_second;
};

// Each iteration is a turn. Counters, medians of the turns: `gain` of two threads, `gain_apart` of the jobs that share
// nothing, and the rate of two threads.
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
    return time;
  };
  const auto with_one = [&] { return with_threads(1); };
  const auto with_two = [&] { return with_threads(2); };
  Jobs_apart apart;
  const auto one_after_the_other = [&] { return apart.one_after_the_other(fit); };
  const auto at_the_same_time = [&] { return apart.at_the_same_time(fit); };

  with_two(); // the first call also waits for memory and for the threads' start
  at_the_same_time();
  std::vector<double> time, gain, gain_apart;
  for (auto _ : state) {
    const Turn whole = turn(processors, with_one, with_two);
    time.push_back(whole.two);
    gain.push_back(whole.gain);
    gain_apart.push_back(turn(processors, one_after_the_other, at_the_same_time).gain);
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
      })->Iterations(size > 100000 ? 9 : 15);
    }
  benchmark::RunSpecifiedBenchmarks();
}
