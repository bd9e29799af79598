// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEST_JET_FITTING_3_ARCHETYPES_H
#define CGAL_TEST_JET_FITTING_3_ARCHETYPES_H

#include "reference_fit.h"

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

// The least that a model of each concept may offer: what the reference manual lists, and nothing else.
namespace archetype {

// A data number: +, binary and unary -, <, and a constructor from int; * for comply_wrt_given_normal().
class Data_number
{
public:
  explicit Data_number(int n) : m_value(n) {}
  static Data_number of(double value)
  {
    Data_number x(0);
    x.m_value = value;
    return x;
  }
  friend Data_number operator+(const Data_number& a, const Data_number& b) { return of(a.m_value + b.m_value); }
  friend Data_number operator-(const Data_number& a, const Data_number& b) { return of(a.m_value - b.m_value); }
  friend Data_number operator-(const Data_number& a) { return of(-a.m_value); }
  friend Data_number operator*(const Data_number& a, const Data_number& b) { return of(a.m_value * b.m_value); }
  friend bool operator<(const Data_number& a, const Data_number& b) { return a.m_value < b.m_value; }
  friend double value_of(const Data_number& a) { return a.m_value; }

private:
  double m_value;
};

// The number type of the steps: see numeric/number.h.
class Number
{
public:
  Number() {}
  Number(int n) : m_value(n) {}
  Number(double x) : m_value(x) {}
  explicit operator double() const { return m_value; }
  friend Number operator+(const Number& a, const Number& b) { return Number(a.m_value + b.m_value); }
  friend Number operator-(const Number& a, const Number& b) { return Number(a.m_value - b.m_value); }
  friend Number operator*(const Number& a, const Number& b) { return Number(a.m_value * b.m_value); }
  friend Number operator/(const Number& a, const Number& b) { return Number(a.m_value / b.m_value); }
  friend Number operator-(const Number& a) { return Number(-a.m_value); }
  friend bool operator<(const Number& a, const Number& b) { return a.m_value < b.m_value; }
  friend bool operator>(const Number& a, const Number& b) { return a.m_value > b.m_value; }
  friend bool operator==(const Number& a, const Number& b) { return a.m_value == b.m_value; }
  friend Number sqrt(const Number& a) { return Number(std::sqrt(a.m_value)); }
  friend Number exp(const Number& a) { return Number(std::exp(a.m_value)); }
  friend Number abs(const Number& a) { return Number(std::abs(a.m_value)); }
  friend double value_of(const Number& a) { return a.m_value; }

private:
  double m_value;
};

inline double value_of(double x) { return x; }

} // namespace archetype

template <>
class std::numeric_limits<archetype::Number> : public std::numeric_limits<double>
{
public:
  static archetype::Number epsilon() { return std::numeric_limits<double>::epsilon(); }
  static archetype::Number infinity() { return std::numeric_limits<double>::infinity(); }
};

namespace archetype {

// A point or a vector: from three numbers, x(), y(), z(), copies.
template <class FT>
class Triple
{
public:
  Triple(const FT& x, const FT& y, const FT& z) : m_x(x), m_y(y), m_z(z) {}
  FT x() const { return m_x; }
  FT y() const { return m_y; }
  FT z() const { return m_z; }

private:
  FT m_x, m_y, m_z;
};

struct Data_kernel
{
  using FT = Data_number;
  class Point_3 : public Triple<FT>
  {
    using Triple<FT>::Triple;
  };
  class Vector_3 : public Triple<FT>
  {
    using Triple<FT>::Triple;
  };
};

struct Local_kernel
{
  using FT = Number;
  class Point_3;
  class Vector_3 : public Triple<FT>
  {
    using Triple<FT>::Triple;
  };
};

struct Converters
{
  struct D2L_converter
  {
    Number operator()(const Data_number& x) const { return Number(value_of(x)); }
  };
  struct L2D_converter
  {
    Data_number operator()(const Number& x) const { return Data_number::of(value_of(x)); }
  };
};

// SvdTraits: only set() of the matrix, only set() and operator() of the vector, besides solve().
template <class NumberType>
class Svd_traits_for
{
public:
  using FT = NumberType;

  class Vector
  {
  public:
    explicit Vector(std::size_t n) : m_entries(n) {}
    FT operator()(std::size_t i) const { return FT(m_entries[i]); }
    void set(std::size_t i, const FT& x) { m_entries[i] = value_of(x); }

  private:
    friend class Svd_traits_for;
    std::vector<double> m_entries;
  };

  class Matrix
  {
  public:
    Matrix(std::size_t rows, std::size_t columns) : m_columns(columns, std::vector<double>(rows)) {}
    void set(std::size_t i, std::size_t j, const FT& x) { m_columns[j][i] = value_of(x); }

  private:
    friend class Svd_traits_for;
    std::vector<std::vector<double>> m_columns;
  };

  static FT solve(const Matrix& m, Vector& b)
  {
    auto columns = m.m_columns;
    std::vector<double> z = b.m_entries;
    const std::vector<double> x = test::least_squares(columns, z);
    for (std::size_t j = 0; j < x.size(); ++j) b.m_entries[j] = x[j];
    return FT(321.);
  }
};

using Svd_traits = Svd_traits_for<Number>;
using Double_svd_traits = Svd_traits_for<double>;

// Property maps that can be read, or written, and nothing else.
template <class Key, class Value>
class Readable_map
{
public:
  using key_type = Key;
  using value_type = Value;
  using reference = Value;
  using category = boost::readable_property_map_tag;

  explicit Readable_map(std::vector<Value> values) : m_values(std::move(values)) {}
  friend Value get(const Readable_map& map, const Key& key) { return map.m_values[std::size_t(key)]; }

private:
  std::vector<Value> m_values;
};

template <class Key, class Value>
class Writable_map
{
public:
  using key_type = Key;
  using value_type = Value;
  using reference = void;
  using category = boost::writable_property_map_tag;

  explicit Writable_map(std::vector<Value>& values) : m_values(&values) {}
  friend void put(const Writable_map& map, const Key& key, const Value& value)
  {
    (*map.m_values)[std::size_t(key)] = value;
  }

private:
  std::vector<Value>* m_values;
};

template <class Item, class Point>
struct Point_of_item
{
  using key_type = Item;
  using value_type = Point;
  using reference = Point;
  using category = boost::readable_property_map_tag;
  const std::vector<Point>* points;
  friend Point get(const Point_of_item& map, const Item& item) { return (*map.points)[std::size_t(item.number)]; }
};

template <class Item, class Value>
struct Constant_map
{
  using key_type = Item;
  using value_type = Value;
  using reference = Value;
  using category = boost::readable_property_map_tag;
  Value value;
  friend Value get(const Constant_map& map, const Item&) { return map.value; }
};

struct Callback
{
  bool operator()(double) const { return true; }
};

struct Quantity
{
  template <class Form>
  double operator()(const Form& form) const
  {
    return form.principal_curvatures(0) - form.principal_curvatures(1);
  }
};

// *output++ = value, and copies.
template <class Function>
class Output_iterator
{
public:
  explicit Output_iterator(Function function) : m_function(std::move(function)) {}
  Output_iterator& operator*() { return *this; }
  Output_iterator& operator++(int) { return *this; }
  template <class Value>
  void operator=(const Value& value)
  {
    m_function(value);
  }

private:
  Function m_function;
};

template <class Function>
Output_iterator<Function> output_iterator(Function function)
{
  return Output_iterator<Function>(std::move(function));
}

} // namespace archetype

#endif // CGAL_TEST_JET_FITTING_3_ARCHETYPES_H
