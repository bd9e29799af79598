// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Neighborhoods of the vertices of a mesh: the right vertices, the vertex itself first, nothing beyond sharp edges and
// on opposite sheets, no allocation once the buffers have grown.

#include "analytic_meshes.h"
#include "check.h"

#include <CGAL/Jet_fitting_3/neighborhoods/Vertex_gatherer.h>
#include <CGAL/Jet_fitting_3/neighborhoods/enough_rings.h>
#include <CGAL/Jet_fitting_3/neighborhoods/k_rings.h>
#include <CGAL/Jet_fitting_3/neighborhoods/nearest.h>
#include <CGAL/Jet_fitting_3/neighborhoods/within_radius.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <new>
#include <set>
#include <vector>

using namespace test;
using namespace CGAL::Jet_fitting;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Vertices = std::vector<Vertex>;

std::size_t allocations = 0;

void* operator new(std::size_t size)
{
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}

// Called through a pointer: g++ takes a free() for a mistake where it sees the new.
void (*volatile release)(void*) = std::free;
void operator delete(void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }

Mesh made(const Analytic_mesh& from)
{
  Mesh mesh;
  build(from, mesh);
  return mesh;
}

template <class Gatherer, class Neighborhood>
Vertices gathered(Gatherer& gather, const Neighborhood& neighborhood, Vertex v)
{
  Vertices found;
  gather(neighborhood, v, found);
  return found;
}

std::set<Vertex> as_set(const Vertices& vertices) { return {vertices.begin(), vertices.end()}; }

double distance(const Mesh& mesh, Vertex v, Vertex w)
{
  return std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(w)));
}

// Number of edges to every vertex that can be reached.
std::map<Vertex, std::size_t> edge_distances(const Mesh& mesh, Vertex v)
{
  std::map<Vertex, std::size_t> distances{{v, 0}};
  Vertices queue{v};
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const Vertex w = queue[i];
    if (mesh.is_isolated(w)) continue;
    for (Vertex neighbor : vertices_around_target(mesh.halfedge(w), mesh))
      if (distances.emplace(neighbor, distances[w] + 1).second) queue.push_back(neighbor);
  }
  return distances;
}

void check_ring_order(const Vertices& found, const std::map<Vertex, std::size_t>& distances, const std::string& what)
{
  check_equal(as_set(found).size(), found.size(), what + ": each vertex once");
  bool sorted = true;
  for (std::size_t i = 1; i < found.size(); ++i)
    sorted = sorted && distances.at(found[i - 1]) <= distances.at(found[i]);
  check_true(sorted, what + ": ring after ring");
}

void rings(const Mesh& mesh, const std::string& name)
{
  Vertex_gatherer<Mesh> gather(mesh);
  for (Vertex v : mesh.vertices()) {
    if (v.idx() % 7 != 0) continue;
    const std::string what = name + " vertex " + text(v);
    const auto distances = edge_distances(mesh, v);
    std::vector<std::size_t> count_within(1, 1);
    for (std::size_t k = 1; k <= 4; ++k) {
      std::set<Vertex> expected;
      for (const auto& [w, d] : distances)
        if (d <= k) expected.insert(w);
      count_within.push_back(expected.size());
      const Vertices found = gathered(gather, k_rings(std::ptrdiff_t(k)), v);
      check_equal(found.front(), v, what + ": the vertex comes first");
      check_true(as_set(found) == expected, what + ": k_rings(" + text(k) + ") has the vertices at most k edges away");
      check_ring_order(found, distances, what);
    }
    for (std::size_t n : {1, 6, 10, 15, 30}) {
      const auto enough = std::find_if(count_within.begin(), count_within.end(), [&](std::size_t c) { return c >= n; });
      const std::size_t expected = enough == count_within.end() ? count_within.back() : *enough;
      if (enough == count_within.end() && count_within[4] != count_within[3]) continue;
      check_equal(gathered(gather, enough_rings(std::ptrdiff_t(n)), v).size(), expected,
                  what + ": enough_rings(" + text(n) + ") stops after a complete ring");
    }
  }
}

// Growth to the closest vertex next to what has been reached, by its definition.
Vertices grown(const Mesh& mesh, Vertex seed, std::size_t points)
{
  Vertices found{seed};
  std::set<Vertex> candidates;
  while (found.size() < points) {
    for (Vertex w : vertices_around_target(mesh.halfedge(found.back()), mesh))
      if (std::find(found.begin(), found.end(), w) == found.end()) candidates.insert(w);
    const auto closest = std::min_element(candidates.begin(), candidates.end(), [&](Vertex a, Vertex b) {
      return distance(mesh, seed, a) < distance(mesh, seed, b);
    });
    found.push_back(*closest);
    candidates.erase(closest);
  }
  return found;
}

void by_distance()
{
  const Mesh mesh = made(jittered_square(20));
  Vertex_gatherer<Mesh> gather(mesh);
  std::size_t same_as_search = 0, asked = 0;
  for (Vertex v : mesh.vertices()) {
    if (v.idx() % 3 != 0) continue;
    const Vertices found = gathered(gather, nearest(12), v);
    check_true(found == grown(mesh, v, 12), "nearest(12) of vertex " + text(v));
    Vertices sorted(mesh.vertices().begin(), mesh.vertices().end());
    std::sort(sorted.begin(), sorted.end(),
              [&](Vertex a, Vertex b) { return distance(mesh, v, a) < distance(mesh, v, b); });
    ++asked;
    same_as_search += found == Vertices(sorted.begin(), sorted.begin() + 12);

    const double radius = 0.13;
    const auto end =
        std::find_if(sorted.begin(), sorted.end(), [&](Vertex w) { return distance(mesh, v, w) > radius; });
    const Vertices ball = gathered(gather, within_radius(radius), v);
    check_equal(ball.front(), v, "within_radius: the vertex comes first");
    check_true(as_set(ball) == as_set(Vertices(sorted.begin(), end)), "within_radius(0.13) of vertex " + text(v));
  }
  check_ge(double(same_as_search), 0.95 * double(asked), "in the plane, growth mostly finds the nearest of all");
  check_equal(gathered(gather, nearest(1000), Vertex(0)).size(), std::size_t(400), "nearest(1000) of 400 vertices");
  check_equal(gathered(gather, within_radius(1e300), Vertex(0)).size(), std::size_t(400),
              "all within an endless radius");
  check_equal(gathered(gather, within_radius(1e-300), Vertex(0)).size(), std::size_t(1), "nothing within no radius");
}

void scales()
{
  const Mesh mesh = made(jittered_square(12));
  Vertex_gatherer<Mesh> gather(mesh);
  for (int exponent : {-900, -300, 300, 900}) {
    Mesh scaled = mesh;
    for (Vertex v : scaled.vertices()) {
      const auto scale = [&](double x) { return std::ldexp(x, exponent); };
      const Kernel::Point_3 p = mesh.point(v);
      scaled.point(v) = Kernel::Point_3(scale(p.x()), scale(p.y()), scale(p.z()));
    }
    Vertex_gatherer<Mesh> gather_scaled(scaled);
    for (Vertex v : mesh.vertices()) {
      check_true(gathered(gather, nearest(9), v) == gathered(gather_scaled, nearest(9), v),
                 "nearest at scale 2^" + text(exponent));
      check_true(gathered(gather, within_radius(0.2), v) ==
                     gathered(gather_scaled, within_radius(std::ldexp(0.2, exponent)), v),
                 "within_radius at scale 2^" + text(exponent));
    }
  }
}

// A slab whose two sides are closer to each other than the ball is wide, and connected around the rim.
void thin_slab()
{
  const Mesh mesh = made(box(Point(1, 1, 0.01), 21, 2));
  const double radius = 0.16;
  std::size_t could_cross = 0;
  Vertex_gatherer<Mesh> gather(mesh);
  for (Vertex v : mesh.vertices()) {
    const double z = mesh.point(v).z();
    const auto on_this_side = [&](Vertex w) { return mesh.point(w).z() == z; };
    for (const Vertices& found : {gathered(gather, within_radius(radius), v), gathered(gather, nearest(20), v)}) {
      check_true(std::all_of(found.begin(), found.end(), on_this_side), "the other side of a slab stays out");
      check_ge(found.size(), std::size_t(10), "this side of a slab stays in");
    }
    const Vertices three_rings = gathered(gather, k_rings(3), v);
    could_cross += !std::all_of(three_rings.begin(), three_rings.end(), on_this_side);
  }
  check_ge(could_cross, std::size_t(100), "vertices that are connected with the other side within three rings");
}

Kernel::Vector_3 normal(const Mesh& mesh, Mesh::Halfedge_index h)
{
  const auto &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h)),
             &r = mesh.point(mesh.target(mesh.next(h)));
  return CGAL::cross_product(q - p, r - p);
}

bool is_right_angle(const Mesh& mesh, Mesh::Edge_index e)
{
  return normal(mesh, mesh.halfedge(e, 0)) * normal(mesh, mesh.halfedge(e, 1)) == 0;
}

// The sides of the unit cube on which a point lies.
std::set<int> cube_sides(const Kernel::Point_3& p)
{
  std::set<int> sides;
  for (int axis = 0; axis < 3; ++axis)
    for (int side : {0, 1})
      if (p[axis] == side) sides.insert(2 * axis + side);
  return sides;
}

void sharp_edges()
{
  Mesh mesh = made(box(Point(1, 1, 1), 9, 9));
  auto is_sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
  for (Mesh::Edge_index e : mesh.edges()) is_sharp[e] = is_right_angle(mesh, e);
  const auto np = CGAL::parameters::edge_is_constrained_map(is_sharp);
  Vertex_gatherer<Mesh, std::decay_t<decltype(np)>> gather(mesh, np);

  const auto share_a_side = [&](const Vertices& found) {
    std::set<int> common = cube_sides(mesh.point(found.front()));
    for (Vertex w : found) {
      const std::set<int> sides = cube_sides(mesh.point(w));
      std::set<int> both;
      std::set_intersection(common.begin(), common.end(), sides.begin(), sides.end(), std::inserter(both, both.end()));
      common = both;
    }
    return !common.empty();
  };
  for (Vertex v : mesh.vertices()) {
    const std::string what = "sharp cube, vertex " + text(v);
    for (const Vertices& found : {gathered(gather, k_rings(3), v), gathered(gather, enough_rings(12), v),
                                  gathered(gather, nearest(12), v), gathered(gather, within_radius(0.4), v)}) {
      check_equal(found.front(), v, what + ": the vertex comes first");
      check_true(share_a_side(found), what + ": all on one side of the cube");
      check_ge(found.size(), std::size_t(6), what + ": its neighbors on that side");
    }
  }
  // End points belong to both sides: three rings of a vertex one edge inside hold vertices of the edge.
  for (Vertex v : mesh.vertices()) {
    const auto found = gathered(gather, k_rings(3), v);
    if (cube_sides(mesh.point(v)).size() != 1 || mesh.point(v).x() != 0.125) continue;
    check_true(std::any_of(found.begin(), found.end(), [&](Vertex w) { return cube_sides(mesh.point(w)).size() > 1; }),
               "sharp cube: the vertices on the edge are taken");
  }

  Vertex_gatherer<Mesh> gather_all(mesh);
  std::size_t crossing = 0;
  for (Vertex v : mesh.vertices()) crossing += !share_a_side(gathered(gather_all, k_rings(3), v));
  check_ge(crossing, std::size_t(100), "neighborhoods that cross the edges where these are not constrained");
}

// The smooth patches that meet at each vertex: faces connected by edges with a dihedral angle of less than 30 degrees.
std::vector<std::set<int>> patches_of_vertices(const Mesh& mesh,
                                               const Mesh::Property_map<Mesh::Edge_index, bool>& is_sharp)
{
  std::vector<std::set<int>> patches(mesh.num_vertices());
  std::vector<int> patch(mesh.num_faces(), -1);
  int patches_so_far = 0;
  for (Mesh::Face_index seed : mesh.faces()) {
    if (patch[seed] != -1) continue;
    std::vector<Mesh::Face_index> queue{seed};
    patch[seed] = patches_so_far;
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (Mesh::Halfedge_index h : halfedges_around_face(mesh.halfedge(queue[i]), mesh)) {
        patches[mesh.target(h)].insert(patches_so_far);
        const Mesh::Halfedge_index o = mesh.opposite(h);
        if (is_sharp[mesh.edge(h)] || mesh.is_border(o) || patch[mesh.face(o)] != -1) continue;
        patch[mesh.face(o)] = patches_so_far;
        queue.push_back(mesh.face(o));
      }
    ++patches_so_far;
  }
  return patches;
}

void fandisk()
{
  Mesh mesh;
  std::ifstream file(CGAL::data_file_path("meshes/fandisk.off"));
  check_true(bool(file >> mesh) && mesh.num_vertices() == 6475, "CGAL's data file fandisk.off is read");
  auto is_sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
  for (Mesh::Edge_index e : mesh.edges()) {
    const Kernel::Vector_3 n = normal(mesh, mesh.halfedge(e, 0)), m = normal(mesh, mesh.halfedge(e, 1));
    is_sharp[e] = n * m < std::cos(std::acos(-1.) / 6) * std::sqrt(n * n) * std::sqrt(m * m);
  }
  const auto patches = patches_of_vertices(mesh, is_sharp);
  const auto np = CGAL::parameters::edge_is_constrained_map(is_sharp);
  Vertex_gatherer<Mesh, std::decay_t<decltype(np)>> gather(mesh, np);
  Vertex_gatherer<Mesh> gather_all(mesh);

  const auto share_a_patch = [&](const Vertices& found) {
    std::set<int> common = patches[found.front()];
    for (Vertex w : found) {
      std::set<int> both;
      std::set_intersection(common.begin(), common.end(), patches[w].begin(), patches[w].end(),
                            std::inserter(both, both.end()));
      common = both;
    }
    return !common.empty();
  };
  std::size_t crossing = 0;
  for (Vertex v : mesh.vertices()) {
    for (const Vertices& found : {gathered(gather, k_rings(3), v), gathered(gather, nearest(20), v)})
      check_true(share_a_patch(found), "fandisk: the neighborhood of vertex " + text(v) + " is on one smooth patch");
    crossing += !share_a_patch(gathered(gather_all, k_rings(3), v));
  }
  check_ge(crossing, std::size_t(500), "fandisk: neighborhoods that cross sharp edges where these are not constrained");
}

// A sharp line that ends inside the surface: growth goes around its end, and a vertex at the end has all neighbors.
void open_sharp_line()
{
  const std::size_t n = 11;
  Mesh mesh = made(jittered_square(n));
  const auto at = [&](std::size_t i, std::size_t j) { return Vertex(unsigned(i * n + j)); };
  auto is_sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
  for (std::size_t i = 0; i < 5; ++i) is_sharp[mesh.edge(mesh.halfedge(at(i, 5), at(i + 1, 5)))] = true;
  const auto np = CGAL::parameters::edge_is_constrained_map(is_sharp);
  Vertex_gatherer<Mesh, std::decay_t<decltype(np)>> gather(mesh, np);

  check_equal(gathered(gather, k_rings(1), at(5, 5)).size(), std::size_t(7),
              "all neighbors at the end of a sharp line");
  const auto beside = as_set(gathered(gather, k_rings(2), at(2, 4)));
  check_equal(beside.count(at(2, 5)), std::size_t(1), "vertices on the line are taken");
  check_equal(beside.count(at(2, 6)), std::size_t(0), "the line is not crossed");
  const auto around = as_set(gathered(gather, k_rings(9), at(4, 4)));
  check_equal(around.count(at(4, 6)), std::size_t(1), "growth goes around the end");
  const auto on_line = as_set(gathered(gather, k_rings(1), at(2, 5)));
  check_true(on_line.count(at(2, 4)) + on_line.count(at(2, 6)) == 1, "a vertex on the line takes one side only");
}

// Every kind of odd vertex in one mesh: removed, isolated, not finite.
void odd_vertices()
{
  Mesh mesh = made(jittered_square(12));
  const Vertex isolated = mesh.add_vertex(Kernel::Point_3(0.5, 0.5, 0.5));
  CGAL::Euler::remove_center_vertex(mesh.halfedge(Vertex(40)), mesh);
  const Vertex far(70), next_to_it(71);
  mesh.point(far) = Kernel::Point_3(0, std::numeric_limits<double>::quiet_NaN(), 0);
  check_true(mesh.is_removed(Vertex(40)), "vertex 40 is removed");

  Vertex_gatherer<Mesh> gather(mesh);
  check_true(gathered(gather, k_rings(2), isolated) == Vertices{isolated}, "an isolated vertex is alone");
  check_true(gathered(gather, nearest(5), isolated) == Vertices{isolated}, "an isolated vertex has no nearest");
  check_true(gathered(gather, k_rings(2), far) == Vertices{far}, "a vertex that is not finite is alone");
  for (Vertex v : mesh.vertices()) {
    if (v == far) continue;
    for (const Vertices& found :
         {gathered(gather, k_rings(3), v), gathered(gather, nearest(15), v), gathered(gather, within_radius(0.3), v)})
      check_true(std::none_of(found.begin(), found.end(), [&](Vertex w) { return w == far || mesh.is_removed(w); }),
                 "vertices that are removed or not finite are no neighbors");
  }
  check_ge(gathered(gather, k_rings(1), next_to_it).size(), std::size_t(4), "beside a vertex that is not finite");
  check_throws<Invalid_input>([&] { gathered(gather, k_rings(1), Vertex(40)); }, {"vertex"}, "a removed vertex");
  check_throws<Invalid_input>([&] { gathered(gather, k_rings(1), Vertex(4000)); }, {"vertex"}, "a vertex out of range");
}

void allocates_nothing()
{
  const Mesh mesh = made(bezier(60));
  Vertex_gatherer<Mesh> gather(mesh);
  Vertices found;
  std::size_t first = 0, second = 0;
  for (std::size_t* count : {&first, &second}) {
    const std::size_t before = allocations;
    for (Vertex v : mesh.vertices()) {
      gather(k_rings(4), v, found);
      gather(enough_rings(30), v, found);
      gather(nearest(30), v, found);
      gather(within_radius(0.1), v, found);
    }
    *count = allocations - before;
  }
  check_ge(first, std::size_t(1), "allocations while the buffers grow");
  check_equal(second, std::size_t(0), "allocations in the steady state");
}

void bad_arguments()
{
  check_throws<Invalid_input>([] { k_rings(0); }, {"k_rings", "0"}, "no rings");
  check_throws<Invalid_input>([] { k_rings(-3); }, {"k_rings", "-3"}, "negative rings");
  check_throws<Invalid_input>([] { enough_rings(0); }, {"enough_rings", "0"}, "rings until nothing");
  check_throws<Invalid_input>([] { nearest(-1); }, {"nearest", "-1"}, "a negative number of points");
  check_throws<Invalid_input>([] { within_radius(0); }, {"within_radius"}, "no radius");
  check_throws<Invalid_input>([] { within_radius(std::numeric_limits<double>::quiet_NaN()); }, {"within_radius"},
                              "NaN");
}

int main()
{
  rings(made(bezier(15)), "border");
  rings(made(sphere(1, 6)), "closed");
  rings(made(bezier(12, true)), "quadrangles");
  Mesh odd = made(torus(2, 1, 12, 9));
  odd.add_vertex(Kernel::Point_3(0, 0, 0));
  CGAL::Euler::remove_center_vertex(odd.halfedge(Vertex(40)), odd);
  rings(odd, "removed and isolated vertices");
  by_distance();
  scales();
  thin_slab();
  sharp_edges();
  fandisk();
  open_sharp_line();
  odd_vertices();
  allocates_nothing();
  bad_arguments();
  return result();
}
