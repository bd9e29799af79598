// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NUMERIC_PACK_H
#define CGAL_JET_FITTING_3_NUMERIC_PACK_H

#include <CGAL/Jet_fitting_3/numeric/native.h>
#include <CGAL/Jet_fitting_3/numeric/number.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

// Packs of GNU's vector extensions, or else of arrays; the latter can be asked for, to try them with GNU's compilers.
#if defined(__GNUC__) && !defined(CGAL_JET_FITTING_3_NO_VECTOR_EXTENSIONS)
#define CGAL_JET_FITTING_3_VECTOR_EXTENSIONS
#endif

#if defined(CGAL_JET_FITTING_3_VECTOR_EXTENSIONS) && defined(__SSE2__)
#include <immintrin.h>
#endif

namespace CGAL {
namespace Jet_fitting {
namespace numeric {
CGAL_JET_FITTING_3_BEGIN_NATIVE

/// Lanes of T that the target's widest register holds; 1 where it has none that we know of.
template <class T>
constexpr int native_lanes()
{
  constexpr int bytes = CGAL_JET_FITTING_3_REGISTER_BYTES;
  const bool is_hardware_type = std::is_same<T, double>::value || std::is_same<T, float>::value;
  return is_hardware_type && bytes > 0 ? bytes / int(sizeof(T)) : 1;
}

/// `lanes` values of T as the compiler's vector type, or as an array where it has none.
template <class T, int lanes>
struct Register_of
{
#if defined(CGAL_JET_FITTING_3_VECTOR_EXTENSIONS)
  using type __attribute__((vector_size(lanes * sizeof(T)))) = T;
#else
  struct type
  {
    T lane[lanes];
    T& operator[](int i) { return lane[i]; }
    const T& operator[](int i) const { return lane[i]; }
  };
#endif
};

/// The mask of a Pack: all bits of a lane are set where the comparison holds.
template <class T, int lanes>
class Pack_mask;

/// `lanes` numbers that take every step together: a number type for the steps, one vertex a lane.
template <class T, int lanes>
class Pack
{
public:
  using Register = typename Register_of<T, lanes>::type;

  Pack() = default;
  explicit Pack(Register r) : m(r) {}
  template <class Number, class = std::enable_if_t<std::is_arithmetic<Number>::value>>
  Pack(Number number) // implicit, as from double to a number type
  {
    const T value = static_cast<T>(number);
#if defined(CGAL_JET_FITTING_3_VECTOR_EXTENSIONS)
    m = value - Register{};
#else
    for (int i = 0; i < lanes; ++i) m[i] = value;
#endif
  }

  T operator[](int i) const { return m[i]; }
  void set(int i, T value) { m[i] = value; }
  Register native() const { return m; }

  static Pack load(const T* p)
  {
    Pack result;
    std::memcpy(&result.m, p, sizeof(Register));
    return result;
  }
  void store(T* p) const { std::memcpy(p, &m, sizeof(Register)); }

  /// lane(0), lane(1), ... side by side.
  template <class Lane>
  static Pack of_lanes(const Lane& lane)
  {
    return of_lanes(lane, std::make_integer_sequence<int, lanes>());
  }

#if defined(CGAL_JET_FITTING_3_VECTOR_EXTENSIONS)
  friend Pack operator+(Pack a, Pack b) { return Pack(a.m + b.m); }
  friend Pack operator-(Pack a, Pack b) { return Pack(a.m - b.m); }
  friend Pack operator*(Pack a, Pack b) { return Pack(a.m * b.m); }
  friend Pack operator/(Pack a, Pack b) { return Pack(a.m / b.m); }
  friend Pack operator-(Pack a) { return Pack(-a.m); }
  friend auto operator<(Pack a, Pack b) { return Pack_mask<T, lanes>(a.m < b.m); }
  friend auto operator>(Pack a, Pack b) { return Pack_mask<T, lanes>(a.m > b.m); }
  friend auto operator==(Pack a, Pack b) { return Pack_mask<T, lanes>(a.m == b.m); }
#else
  friend Pack operator+(Pack a, const Pack& b)
  {
    return a.apply(b, [](T s, T t) { return s + t; });
  }
  friend Pack operator-(Pack a, const Pack& b)
  {
    return a.apply(b, [](T s, T t) { return s - t; });
  }
  friend Pack operator*(Pack a, const Pack& b)
  {
    return a.apply(b, [](T s, T t) { return s * t; });
  }
  friend Pack operator/(Pack a, const Pack& b)
  {
    return a.apply(b, [](T s, T t) { return s / t; });
  }
  friend Pack operator-(Pack a)
  {
    return a.apply(a, [](T s, T) { return -s; }); // not 0 - s, which loses the sign of 0
  }
  friend auto operator<(const Pack& a, const Pack& b)
  {
    return a.compare(b, [](T s, T t) { return s < t; });
  }
  friend auto operator>(const Pack& a, const Pack& b)
  {
    return a.compare(b, [](T s, T t) { return s > t; });
  }
  friend auto operator==(const Pack& a, const Pack& b)
  {
    return a.compare(b, [](T s, T t) { return s == t; });
  }
#endif

private:
  template <class Lane, int... i>
  static Pack of_lanes(const Lane& lane, std::integer_sequence<int, i...>)
  {
    return Pack(Register{lane(i)...});
  }

#if !defined(CGAL_JET_FITTING_3_VECTOR_EXTENSIONS)
  template <class F>
  Pack& apply(const Pack& b, F f)
  {
    for (int i = 0; i < lanes; ++i) m[i] = f(m[i], b[i]);
    return *this;
  }
  template <class F>
  Pack_mask<T, lanes> compare(const Pack& b, F f) const
  {
    typename Pack_mask<T, lanes>::Register r;
    for (int i = 0; i < lanes; ++i) r[i] = f(m[i], b[i]) ? -1 : 0;
    return Pack_mask<T, lanes>(r);
  }
#endif
  Register m;
};

template <class T, int lanes>
class Pack_mask
{
public:
  using Integer = std::conditional_t<sizeof(T) == 8, long long, int>;
  using Register = typename Register_of<Integer, lanes>::type;

  template <class Comparison>
  explicit Pack_mask(const Comparison& r)
  {
    static_assert(sizeof(r) == sizeof(Register), "a comparison of packs has one integer a lane");
    std::memcpy(&m, &r, sizeof(Register));
  }

  bool operator[](int i) const { return m[i] != 0; }
  Register native() const { return m; }

#if defined(CGAL_JET_FITTING_3_VECTOR_EXTENSIONS)
  friend Pack_mask operator&(Pack_mask a, Pack_mask b) { return Pack_mask(a.m & b.m); }
  friend Pack_mask operator|(Pack_mask a, Pack_mask b) { return Pack_mask(a.m | b.m); }
  friend Pack_mask operator!(Pack_mask a) { return Pack_mask(~a.m); }
#else
  friend Pack_mask operator&(Pack_mask a, const Pack_mask& b)
  {
    for (int i = 0; i < lanes; ++i) a.m[i] &= b.m[i];
    return a;
  }
  friend Pack_mask operator|(Pack_mask a, const Pack_mask& b)
  {
    for (int i = 0; i < lanes; ++i) a.m[i] |= b.m[i];
    return a;
  }
  friend Pack_mask operator!(Pack_mask a)
  {
    for (int i = 0; i < lanes; ++i) a.m[i] = ~a.m[i];
    return a;
  }
#endif

private:
  Register m;
};

template <class T, int lanes>
bool any(const Pack_mask<T, lanes>& mask)
{
#if defined(CGAL_JET_FITTING_3_VECTOR_EXTENSIONS) && defined(__SSE2__)
  const auto bits = mask.native();
  if constexpr (sizeof(bits) == 16) return _mm_movemask_epi8(reinterpret_cast<__m128i>(bits)) != 0;
#if defined(__AVX__)
  if constexpr (sizeof(bits) == 32)
    return !_mm256_testz_si256(reinterpret_cast<__m256i>(bits), reinterpret_cast<__m256i>(bits));
#endif
#if defined(__AVX512F__)
  if constexpr (sizeof(bits) == 64)
    return _mm512_test_epi64_mask(reinterpret_cast<__m512i>(bits), reinterpret_cast<__m512i>(bits)) != 0;
#endif
#endif
  bool result = false;
  for (int i = 0; i < lanes; ++i) result = result || mask[i];
  return result;
}

template <class T, int lanes>
bool all(const Pack_mask<T, lanes>& mask)
{
  return !any(!mask);
}

template <class T, int lanes>
Pack<T, lanes> select_lanes(const Pack_mask<T, lanes>& mask, const Pack<T, lanes>& if_true,
                            const Pack<T, lanes>& if_false)
{
#if defined(CGAL_JET_FITTING_3_VECTOR_EXTENSIONS)
  return Pack<T, lanes>(mask.native() ? if_true.native() : if_false.native());
#else
  Pack<T, lanes> result = if_false;
  for (int i = 0; i < lanes; ++i)
    if (mask[i]) result.set(i, if_true[i]);
  return result;
#endif
}

template <class T, int lanes>
Pack<T, lanes> abs(const Pack<T, lanes>& x)
{
#if defined(CGAL_JET_FITTING_3_VECTOR_EXTENSIONS)
  using Bits = typename Pack_mask<T, lanes>::Register;
  const Bits sign = reinterpret_cast<Bits>(Pack<T, lanes>(-0.0).native());
  return Pack<T, lanes>(
      reinterpret_cast<typename Pack<T, lanes>::Register>(reinterpret_cast<Bits>(x.native()) & ~sign));
#else
  Pack<T, lanes> result = x;
  for (int i = 0; i < lanes; ++i) result.set(i, std::abs(x[i]));
  return result;
#endif
}

template <class T, int lanes>
Pack<T, lanes> sqrt(const Pack<T, lanes>& x)
{
  Pack<T, lanes> result = x;
  for (int i = 0; i < lanes; ++i) result.set(i, std::sqrt(x[i]));
  return result;
}

// compilers do not make one instruction of the loop above, since std::sqrt may set errno
#if defined(CGAL_JET_FITTING_3_VECTOR_EXTENSIONS) && defined(__SSE2__)
inline Pack<double, 2> sqrt(const Pack<double, 2>& x) { return Pack<double, 2>(_mm_sqrt_pd(x.native())); }
inline Pack<float, 4> sqrt(const Pack<float, 4>& x) { return Pack<float, 4>(_mm_sqrt_ps(x.native())); }
#endif
#if defined(CGAL_JET_FITTING_3_VECTOR_EXTENSIONS) && defined(__AVX__)
inline Pack<double, 4> sqrt(const Pack<double, 4>& x) { return Pack<double, 4>(_mm256_sqrt_pd(x.native())); }
inline Pack<float, 8> sqrt(const Pack<float, 8>& x) { return Pack<float, 8>(_mm256_sqrt_ps(x.native())); }
#endif
#if defined(CGAL_JET_FITTING_3_VECTOR_EXTENSIONS) && defined(__AVX512F__)
// With a mask of all lanes: g++ 12 warns of an uninitialized variable in its own functions without masks.
inline Pack<double, 8> sqrt(const Pack<double, 8>& x)
{
  return Pack<double, 8>(_mm512_maskz_sqrt_pd(0xff, x.native()));
}
inline Pack<float, 16> sqrt(const Pack<float, 16>& x)
{
  return Pack<float, 16>(_mm512_maskz_sqrt_ps(0xffff, x.native()));
}
#endif

template <class T, int lanes>
T sum_of_lanes(const Pack<T, lanes>& x)
{
  T sum = x[0];
  for (int i = 1; i < lanes; ++i) sum += x[i];
  return sum;
}

template <class T, int lanes>
T largest_lane(const Pack<T, lanes>& x)
{
  T result = x[0];
  for (int i = 1; i < lanes; ++i) result = larger(result, x[i]);
  return result;
}

template <class T, int lanes>
struct Lanes<Pack<T, lanes>>
{
  using Number = T;
  static constexpr int count = lanes;
  static T get(const Pack<T, lanes>& x, int i) { return x[i]; }
  static void set(Pack<T, lanes>& x, int i, T value) { x.set(i, value); }
};

template <class T, int lanes>
Pack<T, lanes> power_of_two_above_lanes(const Pack<T, lanes>& x)
{
#if defined(CGAL_JET_FITTING_3_VECTOR_EXTENSIONS)
  // as for one double: the next exponent, read from the bits
  if constexpr (std::is_same<T, double>::value && std::numeric_limits<double>::is_iec559)
    if (all((x > Pack<T, lanes>(0x1p-1000)) & (x < Pack<T, lanes>(0x1p1000)))) {
      using Bits = typename Pack_mask<T, lanes>::Register;
      const Bits bits = (reinterpret_cast<Bits>(x.native()) & 0x7ff0000000000000) + 0x0010000000000000;
      return Pack<T, lanes>(reinterpret_cast<typename Pack<T, lanes>::Register>(bits));
    }
#endif
  return by_lane(x, [](const T& number) { return power_of_two_above(number); });
}

#if defined(CGAL_JET_FITTING_3_VECTOR_EXTENSIONS)
template <int lanes>
Pack<double, lanes> inverse_of_power_of_two(const Pack<double, lanes>& p)
{
  if (!std::numeric_limits<double>::is_iec559) return Pack<double, lanes>(1) / p;
  using Bits = typename Pack_mask<double, lanes>::Register;
  const Bits bits = 0x7fe0000000000000 - reinterpret_cast<Bits>(p.native());
  return Pack<double, lanes>(reinterpret_cast<typename Pack<double, lanes>::Register>(bits));
}
#endif

CGAL_JET_FITTING_3_END_NATIVE
} // namespace numeric
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_NUMERIC_PACK_H
