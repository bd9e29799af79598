// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_PREPARED_VERTEX_ESTIMATOR_H
#define CGAL_JET_FITTING_3_PREPARED_VERTEX_ESTIMATOR_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Estimation_summary.h>
#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/Options.h>
#include <CGAL/Jet_fitting_3/internal/fitting/Mesh_estimation.h>
#include <CGAL/Jet_fitting_3/internal/fitting/Ordered_output.h>
#include <CGAL/Jet_fitting_3/internal/fitting/some_vertices.h>
#include <CGAL/Jet_fitting_3/internal/gathering/Rows.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/prepared/Form_and_status.h>
#include <CGAL/Jet_fitting_3/prepared/internal/One_row_estimator.h>
#include <CGAL/Jet_fitting_3/prepared/internal/place_on_face.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <boost/range/irange.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// \ingroup PkgJetFitting3All
/// Estimates Monge forms at single vertices of a mesh, or at places on its faces, as often as asked: the tables that
/// estimate_vertex_monge_forms() makes for a call are made once, in linear time, and kept. A form then takes as long as
/// its fit. Forms and statuses are those of a call for the whole mesh, bit by bit.
///
/// The mesh, its property maps and `np` are read by the constructor; of the mesh, vertices and faces are asked later
/// on, too. It must not change as long as the object is used. Copies share the tables: each thread needs a copy of its
/// own, which takes two bytes a vertex.
///
/// \tparam Mesh a model of FaceListGraph and HalfedgeListGraph
/// \tparam Neighborhood Jet_fitting::automatic(), k_rings(), enough_rings(), nearest(), within_radius(), or the user's
///        own
template <class Mesh, class Neighborhood, class NamedParameters = parameters::Default_named_parameters>
class Vertex_estimator
{
  using Estimation = internal::Mesh_estimation<Mesh, Neighborhood, NamedParameters>;
  using Graph = boost::graph_traits<Mesh>;
  using Rows_at_places = internal::Rows_at_places<typename Estimation::Kernel::Point_3>;

public:
  /// @{
  /// The types of the mesh.
  using vertex_descriptor = typename Graph::vertex_descriptor;
  using face_descriptor = typename Graph::face_descriptor;
  /// @}
  using Kernel = typename Estimation::Kernel; ///< of the points
  using FT = typename Kernel::FT;             ///< its number type
  using Point_3 = typename Kernel::Point_3;   ///< its points
  using Result = Form_and_status<Kernel>;     ///< what is known at one place

  /// A face and barycentric coordinates, as Polygon_mesh_processing has them: of source and target of halfedge(f,
  /// mesh), and of the third corner. They are meant to add up to 1: the first is taken for what the others leave.
  using Face_location = std::pair<face_descriptor, std::array<FT, 3>>;

  /// Makes the tables.
  /// \param mesh, neighborhood, np, options as for estimate_vertex_monge_forms(). The object keeps a reference to the
  ///        mesh and copies of the others; `callback` is called by estimate() and estimate_at()
  /// \param tag Sequential_tag, Parallel_tag, or Parallel_if_available_tag
  /// \throw Invalid_input for impossible degrees and options
  template <class ConcurrencyTag = Sequential_tag>
  explicit Vertex_estimator(const Mesh& mesh, const Neighborhood& neighborhood,
                            const NamedParameters& np = parameters::default_values(), const Options& options = {},
                            ConcurrencyTag tag = {})
    : m_prepared(std::make_shared<const Prepared>(tag, mesh, neighborhood, np, options)),
      m_one_row(m_prepared->estimation.gatherer(), m_prepared->estimation.estimator())
  {}

  /// At a vertex.
  /// \throw Invalid_input if v is not a vertex of the mesh
  Result operator()(vertex_descriptor v)
  {
    const internal::Index i = tables().index_of_any(v);
    if (i == internal::no_index) throw Invalid_input("the vertex does not belong to the mesh, or no longer");
    return m_one_row(tables(), internal::Some_rows({i}));
  }

  /// At the foot of a place on a face: the jet is fitted to the neighborhood of the corner that is nearest, and the
  /// result is its form at its point closest to the place. So it has a form of the same accuracy as at a vertex, and
  /// the origin of the form lies on the jet, not on the face. Where that corner is on a constrained edge, its
  /// neighborhood is on the side of the face, as in estimate_side_monge_forms(), but for one of the user's own.
  /// With automatic() the jet is the one that is chosen for the corner, of one degree more than the form, unless
  /// `degree_fitting` is less.
  ///
  /// The status is that of the fit, or Status_flag::beside_samples if no point of the jet over the samples is closest
  /// to the place; Status_flag::not_finite if a barycentric coordinate is not finite.
  /// \throw Invalid_input if the face is not a triangle with vertices of the mesh, or options.standard_errors is set,
  ///        since they are those of another place
  Result operator()(const Face_location& location) { return m_one_row(tables(), rows_at(&location, &location + 1)); }

  /// At a range of vertices, as estimate_vertex_monge_forms(vertices, mesh, ...) does.
  /// A vertex that is given twice is estimated, and counted, once; the parameter `callback` is called.
  /// \throw Invalid_input if one is not a vertex of the mesh
  template <class ConcurrencyTag = Sequential_tag, class VertexRange, class VertexFormMap>
  Estimation_summary<vertex_descriptor> estimate(const VertexRange& vertices, VertexFormMap vertex_form_map) const
  {
    return internal::estimate_some_vertices<ConcurrencyTag>(m_prepared->estimation,
                                                            internal::some_vertices(tables(), vertices),
                                                            vertex_form_map);
  }

  /// At a range of Face_location: a form for each goes to `output`, in order.
  /// \return the summary; items are positions in the range
  template <class ConcurrencyTag = Sequential_tag, class LocationRange, class OutputIterator>
  Estimation_summary<std::size_t> estimate_at(const LocationRange& locations, OutputIterator output) const
  {
    const Rows_at_places rows = rows_at(std::begin(locations), std::end(locations));
    internal::Ordered_output<Kernel, OutputIterator> ordered(output);
    internal::Estimation_reports reports =
        m_prepared->estimation.template estimate<ConcurrencyTag>(rows, std::ref(ordered),
                                                                 m_prepared->estimation.progress());
    return internal::summary_of<std::size_t>(std::move(reports), boost::irange(std::size_t(0), rows.size()),
                                             [](std::size_t i) { return i; });
  }

private:
  struct Prepared
  {
    template <class ConcurrencyTag>
    Prepared(ConcurrencyTag tag, const Mesh& m, const Neighborhood& n, const NamedParameters& np, const Options& o)
      : mesh(m), neighborhood(n), estimation(tag, mesh, neighborhood, np, o, true), sharp_corners(estimation.tables())
    {}

    const Mesh& mesh;
    Neighborhood neighborhood;
    Estimation estimation;
    internal::Sharp_corners<typename Estimation::Tables> sharp_corners;
  };

  const typename Estimation::Tables& tables() const { return m_prepared->estimation.tables(); }

  template <class Iterator>
  Rows_at_places rows_at(Iterator begin, Iterator end) const
  {
    internal::check_options_for_places(m_prepared->estimation.options());
    std::vector<Point_3> places;
    std::vector<internal::Index> seeds;
    for (; begin != end; ++begin) {
      const Face_location& location = *begin;
      const auto corners = internal::corners_of_triangle(location.first, m_prepared->mesh);
      const std::array<internal::Index, 3> numbers{tables().index_of_any(corners[0]), tables().index_of_any(corners[1]),
                                                   tables().index_of_any(corners[2])};
      if (std::count(numbers.begin(), numbers.end(), internal::no_index) > 0)
        throw Invalid_input("the face does not belong to the mesh, or no longer");
      const auto& points = tables().points;
      const std::array<Point_3, 3> triangle{points[numbers[0]], points[numbers[1]], points[numbers[2]]};
      places.push_back(internal::place_in_triangle<Kernel>(triangle, location.second));
      const std::size_t nearest = internal::nearest_corner(triangle, places.back());
      const auto h = internal::halfedge_into_corner(location.first, nearest, m_prepared->mesh);
      seeds.push_back(m_prepared->sharp_corners.node(numbers[nearest], h));
    }
    return Rows_at_places(std::move(places), std::move(seeds));
  }

  using Gatherer = decltype(std::declval<const Estimation&>().gatherer());

  std::shared_ptr<const Prepared> m_prepared;
  internal::One_row_estimator<Gatherer, typename Estimation::Estimator, Kernel> m_one_row;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_PREPARED_VERTEX_ESTIMATOR_H
