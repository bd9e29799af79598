// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_TABLES_VERTEX_NUMBERING_H
#define CGAL_JET_FITTING_3_INTERNAL_TABLES_VERTEX_NUMBERING_H

#include <CGAL/license/Jet_fitting_3.h>

#include <CGAL/Jet_fitting_3/Invalid_input.h>
#include <CGAL/Jet_fitting_3/internal/Index.h>
#include <CGAL/Jet_fitting_3/internal/machine/prefetch.h>
#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Jet_fitting {
namespace internal {
CGAL_JET_FITTING_3_BEGIN_NATIVE

struct No_ids
{};

/// The ids that come with a mesh: the named parameter vertex_index_map, else the mesh's own, else No_ids.
template <class Mesh, class NamedParameters>
auto vertex_ids(const Mesh& mesh, const NamedParameters& np)
{
  if constexpr (!parameters::is_default_parameter<NamedParameters, internal_np::vertex_index_t>::value)
    return parameters::get_parameter(np, internal_np::vertex_index);
  else if constexpr (graph_has_property<Mesh, boost::vertex_index_t>::value) return get(boost::vertex_index, mesh);
  else return No_ids();
}

/// Numbers the vertices of a mesh 0, 1, 2, ... without gaps, in the order of vertices(mesh) unless reordered.
/// Ids that come with the mesh are used where they are distinct and not much larger than the number of vertices: gaps
/// of removed vertices are fine. Otherwise (no ids, never initialised, used for something else) a hash table is.
template <class Mesh, class Ids>
class Vertex_numbering
{
  using vertex_descriptor = typename boost::graph_traits<Mesh>::vertex_descriptor;

public:
  Vertex_numbering(const Mesh& mesh, Ids ids) : m_ids(ids)
  {
    m_vertices.reserve(num_vertices(mesh)); // some meshes count removed ones, too
    for (vertex_descriptor v : make_range(vertices(mesh))) m_vertices.push_back(v);
    m_vertices.shrink_to_fit();
    if (size() >= most_vertices)
      throw Invalid_input("a mesh of " + std::to_string(size()) + " vertices is too large: the limit is " +
                          std::to_string(most_vertices - 1));
    if (!number_by_id()) number_by_hash();
  }

  std::size_t size() const { return m_vertices.size(); }
  vertex_descriptor operator[](Index i) const { return m_vertices[i]; }

  /// Whether numbers differ from the order of vertices(mesh).
  bool is_reordered() const { return !m_positions.empty(); }

  /// Where vertex i stands in vertices(mesh).
  Index position(Index i) const { return is_reordered() ? m_positions[i] : i; }

  /// The number of v, or no_index where v is not a vertex of the mesh.
  Index operator()(vertex_descriptor v) const
  {
    if (!m_slots.empty()) return find(v);
    if constexpr (!std::is_same<Ids, No_ids>::value) {
      const std::size_t id = static_cast<std::size_t>(get(m_ids, v));
      if (m_is_identity) return id < size() ? static_cast<Index>(id) : no_index;
      return id < m_number_of.size() ? m_number_of[id] : no_index;
    }
    return no_index;
  }

  /// Whether numbers are kept in a table by id.
  bool is_table() const { return !m_number_of.empty(); }

  /// Prefetches the entry of v in that table.
  void prefetch(vertex_descriptor v) const
  {
    if constexpr (!std::is_same<Ids, No_ids>::value) {
      const std::size_t id = static_cast<std::size_t>(get(m_ids, v));
      if (id < m_number_of.size()) internal::prefetch(&m_number_of[id]);
    }
  }

  /// Gives number i to the vertex that has number order[i] now; order is a permutation.
  void reorder(const std::vector<Index>& order)
  {
    std::vector<Index> new_number(size());
    for (std::size_t i = 0; i < size(); ++i) new_number[order[i]] = static_cast<Index>(i);
    for (std::vector<Index>* numbers : {&m_slots, &m_number_of})
      for (Index& number : *numbers)
        if (number != no_index) number = new_number[number];
    if (m_is_identity) m_number_of.swap(new_number);
    m_is_identity = false;
    m_vertices = reordered(m_vertices, order);
    m_positions = is_reordered() ? reordered(m_positions, order) : order;
  }

private:
  bool number_by_id()
  {
    if constexpr (std::is_same<Ids, No_ids>::value) {
      return size() == 0;
    } else {
      const std::size_t most_ids = 4 * size() + 64;
      m_is_identity = true;
      std::size_t ids_end = 0;
      for (std::size_t i = 0; i < size(); ++i) {
        const std::size_t id = static_cast<std::size_t>(get(m_ids, m_vertices[i]));
        if (id >= most_ids) return false;
        m_is_identity = m_is_identity && id == i;
        if (id >= ids_end) ids_end = id + 1;
      }
      if (m_is_identity) return true;
      m_number_of.assign(ids_end, Index(no_index));
      for (std::size_t i = 0; i < size(); ++i) {
        Index& number = m_number_of[static_cast<std::size_t>(get(m_ids, m_vertices[i]))];
        if (number != no_index) return false;
        number = static_cast<Index>(i);
      }
      return true;
    }
  }

  void number_by_hash()
  {
    m_is_identity = false;
    std::vector<Index>().swap(m_number_of);
    m_slots.assign(size() + size() / 2 + 1, Index(no_index));
    for (std::size_t i = 0; i < size(); ++i) m_slots[slot(m_vertices[i])] = static_cast<Index>(i);
  }

  Index find(vertex_descriptor v) const { return m_slots[slot(v)]; }

  /// The slot that holds v, or the free one where it belongs (linear probing).
  std::size_t slot(vertex_descriptor v) const
  {
    const std::uint64_t mixed = std::uint64_t(std::hash<vertex_descriptor>()(v)) * 0x9e3779b97f4a7c15u;
    std::size_t s = std::size_t(((mixed >> 32) * m_slots.size()) >> 32);
    while (m_slots[s] != no_index && !(m_vertices[m_slots[s]] == v)) s = s + 1 == m_slots.size() ? 0 : s + 1;
    return s;
  }

  Ids m_ids;
  std::vector<vertex_descriptor> m_vertices;
  std::vector<Index> m_number_of; // by id
  std::vector<Index> m_slots;     // of the hash table
  std::vector<Index> m_positions; // by number; none as long as it is the number
  bool m_is_identity = false;
};

CGAL_JET_FITTING_3_END_NATIVE
} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_TABLES_VERTEX_NUMBERING_H
