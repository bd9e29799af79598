// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXAMPLES_JET_FITTING_3_TOOL_COLORS_H
#define CGAL_EXAMPLES_JET_FITTING_3_TOOL_COLORS_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace tool {

using Color = std::array<std::uint8_t, 3>;

inline constexpr Color color_of_nothing = {{128, 128, 128}};

inline Color mix(const Color& a, const Color& b, double t)
{
  Color c;
  for (std::size_t i = 0; i < 3; ++i) c[i] = static_cast<std::uint8_t>(std::lround(a[i] + t * (b[i] - a[i])));
  return c;
}

// Blue, white, red for t = -1, 0, 1: the sign is seen at once, and by the color-blind too.
inline Color diverging_color(double t)
{
  static constexpr Color colors[] = {
      {{24, 54, 122}}, {{70, 130, 190}}, {{240, 238, 232}}, {{222, 112, 72}}, {{140, 20, 34}}};
  const double position = 2 * (std::clamp(t, -1., 1.) + 1);
  const std::size_t below = (std::min)(static_cast<std::size_t>(position), std::size_t(3));
  return mix(colors[below], colors[below + 1], position - static_cast<double>(below));
}

// From values to colors. White is 0; the range is symmetric, and holds all but a percentage of the values at either end,
// so that a few wild ones do not bleach the rest. Values of one sign use half of the colors.
class Color_scale
{
public:
  Color_scale() = default;

  Color_scale(std::vector<double> values, double percentile)
  {
    values.erase(std::remove_if(values.begin(), values.end(), [](double x) { return !std::isfinite(x); }),
                 values.end());
    if (values.empty()) return;
    const auto at = [&](double fraction) {
      const auto nth = values.begin() + std::ptrdiff_t(fraction * double(values.size() - 1));
      std::nth_element(values.begin(), nth, values.end());
      return *nth;
    };
    const double low = at(percentile / 100), high = at(1 - percentile / 100);
    m_limit = (std::max)(std::abs(low), std::abs(high));
    m_has_negative = low < 0;
    m_has_positive = high > 0;
    if (!(m_limit > 0)) m_limit = 1;
  }

  Color operator()(double value) const
  {
    return std::isfinite(value) ? diverging_color(value / m_limit) : color_of_nothing;
  }

  double low() const { return m_has_negative ? -m_limit : 0; }
  double high() const { return m_has_positive || !m_has_negative ? m_limit : 0; }

private:
  double m_limit = 1;
  bool m_has_negative = true, m_has_positive = true;
};

} // namespace tool

#endif // CGAL_EXAMPLES_JET_FITTING_3_TOOL_COLORS_H
