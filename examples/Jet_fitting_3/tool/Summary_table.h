// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXAMPLES_JET_FITTING_3_TOOL_SUMMARY_TABLE_H
#define CGAL_EXAMPLES_JET_FITTING_3_TOOL_SUMMARY_TABLE_H

#include "Arguments.h"
#include "Lines.h"
#include "Picture.h"
#include "Quantities.h"
#include "Surface.h"
#include "estimate.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace tool {

// What was done, how long it took, and what came out, for the reader at a terminal.
class Summary_table
{
public:
  explicit Summary_table(std::ostream& out) : m_out(out) {}

  void add_surface(const std::string& file, const Mesh& mesh)
  {
    m_out << file << ": " << mesh.number_of_vertices();
    if (is_point_set(mesh)) {
      m_out << " points\n";
      return;
    }
    std::size_t border_edges = 0;
    for (Mesh::Edge_index e : mesh.edges()) border_edges += mesh.is_border(e);
    m_out << " vertices, " << mesh.number_of_faces() << " faces, " << border_edges << " border edges\n";
  }

  void add_fits(const Estimates& estimates, const Arguments& a)
  {
    const std::size_t estimated = estimates.count(CGAL::Jet_fitting::Status_flag::estimated);
    m_out << "jets of degree " << a.degree_jet << ", Monge forms of degree " << a.degree_monge << ": " << estimated
          << " estimated, " << estimates.size() - estimated << " skipped";
    if (a.options.report_quality && estimated > 0) {
      double points = 0;
      for (const float n : estimates.numbers_of_points) points += std::isfinite(n) ? double(n) : 0.;
      print(", %.1f points each on average", points / double(estimated));
    }
    m_out << '\n';
    add_flags(estimates);
  }

  void add_phase(const std::string& name, double seconds, std::size_t vertices)
  {
    if (!m_has_phases) m_out << "\nphase            seconds   vertices/s\n";
    m_has_phases = true;
    print("%-14s %9.3f %12.0f\n", name.c_str(), seconds, seconds > 0 ? double(vertices) / seconds : 0.);
  }

  void add_quantiles(const std::vector<Quantity>& quantities, std::size_t size)
  {
    m_out << "\nquantiles                  1 %         25 %         50 %         75 %         99 %\n";
    for (const Quantity& q : quantities)
      for (const char* name : {"k1", "k2", "H", "K", "condition_number"})
        if (q.name == name) add_quantiles_of(q, size);
  }

  void add_ridges(const Ridges_and_umbilics& found)
  {
    m_out << "\nridges           lines       length\n";
    for (const Line_style& style : ridge_styles()) {
      std::size_t count = 0;
      double sum = 0;
      for (const Line& line : found.lines) {
        if (line.type != style.type) continue;
        ++count;
        sum += length(line);
      }
      if (count > 0) print("%-14s %7zu %12.5g\n", style.name, count, sum);
    }
    const auto count = [&found](CGAL::Jet_fitting::Umbilic_type type) {
      return std::count_if(found.umbilics.begin(), found.umbilics.end(),
                           [type](const auto& umbilic) { return umbilic.type == type; });
    };
    using CGAL::Jet_fitting::Umbilic_type;
    m_out << found.umbilics.size() << " umbilics: " << count(Umbilic_type::lemon) << " lemons, "
          << count(Umbilic_type::monstar) << " monstars, " << count(Umbilic_type::star) << " stars, "
          << count(Umbilic_type::non_generic) << " of no generic type\n";
  }

  void add_files(const std::vector<std::string>& names)
  {
    m_out << "\nwritten:";
    for (const std::string& name : names) m_out << ' ' << name;
    m_out << '\n';
  }

private:
  template <class... Values>
  void print(const char* format, Values... values)
  {
    char buffer[160];
    std::snprintf(buffer, sizeof buffer, format, values...);
    m_out << buffer;
  }

  void add_flags(const Estimates& estimates)
  {
    using Flag = CGAL::Jet_fitting::Status_flag;
    for (const Flag flag :
         {Flag::isolated, Flag::not_finite, Flag::too_few_points, Flag::rank_deficient, Flag::degree_lowered,
          Flag::one_sided, Flag::near_umbilic, Flag::pca_ambiguous, Flag::few_points_for_robust_loss}) {
      const std::size_t count = estimates.count(flag);
      if (count > 0) m_out << "  " << CGAL::Jet_fitting::Estimation_status(flag) << ": " << count << '\n';
    }
  }

  void add_quantiles_of(const Quantity& q, std::size_t size)
  {
    std::vector<double> values;
    for (std::size_t v = 0; v < size; ++v)
      if (const double x = q.value(v, 0); std::isfinite(x)) values.push_back(x);
    if (values.empty()) return;
    print("%-16s", q.name.c_str());
    for (const double fraction : {0.01, 0.25, 0.5, 0.75, 0.99}) {
      const auto nth = values.begin() + std::ptrdiff_t(fraction * double(values.size() - 1) + 0.5);
      std::nth_element(values.begin(), nth, values.end());
      print(" %12.5g", *nth);
    }
    m_out << '\n';
  }

  std::ostream& m_out;
  bool m_has_phases = false;
};

} // namespace tool

#endif // CGAL_EXAMPLES_JET_FITTING_3_TOOL_SUMMARY_TABLE_H
