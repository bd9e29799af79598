// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_COLORS_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_COLORS_H

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

// From values to colors. White is 0, and the range is symmetric, or ends at 0 if it holds values of one sign; it is
// that of some of the values, and leaves out a percentage of these at either end, so that a few wild ones do not bleach
// the rest: they have the color of the end.
class Color_scale
{
public:
  Color_scale() = default;

  Color_scale(const std::vector<double>& values, std::vector<double> in_range, double percentile)
  {
    in_range.erase(std::remove_if(in_range.begin(), in_range.end(), [](double x) { return !std::isfinite(x); }),
                   in_range.end());
    if (in_range.empty()) return;
    const auto at = [&](double fraction) {
      const auto nth = in_range.begin() + std::ptrdiff_t(fraction * double(in_range.size() - 1));
      std::nth_element(in_range.begin(), nth, in_range.end());
      return *nth;
    };
    const double low = at(percentile / 100), high = at(1 - percentile / 100);
    m_limit = (std::max)(std::abs(low), std::abs(high));
    if (!(m_limit > 0)) m_limit = 1;
    const double least_shown = 0.02 * m_limit;
    m_low = low < -least_shown ? -m_limit : 0;
    m_high = high > least_shown || m_low == 0 ? m_limit : 0;
    m_is_clipped_below = std::any_of(values.begin(), values.end(), [this](double x) { return x < m_low; });
    m_is_clipped_above = std::any_of(values.begin(), values.end(), [this](double x) { return x > m_high; });
  }

  Color operator()(double value) const
  {
    return std::isfinite(value) ? diverging_color(std::clamp(value, m_low, m_high) / m_limit) : color_of_nothing;
  }

  double low() const { return m_low; }
  double high() const { return m_high; }
  // Whether values lie beyond.
  bool is_clipped_below() const { return m_is_clipped_below; }
  bool is_clipped_above() const { return m_is_clipped_above; }

private:
  double m_limit = 1, m_low = -1, m_high = 1;
  bool m_is_clipped_below = false, m_is_clipped_above = false;
};

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_COLORS_H
