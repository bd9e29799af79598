// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_ESTIMATION_SUMMARY_H
#define CGAL_JET_FITTING_3_ESTIMATION_SUMMARY_H

#include <CGAL/Jet_fitting_3/Estimation_status.h>
#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/values/Noise.h>
#include <CGAL/Jet_fitting_3/values/Standard_errors.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {

/// \ingroup PkgJetFitting3Results
/// What automatic() chose for the principal curvatures at a point; all zero with other neighborhoods. Of the two
/// curvatures, which choose for themselves, the larger degree, and roots of mean squares. Where a curvature is a mean
/// of fits, as on meshes: of their radii by weight the root of the mean square, and the degree with most of the weight.
struct Chosen_scale
{
  double radius = 0;             ///< length; of balls or disks, or of disks of the area of ellipses
  std::size_t degree = 0;        ///< of the jet
  double bias = 0;               ///< as estimated, 1/length
  double standard_deviation = 0; ///< by noise, as estimated, 1/length

  /// Standard errors of k1 and of k2, 1/length, that contain noise and bias: k +- 1.96 error is meant to hold the truth
  /// in 95 of 100 cases; the manual says how far they do.
  std::array<double, 2> curvature_errors{};

  /// Standard errors of b0 and of b3, 1/length^2, that contain noise and bias; 0 if they were not chosen for, as below
  /// degree 3.
  std::array<double, 2> third_order_errors{};
};

/// \ingroup PkgJetFitting3Results
/// How well a form is determined: what Monge_estimate tells of a single fit.
struct Fit_quality
{
  std::size_t number_of_points = 0;        ///< of the neighborhood, p included
  double condition_number = 0;             ///< of the preconditioned system
  double residual_rms = 0;                 ///< length
  Standard_errors<double> standard_errors; ///< of the form as it was written, if asked for
  Chosen_scale scale;                      ///< of automatic()

  /// That of the form after the turn of Monge_form::comply_wrt_given_normal().
  void turn()
  {
    standard_errors.turn();
    std::swap(scale.curvature_errors[0], scale.curvature_errors[1]);
    std::swap(scale.third_order_errors[0], scale.third_order_errors[1]);
  }
};

/// \ingroup PkgJetFitting3Results
/// What became of the vertices of a mesh, or of the points of a range, in one call.
/// \tparam Item vertex_descriptor of the mesh, or std::size_t, the position in the range
template <class Item>
class Estimation_summary
{
public:
  /// A readable property map from Item to Estimation_status. It refers to the summary, which must outlive it.
  class Status_map
  {
  public:
    /// @{
    /// The types of the map; its construction and its value at an item.
    using key_type = Item;
    using value_type = Estimation_status;
    using reference = Estimation_status;
    using category = boost::readable_property_map_tag;

    explicit Status_map(const Estimation_summary& summary) : m_summary(&summary) {}
    friend Estimation_status get(const Status_map& map, const Item& item) { return map.m_summary->status(item); }
    /// @}

  private:
    const Estimation_summary* m_summary;
  };

  /// A readable property map from Item to a number of its Chosen_scale, 0 where none was chosen. It refers to the
  /// summary, which must outlive it.
  template <class Number>
  class Scale_map
  {
  public:
    /// @{
    /// The types of the map; its construction and its value at an item.
    using key_type = Item;
    using value_type = Number;
    using reference = Number;
    using category = boost::readable_property_map_tag;

    Scale_map(const Estimation_summary& summary, Number Chosen_scale::*number) : m_summary(&summary), m_number(number)
    {}
    friend Number get(const Scale_map& map, const Item& item)
    {
      return map.m_summary->quality(item).scale.*map.m_number;
    }
    /// @}

  private:
    const Estimation_summary* m_summary;
    Number Chosen_scale::*m_number;
  };

  std::size_t estimated = 0; ///< number of items with a form
  std::size_t skipped = 0;   ///< number of items without, their forms are empty
  bool cancelled =
      false;   ///< by the callback: estimated + skipped may be less than all, the forms of the rest are untouched
  Noise noise; ///< of all points, in the unit of the coordinates: what automatic() has estimated, or was given
  std::vector<std::pair<Item, Estimation_status>>
      skipped_items; ///< which, and why; in their order in the mesh or range

  /// Of one item, unknown where it was not reached or does not belong to the mesh or range.
  Estimation_status status(const Item& item) const
  {
    const std::size_t i = m_number_of ? m_number_of(item) : m_statuses.size();
    return i < m_statuses.size() ? m_statuses[i] : Estimation_status();
  }

  /// The statuses as a property map.
  Status_map status_map() const { return Status_map(*this); }

  /// How many items have the flag.
  std::size_t count(Status_flag flag) const
  {
    std::size_t n = 0;
    for (const Estimation_status& s : m_statuses) n += s.has(flag);
    return n;
  }

  /// Of one item that has been estimated, if the options asked for it; otherwise all zero but the scale, which is
  /// always there with automatic().
  Fit_quality quality(const Item& item) const
  {
    const std::size_t i = m_number_of ? m_number_of(item) : m_qualities.size();
    return i < m_qualities.size() ? m_qualities[i] : Fit_quality();
  }

  /// @{
  /// What automatic() chose, and the errors that it expects of the principal curvatures, as property maps.
  Scale_map<double> radius_map() const { return {*this, &Chosen_scale::radius}; }
  Scale_map<std::size_t> degree_map() const { return {*this, &Chosen_scale::degree}; }
  Scale_map<double> bias_map() const { return {*this, &Chosen_scale::bias}; }
  Scale_map<double> standard_deviation_map() const { return {*this, &Chosen_scale::standard_deviation}; }
  /// @}

  /// The radius below which the part p of those lies that automatic() chose; 0 if it chose none.
  /// \throw Invalid_input unless p is in [0, 1]
  double radius_quantile(double p) const
  {
    if (!(p >= 0 && p <= 1)) throw Invalid_input("radius_quantile() needs p in [0, 1]: got " + number_text(p));
    std::vector<double> radii;
    for (const Fit_quality& quality : m_qualities)
      if (quality.scale.degree > 0) radii.push_back(quality.scale.radius);
    if (radii.empty()) return 0;
    const auto nth = radii.begin() + static_cast<std::ptrdiff_t>(p * double(radii.size() - 1) + 0.5);
    std::nth_element(radii.begin(), nth, radii.end());
    return *nth;
  }

  /// For how many items automatic() chose this degree.
  std::size_t count_of_degree(std::size_t degree) const
  {
    return std::size_t(std::count_if(m_qualities.begin(), m_qualities.end(), [degree](const Fit_quality& quality) {
      return degree > 0 && quality.scale.degree == degree;
    }));
  }

  /// For the functions that estimate. There may be no qualities. items are all of them in their order, number_of(item)
  /// is the index of an item in the other two.
  template <class Items>
  void set_reports(std::vector<Estimation_status> statuses, std::vector<Fit_quality> qualities, const Items& items,
                   std::function<std::size_t(const Item&)> number_of)
  {
    m_statuses = std::move(statuses);
    m_qualities = std::move(qualities);
    m_number_of = std::move(number_of);
    for (const Estimation_status& s : m_statuses) {
      estimated += s.is_estimated();
      skipped += !s.is_estimated() && !s.is_unknown();
    }
    if (skipped == 0) return;
    for (const Item& item : items) {
      const Estimation_status s = status(item);
      if (!s.is_estimated() && !s.is_unknown()) skipped_items.emplace_back(item, s);
    }
  }

private:
  std::vector<Estimation_status> m_statuses;
  std::vector<Fit_quality> m_qualities;
  std::function<std::size_t(const Item&)> m_number_of;
};

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_ESTIMATION_SUMMARY_H
