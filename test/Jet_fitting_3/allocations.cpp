// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What is allocated: by a single fit, nothing but the coefficients of the form; for a mesh or a point set, nothing per
// form but the forms, and little memory besides.

#include "analytic_meshes.h"
#include "check.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/estimate_point_monge_forms.h>
#include <CGAL/estimate_vertex_monge_forms.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <new>
#include <string>
#include <vector>

namespace {

// Every block begins with its size. One thread only.
struct Heap
{
  std::size_t blocks = 0, bytes = 0, most_bytes = 0;
};

Heap heap;

constexpr std::size_t head = 64;

void* allocate(std::size_t size)
{
  auto* const block = static_cast<unsigned char*>(std::aligned_alloc(head, (size + 2 * head - 1) / head * head));
  if (!block) throw std::bad_alloc();
  *reinterpret_cast<std::size_t*>(block) = size;
  ++heap.blocks;
  heap.bytes += size;
  heap.most_bytes = std::max(heap.most_bytes, heap.bytes);
  return block + head;
}

void release(void* p)
{
  if (!p) return;
  unsigned char* const block = static_cast<unsigned char*>(p) - head;
  heap.bytes -= *reinterpret_cast<std::size_t*>(block);
  std::free(block);
}

} // namespace

void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
void* operator new(std::size_t size, std::align_val_t) { return allocate(size); }
void* operator new[](std::size_t size, std::align_val_t) { return allocate(size); }
void operator delete(void* p) noexcept { release(p); }
void operator delete[](void* p) noexcept { release(p); }
void operator delete(void* p, std::size_t) noexcept { release(p); }
void operator delete[](void* p, std::size_t) noexcept { release(p); }
void operator delete(void* p, std::align_val_t) noexcept { release(p); }
void operator delete[](void* p, std::align_val_t) noexcept { release(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { release(p); }
void operator delete[](void* p, std::size_t, std::align_val_t) noexcept { release(p); }

using namespace test;
using namespace CGAL::Jet_fitting;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Single_fit = CGAL::Monge_via_jet_fitting<Kernel>;
using Form = Single_fit::Monge_form;

void single_fits()
{
  std::vector<Kernel::Point_3> points;
  for (int i = 0; i < 128; ++i) {
    const double radius = 0.1 * std::sqrt(i / 128.), x = radius * std::cos(2.4 * i), y = radius * std::sin(2.4 * i);
    points.emplace_back(x, y, std::sin(3 * x + y));
  }
  for (std::size_t d = 1; d <= 4; ++d)
    for (std::size_t n : {(d + 1) * (d + 2) / 2, (d + 1) * (d + 2), std::size_t(128)}) {
      const std::string what = "d = " + text(d) + ", " + text(n) + " points";
      Single_fit fit;
      const std::size_t before = heap.blocks;
      const Form form = fit(points.begin(), points.begin() + std::ptrdiff_t(n), d, d);
      const double condition_number = fit.condition_number();
      const std::size_t blocks = heap.blocks - before;
      check_le(blocks, std::size_t(d >= 2), what + ": blocks allocated");
      check_ge(condition_number, 1., what + ": condition number");
    }
}

struct Use
{
  std::size_t blocks; // allocated by the call
  double bytes;       // at the worst moment, besides what is left at the end
};

Use use_of_mesh_door(std::size_t m, std::size_t n, std::size_t d, int rings)
{
  Mesh mesh;
  build(torus(1, 0.35, m, n), mesh);
  const auto forms = mesh.add_property_map<Vertex, Form>("v:form").first;
  const std::size_t before = heap.blocks;
  heap.most_bytes = heap.bytes;
  const auto summary = CGAL::estimate_vertex_monge_forms(mesh, k_rings(rings), forms,
                                                         CGAL::parameters::degree_fitting(d).degree_monge(d));
  check_equal(summary.estimated, m * n, "vertices estimated");
  return {heap.blocks - before, double(heap.most_bytes - heap.bytes)};
}

void mesh_door()
{
  for (std::size_t d : {2, 4}) {
    const std::size_t m = 200, n = 60, vertices = m * n;
    const Use small = use_of_mesh_door(m, n, d, d == 2 ? 2 : 3), large = use_of_mesh_door(3 * m, n, d, d == 2 ? 2 : 3);
    const std::string what = "mesh door, d = " + text(d);
    const std::size_t for_vectors_that_grow = 16;
    check_le(large.blocks - small.blocks, 2 * vertices + for_vectors_that_grow, what + ": blocks for more vertices");
    check_le((large.bytes - small.bytes) / double(2 * vertices), 64., what + ": bytes for one more vertex");
    std::cout << what << ": " << double(large.blocks) / double(3 * vertices) << " blocks and "
              << (large.bytes - small.bytes) / double(2 * vertices) << " bytes a vertex besides the output"
              << std::endl;
  }
}

// Before they are written forms are kept as plain numbers, which are given up in pieces of 32 MiB.
Use use_of_point_door(std::size_t size, std::size_t d)
{
  const double golden_angle = 2.399963;
  std::vector<Kernel::Point_3> points;
  for (std::size_t i = 0; i < size; ++i) {
    const double r = std::sqrt(double(i) / double(size)), t = golden_angle * double(i);
    points.emplace_back(r * std::cos(t), r * std::sin(t), r * r * std::cos(2 * t));
  }
  std::vector<Form> forms;
  forms.reserve(size);
  const std::size_t before = heap.blocks, bytes_before = heap.bytes;
  heap.most_bytes = heap.bytes;
  const auto summary = CGAL::estimate_point_monge_forms(points, nearest(20), std::back_inserter(forms),
                                                        CGAL::parameters::degree_fitting(d).degree_monge(d));
  check_equal(summary.estimated, size, "points estimated");
  const std::size_t coefficients = forms.front().coefficients().size();
  return {heap.blocks - before,
          double(heap.most_bytes - bytes_before) - double(size * (12 + coefficients) * sizeof(double))};
}

void point_door()
{
  const std::size_t points = 300000, d = 2;
  const Use small = use_of_point_door(points, d), large = use_of_point_door(3 * points, d);
  const std::size_t for_vectors_that_grow = 64;
  const double bytes = (large.bytes - small.bytes) / double(2 * points);
  check_le(large.blocks - small.blocks, 2 * points + for_vectors_that_grow, "point door: blocks for more points");
  check_le(bytes, 100., "point door: bytes for one more point");
  std::cout << "point door: " << double(large.blocks) / double(3 * points) << " blocks and " << bytes
            << " bytes a point besides the forms" << std::endl;
}

int main()
{
  single_fits();
  mesh_door();
  point_door();
  return result();
}
