// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Compares two outputs of one program: the text between the numbers must be the same, the numbers must agree to a
// relative tolerance, where frames count as equal up to the signs that the manual leaves open.
//
//   compare_outputs numbers|normals|directions|form <tolerance> <file> <file>
//
// numbers     relative to the largest number of the line; lines that tell a time or memory are compared as text only
// normals     lines "x y z nx ny nz", n up to its sign
// directions  lines of Mesh_estimation: point, origin, d1, d2 (both scaled), k1, k2; the mesh fixes the sign of the
// normal form        the output of Single_estimation: a Monge form, the condition number (not compared: its scaling is
//             ours, and of a singular matrix ours is infinite, CGAL's 1e17), PCA
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Numbers = std::vector<double>;
using Vec = std::array<double, 3>;
using Tensor = std::array<double, 9>;

struct Line
{
  std::string text; // with # in the place of each number
  Numbers numbers;
};

bool starts_number(const std::string& line, std::size_t i)
{
  const auto at = [&](std::size_t j) { return static_cast<unsigned char>(j < line.size() ? line[j] : ' '); };
  if (i > 0 && (std::isalnum(at(i - 1)) || at(i - 1) == '_' || at(i - 1) == '.')) return false;
  std::size_t j = i;
  if (at(j) == '-' || at(j) == '+') ++j;
  if (at(j) == '.') ++j;
  return std::isdigit(at(j)) != 0 || (line.compare(j, 3, "inf") == 0 && !std::isalnum(at(j + 3)));
}

Line parse(const std::string& line)
{
  Line parsed;
  for (std::size_t i = 0; i < line.size();) {
    if (!starts_number(line, i)) {
      parsed.text += line[i++];
      continue;
    }
    char* end = nullptr;
    parsed.numbers.push_back(std::strtod(line.c_str() + i, &end));
    parsed.text += '#';
    i = static_cast<std::size_t>(end - line.c_str());
  }
  return parsed;
}

std::vector<Line> read(const char* name)
{
  std::ifstream in(name);
  if (!in) throw std::runtime_error(std::string("cannot read ") + name);
  std::vector<Line> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(parse(line));
  if (lines.empty()) throw std::runtime_error(std::string("nothing in ") + name);
  return lines;
}

double largest(const double* begin, std::size_t n)
{
  double m = 0;
  for (std::size_t i = 0; i < n; ++i) m = std::max(m, std::abs(begin[i]));
  return m;
}

double dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vec times(double s, const Vec& a) { return {s * a[0], s * a[1], s * a[2]}; }

Vec cross(const Vec& a, const Vec& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vec vec(const Numbers& numbers, std::size_t first = 0)
{
  return {numbers.at(first), numbers.at(first + 1), numbers.at(first + 2)};
}

void add_square(Tensor& sum, double weight, const Vec& v)
{
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) sum[3 * i + j] += weight * v[i] * v[j];
}

class Comparison
{
public:
  explicit Comparison(double tolerance) : m_tolerance(tolerance) {}

  void texts(std::size_t line, const std::string& a, const std::string& b)
  {
    if (a != b && ++m_failures <= max_printed)
      std::printf("line %zu: text '%s' became '%s'\n", line + 1, a.c_str(), b.c_str());
  }

  void numbers(std::size_t line, const char* what, const double* a, const double* b, std::size_t n, double scale)
  {
    m_compared += n;
    for (std::size_t i = 0; i < n; ++i) {
      const double error = a[i] == b[i] ? 0 : std::abs(a[i] - b[i]) / scale;
      m_worst = std::max(m_worst, error);
      if (!(error <= m_tolerance) && ++m_failures <= max_printed)
        std::printf("line %zu: %s: %.17g became %.17g, %.3g of %.3g\n", line + 1, what, a[i], b[i], error, scale);
    }
  }

  template <class Values>
  void numbers(std::size_t line, const char* what, const Values& a, const Values& b)
  {
    numbers(line, what, a.data(), b.data(), a.size(),
            std::max(largest(a.data(), a.size()), largest(b.data(), b.size())));
  }

  bool report() const
  {
    std::printf("%zu numbers, largest deviation %.3g (tolerance %.3g), %zu failures\n", m_compared, m_worst,
                m_tolerance, m_failures);
    return m_failures == 0 && m_compared > 0;
  }

private:
  static constexpr std::size_t max_printed = 10;
  double m_tolerance;
  double m_worst = 0;
  std::size_t m_compared = 0;
  std::size_t m_failures = 0;
};

bool tells_cost(const std::string& text)
{
  for (const char* word : {" sec", "Mb", "MiB"})
    if (text.find(word) != std::string::npos) return true;
  return false;
}

void compare_numbers(Comparison& comparison, std::size_t line, const Line& a, const Line& b)
{
  if (!tells_cost(a.text)) comparison.numbers(line, "number", a.numbers, b.numbers);
}

void compare_normals(Comparison& comparison, std::size_t line, const Line& a, const Line& b)
{
  if (a.numbers.size() != 6) return compare_numbers(comparison, line, a, b);
  const Vec n = vec(a.numbers, 3);
  const Vec m = vec(b.numbers, 3);
  comparison.numbers(line, "point", vec(a.numbers), vec(b.numbers));
  comparison.numbers(line, "normal", n, times(dot(n, m) < 0 ? -1 : 1, m));
}

struct Curvature_frame
{
  Vec normal;
  Tensor shape{}; // k1 d1 d1^T + k2 d2 d2^T: unlike d1 and d2 it is well determined at an umbilic, too
  std::array<double, 2> lengths;

  explicit Curvature_frame(const Numbers& numbers)
  {
    const Vec v1 = vec(numbers, 6);
    const Vec v2 = vec(numbers, 9);
    lengths = {std::sqrt(dot(v1, v1)), std::sqrt(dot(v2, v2))};
    const Vec d1 = times(1 / lengths[0], v1);
    const Vec d2 = times(1 / lengths[1], v2);
    normal = cross(d1, d2);
    add_square(shape, numbers[12], d1);
    add_square(shape, numbers[13], d2);
  }
};

void compare_directions(Comparison& comparison, std::size_t line, const Line& a, const Line& b)
{
  if (a.numbers.size() != 14)
    throw std::runtime_error("line " + std::to_string(line + 1) + " does not hold 14 numbers");
  const Curvature_frame fa(a.numbers);
  const Curvature_frame fb(b.numbers);
  comparison.numbers(line, "point", vec(a.numbers), vec(b.numbers));
  comparison.numbers(line, "origin", vec(a.numbers, 3), vec(b.numbers, 3));
  comparison.numbers(line, "normal", fa.normal, fb.normal);
  comparison.numbers(line, "lengths of the directions", fa.lengths, fb.lengths);
  comparison.numbers(line, "principal curvatures", Numbers(a.numbers.begin() + 12, a.numbers.end()),
                     Numbers(b.numbers.begin() + 12, b.numbers.end()));
  comparison.numbers(line, "shape operator", fa.shape, fb.shape);
}

// The Monge form and the PCA that Single_estimation prints.
struct Form
{
  Vec origin{}, n{}, d1{}, d2{};
  std::array<Numbers, 5> order; // order[2] = k1 k2, order[3] = b0..b3, order[4] = c0..c4
  Tensor covariance{};

  explicit Form(const std::vector<Line>& lines)
  {
    const std::map<std::string, Vec*> vectors{{"origin", &origin}, {"n", &n}, {"d1", &d1}, {"d2", &d2}};
    const std::map<char, std::size_t> orders{{'k', 2}, {'b', 3}, {'c', 4}};
    for (const Line& line : lines) {
      const std::string label = line.text.substr(0, line.text.find(" :"));
      if (const auto v = vectors.find(label); v != vectors.end()) *v->second = vec(line.numbers);
      else if (const auto o = orders.find(label[0]); o != orders.end() && label.size() == 2)
        order[o->second].push_back(line.numbers.at(0));
    }
    for (std::size_t i = lines.size() - 6; i < lines.size(); i += 2)
      add_square(covariance, lines[i].numbers.at(0), vec(lines[i + 1].numbers));
  }

  // (d1, d2, n) becomes (d2, d1, -n): each order is read backwards and negated.
  void turn_normal()
  {
    n = times(-1, n);
    std::swap(d1, d2);
    for (Numbers& coefficients : order) {
      std::reverse(coefficients.begin(), coefficients.end());
      for (double& c : coefficients) c = -c;
    }
  }

  // (d1, d2) becomes (-d1, -d2): odd orders change sign.
  void turn_directions()
  {
    d1 = times(-1, d1);
    d2 = times(-1, d2);
    for (double& b : order[3]) b = -b;
  }
};

void compare_forms(Comparison& comparison, const std::vector<Line>& lines_a, const std::vector<Line>& lines_b)
{
  const Form a(lines_a);
  Form b(lines_b);
  if (dot(a.n, b.n) < 0) b.turn_normal();
  if (dot(a.d1, b.d1) < 0) b.turn_directions();
  const double k = largest(a.order[2].data(), 2);
  comparison.numbers(0, "origin", a.origin.data(), b.origin.data(), 3, 1 / k);
  comparison.numbers(0, "n", a.n, b.n);
  comparison.numbers(0, "d1", a.d1, b.d1);
  comparison.numbers(0, "d2", a.d2, b.d2);
  for (std::size_t degree = 2; degree <= 4; ++degree) {
    const Numbers& ca = a.order[degree];
    // 1/k is the length unit of the surface: an order that vanishes is judged by it.
    const double scale = std::max(largest(ca.data(), ca.size()), std::pow(k, double(degree) - 1));
    comparison.numbers(0, "coefficient", ca.data(), b.order[degree].data(), ca.size(), scale);
  }
  comparison.numbers(0, "covariance", a.covariance, b.covariance);
}

using Compare_line = void (*)(Comparison&, std::size_t, const Line&, const Line&);

bool compare(const std::string& kind, double tolerance, const std::vector<Line>& a, const std::vector<Line>& b)
{
  const std::map<std::string, Compare_line> by_line{{"numbers", &compare_numbers},
                                                    {"normals", &compare_normals},
                                                    {"directions", &compare_directions}};
  if (a.size() != b.size())
    throw std::runtime_error(std::to_string(a.size()) + " lines became " + std::to_string(b.size()));
  Comparison comparison(tolerance);
  for (std::size_t i = 0; i < a.size(); ++i) {
    comparison.texts(i, a[i].text, b[i].text);
    if (kind != "form" && a[i].text == b[i].text) by_line.at(kind)(comparison, i, a[i], b[i]);
  }
  if (kind == "form") compare_forms(comparison, a, b);
  return comparison.report();
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc != 5) {
    std::fprintf(stderr, "usage: compare_outputs numbers|normals|directions|form <tolerance> <file> <file>\n");
    return 2;
  }
  try {
    return compare(argv[1], std::atof(argv[2]), read(argv[3]), read(argv[4])) ? 0 : 1;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "compare_outputs: %s\n", e.what());
    return 1;
  }
}
