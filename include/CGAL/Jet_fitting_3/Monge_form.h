// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_MONGE_FORM_H
#define CGAL_JET_FITTING_3_MONGE_FORM_H

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/values/Monge_coefficients.h>

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {

/// \ingroup PkgJetFitting3Results
/// The result of an estimation (section 5.1.2): the point of the fitted surface at which the quantities are estimated,
/// the orthonormal direct Monge basis (d1, d2, n) there, and the Monge coefficients.
///
/// In this basis the surface is
///
/// \f[ z = \frac{1}{2} (k_1 x^2 + k_2 y^2) + \frac{1}{6} (b_0 x^3 + 3 b_1 x^2 y + 3 b_2 x y^2 + b_3 y^3) \f]
/// \f[ + \frac{1}{24} (c_0 x^4 + 4 c_1 x^3 y + 6 c_2 x^2 y^2 + 4 c_3 x y^3 + c_4 y^4) + \dots \f]
///
/// k1 >= k2, in 1/length, are positive where the surface bends towards n: -1/r on a sphere of radius r whose n points
/// outwards. (-d1, -d2, n), under which the coefficients of odd order change sign, is the other Monge basis.
///
/// A default constructed form is empty: zero vectors, no coefficients. So is the form of a point that could not be
/// estimated.
///
/// \tparam DataKernel has FT, Point_3 and Vector_3
template <class DataKernel>
class Monge_form
{
public:
  /// @{
  /// That of the DataKernel.
  using FT = typename DataKernel::FT;
  using Point_3 = typename DataKernel::Point_3;
  using Vector_3 = typename DataKernel::Vector_3;
  /// @}

  Monge_form() : Monge_form(Point_3(FT(0), FT(0), FT(0)), zero(), zero(), zero()) {}

  /// A frame without coefficients.
  Monge_form(const Point_3& origin, const Vector_3& d1, const Vector_3& d2, const Vector_3& n)
    : m_origin(origin), m_k1_direction(d1), m_k2_direction(d2), m_n(n)
  {}

  /// @{
  /// The projection of p on the fitted surface along the z axis of the fitting basis.
  const Point_3& origin() const { return m_origin; }
  Point_3& origin() { return m_origin; }
  /// @}
  /// @{
  /// d1, the direction of k1.
  const Vector_3& maximal_principal_direction() const { return m_k1_direction; }
  Vector_3& maximal_principal_direction() { return m_k1_direction; }
  /// @}
  /// @{
  /// d2, the direction of k2.
  const Vector_3& minimal_principal_direction() const { return m_k2_direction; }
  Vector_3& minimal_principal_direction() { return m_k2_direction; }
  /// @}
  /// @{
  /// n = d1 ^ d2.
  const Vector_3& normal_direction() const { return m_n; }
  Vector_3& normal_direction() { return m_n; }
  /// @}

  /// @{
  /// k1, k2, b0..b3, c0..c4, then g_50, g_41, ..., up to the degree d': (d'+1)(d'+2)/2 - 4 entries, none for d' = 1.
  const std::vector<FT>& coefficients() const { return m_derivatives; }
  std::vector<FT>& coefficients() { return m_derivatives; }
  /// @}

  /// k1 for i = 0, k2 for i = 1.
  /// \throw std::out_of_range (as all coefficient accessors) for an index that does not exist at this degree
  const FT& principal_curvatures(std::size_t i) const { return coefficient("principal curvature", i, 2, 0); }
  /// b_i.
  const FT& third_order_coefficients(std::size_t i) const { return coefficient("third order coefficient", i, 4, 2); }
  /// c_i.
  const FT& fourth_order_coefficients(std::size_t i) const { return coefficient("fourth order coefficient", i, 5, 6); }

  /// The degree d' of the form; 1 if it has no coefficients.
  std::size_t degree() const
  {
    std::size_t degree = 1;
    while (number_of_monge_coefficients(degree + 1) <= m_derivatives.size()) ++degree;
    return degree;
  }

  /// g_ij, the derivative of the height function of the form, for i + j <= d': g_20 = k1, g_02 = k2, b_j = g_(3-j)j,
  /// ... Those of order below 2 and g_11 are 0.
  FT derivative(std::size_t i, std::size_t j) const
  {
    const std::size_t order = i + j;
    if (order > degree())
      throw std::out_of_range("Monge_form::derivative(" + std::to_string(i) + ", " + std::to_string(j) +
                              "): the form has degree " + std::to_string(degree()));
    if (order < 2 || (i == 1 && j == 1)) return FT(0);
    return m_derivatives[order == 2 ? j / 2 : monge_offset(order) + j];
  }

  /// Makes room for the coefficients of degree d', all zero. \throw Invalid_input if it is above highest_degree
  void set_up(std::size_t degree)
  {
    check_highest_degree("a Monge form", "d'", degree);
    m_derivatives.assign(number_of_monge_coefficients(degree), FT(0));
  }

  /// Turns the normal to the side of the given one (section 5.1.2): if given . n < 0, the basis becomes (d2, d1, -n),
  /// in which z = g(x, y) reads z = -g(y, x), so that every coefficient g_ij becomes -g_ji. Exact; doing it twice with
  /// opposite normals restores the form.
  /// \return false if given . n is 0 or not a number: the given normal orients nothing, and the form stays as it is
  bool comply_wrt_given_normal(const Vector_3& given)
  {
    const FT cosine = given.x() * m_n.x() + given.y() * m_n.y() + given.z() * m_n.z();
    if (!(cosine < FT(0))) return FT(0) < cosine;
    m_n = Vector_3(-m_n.x(), -m_n.y(), -m_n.z());
    std::swap(m_k1_direction, m_k2_direction);
    for (FT& coefficient : m_derivatives) coefficient = -coefficient;
    for (std::size_t k = 2; k <= degree(); ++k)
      std::reverse(m_derivatives.begin() + std::ptrdiff_t(monge_offset(k)),
                   m_derivatives.begin() + std::ptrdiff_t(monge_offset(k + 1)));
    return true;
  }

  /// Writes the form as labelled lines; what operator<< writes too.
  void dump_verbose(std::ostream& out) const
  {
    out << "origin : " << m_origin << '\n' << "n : " << m_n << '\n';
    const std::size_t highest = degree();
    if (highest >= 2)
      out << "d1 : " << m_k1_direction << '\n'
          << "d2 : " << m_k2_direction << '\n'
          << "k1 : " << m_derivatives[0] << '\n'
          << "k2 : " << m_derivatives[1] << '\n';
    for (std::size_t k = 3; k <= highest; ++k) {
      for (std::size_t i = 0; i <= k; ++i) {
        if (k == 3) out << 'b' << i;
        else if (k == 4) out << 'c' << i;
        else out << 'g' << k - i << '_' << i;
        out << " : " << m_derivatives[monge_offset(k) + i] << '\n';
      }
      if (k == 4) out << '\n';
    }
  }

  /// Writes origin, d1 * scale, d2 * scale, k1, k2 on one line: a segment for each direction.
  /// \throw std::out_of_range if d' < 2
  void dump_4ogl(std::ostream& out, const FT scale) const
  {
    const FT &k1 = principal_curvatures(0), &k2 = principal_curvatures(1);
    out << m_origin << ' ' << m_k1_direction * scale << ' ' << m_k2_direction * scale << ' ' << k1 << ' ' << k2
        << " \n";
  }

private:
  static Vector_3 zero() { return Vector_3(FT(0), FT(0), FT(0)); }

  const FT& coefficient(const char* name, std::size_t i, std::size_t count, std::size_t first) const
  {
    if (i >= count || first + count > m_derivatives.size())
      throw std::out_of_range("Monge_form has no " + std::string(name) + ' ' + std::to_string(i) + ": its degree is " +
                              std::to_string(degree()) + (m_derivatives.empty() ? ", or it is empty" : ""));
    return m_derivatives[first + i];
  }

  Point_3 m_origin;
  Vector_3 m_k1_direction, m_k2_direction, m_n;
  std::vector<FT> m_derivatives;
};

/// \ingroup PkgJetFitting3Results
/// Writes the form as Monge_form::dump_verbose() does.
template <class DataKernel>
std::ostream& operator<<(std::ostream& out, const Monge_form<DataKernel>& form)
{
  form.dump_verbose(out);
  return out;
}

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_MONGE_FORM_H
