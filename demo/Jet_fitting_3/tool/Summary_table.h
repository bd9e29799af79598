// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_SUMMARY_TABLE_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_SUMMARY_TABLE_H

#include "Arguments.h"
#include "Lines.h"
#include "Picture.h"
#include "Quantities.h"
#include "Surface.h"
#include "describe.h"
#include "Estimates.h"
#include "extension.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace tool {

// What a status means for the user, and what can be done.
inline const char* advice(CGAL::Jet_fitting::Status_flag flag)
{
  using Flag = CGAL::Jet_fitting::Status_flag;
  switch (flag) {
  case Flag::isolated: return "no neighbor: left out";
  case Flag::not_finite: return "infinite or undefined coordinates: left out";
  case Flag::too_few_points: return "too few neighbors for the degree: more of them (-a, -p, -r), or --lower-degree";
  case Flag::rank_deficient: return "neighbors coincide, or lie on a curve: more of them (-a, -p, -r), or a smaller -d";
  case Flag::degree_lowered: return "too few neighbors for the degree: fitted with a lower one";
  case Flag::one_sided: return "neighbors mostly on one side, as at a border: errors are larger there";
  case Flag::near_umbilic: return "d1 and d2 mean little: flat or round places, or errors as large as curvatures";
  case Flag::pca_ambiguous:
    return "neighbors far from a plane: sharp edges (of meshes: --sharp-angle auto), or too many neighbors";
  case Flag::few_points_for_robust_loss: return "too few neighbors to tell outliers: more of them (-a, -p, -r)";
  case Flag::outlier: return "far from the surface of their neighbors: left out";
  default: return "";
  }
}

// What was done, how long it took, and what came out, for the reader at a terminal.
class Summary_table
{
public:
  explicit Summary_table(std::ostream& out) : m_out(out) {}

  void add_surface(const std::string& file, const Mesh& mesh)
  {
    m_out << file << ": " << mesh.number_of_vertices();
    std::size_t border_edges = 0;
    for (Mesh::Edge_index e : mesh.edges()) border_edges += mesh.is_border(e);
    if (is_point_set(mesh)) m_out << " points";
    else m_out << " vertices, " << mesh.number_of_faces() << " faces, ";
    if (!is_point_set(mesh) && border_edges > 0) m_out << border_edges << " border edges";
    else if (!is_point_set(mesh)) m_out << "closed";
    double low[3], high[3];
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::numeric_limits<double>::infinity();
      high[i] = -low[i];
      for (const Point& p : mesh.points()) {
        const double x = p[static_cast<int>(i)];
        if (x < low[i]) low[i] = x; // not for NaN
        if (x > high[i]) high[i] = x;
      }
    }
    print("\nsize %.4g x %.4g x %.4g", high[0] - low[0], high[1] - low[1], high[2] - low[2]);
    if (!is_point_set(mesh)) print(", mean edge %.4g", mean_edge_length(mesh));
    m_out << ", in the unit of length of the file, as below\n";
  }

  void add_sharp_edges(std::size_t edges, double angle, std::size_t added)
  {
    print("%zu sharp edges, of more than %g degrees; %zu vertices were added for the other sides of vertices there\n",
          edges, angle, added);
  }

  void add_remark(const std::string& remark) { m_out << "note: " << remark << '\n'; }

  void add_fits(const Estimates& estimates, const Arguments& a)
  {
    const std::size_t estimated = estimates.count(CGAL::Jet_fitting::Status_flag::estimated);
    m_out << fits_in_words(a);
    if (a.options.report_quality && !a.is_automatic && estimated > 0) {
      double points = 0;
      for (const float n : estimates.numbers_of_points) points += std::isfinite(n) ? double(n) : 0.;
      print(" (%.1f on average)", points / double(estimated));
    }
    m_out << ", Monge forms of degree " << a.degree_monge << ": " << estimated << " estimated, "
          << estimates.size() - estimated << " left out\n";
    if (a.is_automatic) {
      add_noise(estimates.summary.noise, a.options.use_normals);
      add_degrees(estimates.summary);
    }
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
    m_out << "\nquantiles                  1 %         25 %         50 %         75 %         99 %   unit\n";
    for (const Quantity& q : quantities)
      for (const char* symbol : {"k1", "k2", "H", "K", "condition_number", "radius", "bias", "deviation"})
        if (q.name.symbol == symbol) add_quantiles_of(q, size);
    m_out << "(negative where the surface bulges towards its normal)\n";
  }

  void add_ridges(const Ridges_and_umbilics& found)
  {
    m_out << (found.lines.empty() ? "\nno ridges\n" : "\nridges                 lines       length\n");
    for (const Line_style& style : ridge_styles()) {
      std::size_t count = 0;
      double sum = 0;
      for (const Line& line : found.lines) {
        if (line.type != style.type) continue;
        ++count;
        sum += length(line);
      }
      if (count > 0) print("%-20s %7zu %12.5g\n", style.name, count, sum);
    }
    const auto count = [&found](CGAL::Jet_fitting::Umbilic_type type) {
      return std::count_if(found.umbilics.begin(), found.umbilics.end(),
                           [type](const auto& umbilic) { return umbilic.type == type; });
    };
    using CGAL::Jet_fitting::Umbilic_type;
    if (found.umbilics.empty()) m_out << "no umbilics\n";
    else
      m_out << found.umbilics.size() << " umbilics: " << count(Umbilic_type::lemon) << " lemons, "
            << count(Umbilic_type::monstar) << " monstars, " << count(Umbilic_type::star) << " stars, "
            << count(Umbilic_type::non_generic) << " of no generic type\n";
  }

  void add_files(const std::vector<std::string>& names)
  {
    m_out << '\n';
    for (const std::string& name : names) m_out << "written: " << name << what_opens(extension(name)) << '\n';
  }

private:
  static const char* what_opens(const std::string& format)
  {
    if (format == "ply") return " (opens colored in MeshLab, CloudCompare, Blender, ParaView)";
    if (format == "vtp") return " (opens colored in ParaView)";
    if (format == "csv") return " (a spreadsheet)";
    return "";
  }

  template <class... Values>
  void print(const char* format, Values... values)
  {
    char buffer[160];
    std::snprintf(buffer, sizeof buffer, format, values...);
    m_out << buffer;
  }

  void add_noise(const CGAL::Jet_fitting::Noise& noise, bool of_normals)
  {
    m_out << "noise of points, along the normal: ";
    add_with_error(noise.position, noise.position_error);
    if (of_normals) {
      m_out << "; of normals, in radians: ";
      add_with_error(noise.normal, noise.normal_error);
      if (noise.wrong_normals > 0) m_out << "; " << noise.wrong_normals << " are taken for wrong, and left out";
    }
    m_out << '\n';
  }

  void add_with_error(double noise, double error)
  {
    if (error < noise) print("%.4g +- %.2g", noise, error);
    else print("at most %.2g, which the shape itself may be", noise); // as of points without any
  }

  void add_degrees(const Summary& summary)
  {
    m_out << "chosen degrees:";
    const char* separator = " ";
    for (std::size_t degree = 1; degree <= 8; ++degree)
      if (const std::size_t count = summary.count_of_degree(degree); count > 0) {
        m_out << separator << degree << " for " << count;
        separator = ", ";
      }
    m_out << '\n';
  }

  void add_flags(const Estimates& estimates)
  {
    for (const auto flag : all_flags) {
      const std::size_t count = estimates.count(flag);
      if (count > 0 && flag != CGAL::Jet_fitting::Status_flag::estimated)
        m_out << "  " << count << " of " << estimates.size() << " " << CGAL::Jet_fitting::Estimation_status(flag)
              << " (status " << CGAL::Jet_fitting::Estimation_status(flag).to_integer() << "): " << advice(flag)
              << '\n';
    }
  }

  void add_quantiles_of(const Quantity& q, std::size_t size)
  {
    std::vector<double> values;
    for (std::size_t v = 0; v < size; ++v)
      if (const double x = q.value(v, 0); std::isfinite(x)) values.push_back(x);
    if (values.empty()) return;
    print("%-16s", q.name.symbol.c_str());
    for (const double fraction : {0.01, 0.25, 0.5, 0.75, 0.99}) {
      const auto nth = values.begin() + std::ptrdiff_t(fraction * double(values.size() - 1) + 0.5);
      std::nth_element(values.begin(), nth, values.end());
      print(" %11.5g", *nth);
    }
    m_out << "   " << q.name.unit() << '\n';
  }

  std::ostream& m_out;
  bool m_has_phases = false;
};

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_SUMMARY_TABLE_H
