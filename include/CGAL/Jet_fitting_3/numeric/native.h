// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_NUMERIC_NATIVE_H
#define CGAL_JET_FITTING_3_NUMERIC_NATIVE_H

/// \file
/// What the compiler's flags decide. Code that depends on the vector registers lies in an inline namespace named after
/// them. So files compiled with different flags (-march=native and none, say) may be linked into one program: each uses
/// its own instances of all templates. Forms, statuses, summaries and options lie outside, and are the same for all.

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#error "Jet_fitting_3 tells infinities and NaN from numbers: compile without -ffast-math and -ffinite-math-only."
#endif

#if defined(CGAL_JET_FITTING_3_NO_VECTOR_EXTENSIONS) // packs are arrays, as for compilers without vector types
#define CGAL_JET_FITTING_3_REGISTER_BYTES 16
#define CGAL_JET_FITTING_3_NATIVE native_arrays
#elif defined(__AVX512F__)
#define CGAL_JET_FITTING_3_REGISTER_BYTES 64
#define CGAL_JET_FITTING_3_NATIVE native_avx512
#elif defined(__AVX__) && defined(__FMA__)
#define CGAL_JET_FITTING_3_REGISTER_BYTES 32
#define CGAL_JET_FITTING_3_NATIVE native_avx_fma
#elif defined(__AVX__)
#define CGAL_JET_FITTING_3_REGISTER_BYTES 32
#define CGAL_JET_FITTING_3_NATIVE native_avx
#elif defined(__SSE2__) || defined(__ARM_NEON)
#define CGAL_JET_FITTING_3_REGISTER_BYTES 16
#define CGAL_JET_FITTING_3_NATIVE native_128
#else
#define CGAL_JET_FITTING_3_REGISTER_BYTES 0
#define CGAL_JET_FITTING_3_NATIVE native_scalar
#endif

#define CGAL_JET_FITTING_3_BEGIN_NATIVE inline namespace CGAL_JET_FITTING_3_NATIVE {
#define CGAL_JET_FITTING_3_END_NATIVE }

#endif // CGAL_JET_FITTING_3_NUMERIC_NATIVE_H
