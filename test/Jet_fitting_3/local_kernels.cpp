// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The local kernel's number type does all the arithmetic, from float to 50 digits.

#include "counting_svd.h"
#include "kernels.h"

#include <limits>
#include <type_traits>

using namespace test;

using Float_50 = mp::cpp_bin_float_50;

// CGAL 6, and any CGAL once a filtered kernel is included, knows of Boost's multiprecision numbers, but not of these.
namespace CGAL {

template <>
struct Algebraic_structure_traits<Float_50> : Algebraic_structure_traits_base<Float_50, Field_tag>
{
  using Is_exact = Tag_false;
};

template <>
struct Real_embeddable_traits<Float_50> : INTERN_RET::Real_embeddable_traits_base<Float_50, Tag_true>
{};

} // namespace CGAL

// The local kernel's type does all the arithmetic: its epsilon is the measure of the errors.
template <class Number>
void local(const std::string& name)
{
  using Fit = CGAL::Monge_via_jet_fitting<CGAL::Simple_cartesian<Number>, CGAL::Simple_cartesian<Number>>;
  static_assert(std::is_same_v<typename Fit::FT, Number>);
  const auto samples = converted<Number>(known_samples());
  const Known_form<Wide> truth = reference_fit<Wide>(samples, 4, 4).form;
  check_digits(fitted<Fit>(as<typename Fit::Data_kernel::Point_3>(samples)), truth,
               static_cast<double>(std::numeric_limits<Number>::epsilon()), name);
}

// Double data through a wider local kernel: only the rounding of the result is left.
template <class Number>
void wider_local(const std::string& name)
{
  using Fit = CGAL::Monge_via_jet_fitting<Double, CGAL::Simple_cartesian<Number>>;
  const auto samples = known_samples();
  const auto points = as<Double::Point_3>(samples);
  const auto estimate = Fit().estimate(points.begin(), points.end(), 4, 4);
  static_assert(std::is_same_v<std::decay_t<decltype(estimate.condition_number())>, Number>);
  const Known_form<Wide> truth =
      aligned(reference_fit<Wide>(samples, 4, 4).form, known_form<Wide>(estimate.monge_form(), 4, To_wide()));
  const auto& c = estimate.monge_form().coefficients();
  check_near(c[0], static_cast<double>(truth.derivative(2, 0)), 2.3e-16 * std::abs(c[0]), name + " k1");
  check_near(c[1], static_cast<double>(truth.derivative(0, 2)), 2.3e-16 * std::abs(c[1]), name + " k2");
  for (int k = 3; k <= 4; ++k)
    for (int j = 0; j <= k; ++j) {
      const double expected = static_cast<double>(truth.derivative(k - j, j));
      check_near(c[index_of(k - j, j) - 4], expected, 1e-15 * std::abs(expected), name + " order " + text(k));
    }
}

void users_traits_in_50_digits()
{
  const auto points = as<Double::Point_3>(known_samples());
  using Wide_fit = CGAL::Monge_via_jet_fitting<Double, CGAL::Simple_cartesian<Float_50>, Counting_svd<Float_50>>;
  Wide_fit wide_fit;
  const auto wide_form = wide_fit(points.begin(), points.end(), 4, 4);
  check_equal(Counting_svd<Float_50>::calls(), 1, "calls of a user's 50-digit traits");
  check_near(wide_form.principal_curvatures(0),
             CGAL::Monge_via_jet_fitting<Double>()(points.begin(), points.end(), 4, 4).principal_curvatures(0), 1e-13,
             "k1 by a user's 50-digit traits");
}

int main()
{
  local<float>("float throughout");
  local<double>("double throughout");
  local<long double>("long double throughout");
  local<Float_50>("50 digits throughout");
  wider_local<long double>("double data, long double inside");
  wider_local<Float_50>("double data, 50 digits inside");
  users_traits_in_50_digits();
  return result();
}
