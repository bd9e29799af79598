// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_BENCHMARK_JET_FITTING_3_ANSWERS_H
#define CGAL_BENCHMARK_JET_FITTING_3_ANSWERS_H

#include <cstddef>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

// What a program has computed, in a file, for compare_answers: a record for each form, which is the line of its job
// ("fit <d> <d'> <points>" or "mesh <name> <d> <rings>"), the number of doubles that follow, and these: d1, d2, n and
// the coefficients; none for a form that is empty.
class Answers_writer
{
public:
  explicit Answers_writer(const std::string& path) : m_out(path, std::ios::binary)
  {
    if (!m_out) throw std::runtime_error("cannot write " + path);
  }

  template <class Form>
  void operator()(const std::string& job, const Form& form)
  {
    const auto& coefficients = form.coefficients(); // CGAL's returns a copy
    std::vector<double> numbers;
    if (!coefficients.empty()) {
      for (const auto& v :
           {form.maximal_principal_direction(), form.minimal_principal_direction(), form.normal_direction()})
        for (const double x : {v.x(), v.y(), v.z()}) numbers.push_back(x);
      numbers.insert(numbers.end(), coefficients.begin(), coefficients.end());
    }
    const std::size_t size = numbers.size();
    m_out << job << '\n';
    m_out.write(reinterpret_cast<const char*>(&size), sizeof(size));
    m_out.write(reinterpret_cast<const char*>(numbers.data()), std::streamsize(size * sizeof(double)));
  }

private:
  std::ofstream m_out;
};

class Answers_reader
{
public:
  explicit Answers_reader(const std::string& path) : m_in(path, std::ios::binary)
  {
    if (!m_in) throw std::runtime_error("cannot read " + path);
  }

  // False at the end.
  bool operator()(std::string& job, std::vector<double>& numbers)
  {
    std::size_t size = 0;
    if (!std::getline(m_in, job)) return false;
    m_in.read(reinterpret_cast<char*>(&size), sizeof(size));
    numbers.resize(size);
    m_in.read(reinterpret_cast<char*>(numbers.data()), std::streamsize(size * sizeof(double)));
    if (!m_in) throw std::runtime_error("a file of answers is cut short");
    return true;
  }

private:
  std::ifstream m_in;
};

// The file of an option --answers=<file>: answers are written there and nothing is timed. Empty if there is none.
inline std::string answers_path(int argc, char** argv)
{
  const std::string option = "--answers=";
  for (int i = 1; i < argc; ++i)
    if (std::string(argv[i]).compare(0, option.size(), option) == 0) return argv[i] + option.size();
  return {};
}

#endif // CGAL_BENCHMARK_JET_FITTING_3_ANSWERS_H
