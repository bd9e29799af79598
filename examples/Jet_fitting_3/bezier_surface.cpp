// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes the surface of section 5.3.1 of the paper, the graph of h(u, v) over the unit square, as an OFF mesh.

#include <array>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

double horner(const std::array<double, 5>& coefficients, double t)
{
  double value = 0;
  for (std::size_t i = coefficients.size(); i-- > 0;) value = value * t + coefficients[i];
  return value;
}

// Row i is the coefficient of u^i, as a polynomial in v.
double height(double u, double v)
{
  static constexpr std::array<std::array<double, 5>, 5> h = {{{0, 0, 0, 0, 0},
                                                              {0, 16, -72, 112, -56},
                                                              {0, -72, 324, -504, 252},
                                                              {0, 80, -360, 592, -312},
                                                              {0, -24, 108, -200, 116}}};
  std::array<double, 5> in_u;
  for (std::size_t i = 0; i < in_u.size(); ++i) in_u[i] = horner(h[i], v);
  return horner(in_u, u);
}

int main(int argc, char* argv[])
{
  const std::string file = argc > 1 ? argv[1] : "bezier_surface.off";
  const int side = argc > 2 ? std::atoi(argv[2]) : 257; // 257 * 257 = 66049 vertices, as in the paper
  if (side < 2) {
    std::cerr << "Usage: " << argv[0] << " [file.off [vertices along a side, at least 2]]\n";
    return EXIT_FAILURE;
  }

  std::ofstream out(file);
  out.precision(17);
  out << "OFF\n" << side * side << ' ' << 2 * (side - 1) * (side - 1) << " 0\n";
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const double u = double(i) / (side - 1), v = double(j) / (side - 1);
      out << u << ' ' << v << ' ' << height(u, v) << '\n';
    }
  for (int i = 0; i + 1 < side; ++i)
    for (int j = 0; j + 1 < side; ++j) {
      const int a = i * side + j, b = a + side, c = b + 1, d = a + 1;
      out << "3 " << a << ' ' << b << ' ' << c << "\n3 " << a << ' ' << c << ' ' << d << '\n';
    }
  if (!out.flush()) {
    std::cerr << "cannot write " << file << '\n';
    return EXIT_FAILURE;
  }
}
