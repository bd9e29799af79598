// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_LEGEND_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_LEGEND_H

#include "Colors.h"
#include "Scene.h"

#include <cmath>
#include <cstdio>
#include <string>

namespace tool {

// A number of one, two or five times a power of ten, such that the range holds three to six of its multiples.
inline double tick_distance(double range)
{
  const double power = std::pow(10., std::floor(std::log10(range / 3)));
  for (const double factor : {5., 2.})
    if (range / (factor * power) >= 2.5) return factor * power;
  return power;
}

inline std::string short_number(double x)
{
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.4g", x);
  return buffer;
}

// A column at the right of the picture, filled from the top.
class Legend
{
public:
  static constexpr double column = 0.62; // with what it keeps free

  Legend(Scene& scene, double right) : m_scene(scene), m_left(right - column + 0.06), m_right(right - 0.03) {}

  void add_text(const std::string& words, double size = letters)
  {
    m_top -= 1.45 * size;
    m_scene.add_text(words, m_left, m_top, size, m_right - m_left);
  }

  // Colors with ticks, and a triangle at an end beyond which there are values.
  void add_scale(const Color_scale& scale)
  {
    const double low = scale.low(), high = scale.high(), height = 1.05, tip = 0.06;
    const double top = m_top - 0.1 - tip, bottom = top - height, right = m_left + bar;
    const auto height_of = [&](double value) { return bottom + height * (value - low) / (high - low); };
    const int steps = 128;
    for (int i = 0; i < steps; ++i)
      m_scene.add_box(m_left, bottom + height * i / steps, right, bottom + height * (i + 1) / steps,
                      scale(low + (high - low) * (i + 0.5) / steps));
    if (scale.is_clipped_above())
      m_scene.add_triangle({{m_left, top}}, {{right, top}}, {{m_left + bar / 2, top + tip}}, scale(high));
    if (scale.is_clipped_below())
      m_scene.add_triangle({{m_left, bottom}}, {{right, bottom}}, {{m_left + bar / 2, bottom - tip}}, scale(low));
    const double distance = tick_distance(high - low);
    for (double n = std::ceil(low / distance - 1e-9); n <= high / distance + 1e-9; ++n) {
      const double y = height_of(n * distance);
      m_scene.add_box(right, y - 0.003, right + 0.02, y + 0.003, {{40, 40, 40}});
      m_scene.add_text(short_number(n * distance + 0.), right + 0.04, y - letters / 3, letters, m_right - right - 0.04);
    }
    m_top = bottom - tip - 0.03;
  }

  void add_line(const std::string& words, const Color& color)
  {
    m_top -= 0.1;
    m_scene.add_box(m_left, m_top + letters / 4, m_left + bar, m_top + letters / 2, color);
    add_beside(words);
  }

  void add_dot(const std::string& words, const Color& color)
  {
    m_top -= 0.1;
    m_scene.add_box(m_left + bar / 4, m_top + letters / 8, m_left + bar * 3 / 4, m_top + letters / 8 + bar / 2, color);
    add_beside(words);
  }

private:
  static constexpr double bar = 0.07, letters = 0.068;

  void add_beside(const std::string& words)
  {
    m_scene.add_text(words, m_left + bar + 0.03, m_top, 0.7 * letters, m_right - m_left - bar - 0.03);
  }

  Scene& m_scene;
  double m_left, m_right, m_top = 0.92;
};

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_LEGEND_H
