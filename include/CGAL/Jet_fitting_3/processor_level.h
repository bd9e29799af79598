// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_PROCESSOR_LEVEL_H
#define CGAL_JET_FITTING_3_PROCESSOR_LEVEL_H

#include <algorithm>
#include <cstdlib>
#include <type_traits>

/// \file
/// For programs that run on any x86-64 processor, and use the wide registers of those that have them. A source file is
/// compiled several times, for levels of the processor: 1, x86-64; 3, x86-64-v3, with AVX2; 4, x86-64-v4, with AVX-512.
/// The CMake function jet_fitting_3_compile_for_levels() does it; the manual has an example.

/// The level for which this file is compiled: 1, 3 or 4.
#ifndef CGAL_JET_FITTING_3_LEVEL
#define CGAL_JET_FITTING_3_LEVEL 1
#endif

/// In a file that is compiled several times: what this level calls a function.
#define CGAL_JET_FITTING_3_AT_LEVEL(name) CGAL_JET_FITTING_3_LEVEL_NAME(name, CGAL_JET_FITTING_3_LEVEL)
#define CGAL_JET_FITTING_3_LEVEL_NAME(name, level) CGAL_JET_FITTING_3_JOINED_NAME(name, level)
#define CGAL_JET_FITTING_3_JOINED_NAME(name, level) name##_level_##level

/// Declares the function of all levels.
/// \param parameters in parentheses
#define CGAL_JET_FITTING_3_DECLARE_LEVELS(result, name, parameters)                                                    \
  result name##_level_1 parameters;                                                                                    \
  result name##_level_3 parameters;                                                                                    \
  result name##_level_4 parameters

/// The function of the highest level that this processor has, and the program. Not for use before main().
#define CGAL_JET_FITTING_3_BEST_LEVEL(name)                                                                            \
  CGAL::Jet_fitting::best_level(&name##_level_1, CGAL_JET_FITTING_3_IF_LEVEL_3(&name##_level_3),                       \
                                CGAL_JET_FITTING_3_IF_LEVEL_4(&name##_level_4))

#ifdef CGAL_JET_FITTING_3_HAS_LEVEL_3
#define CGAL_JET_FITTING_3_IF_LEVEL_3(function) function
#else
#define CGAL_JET_FITTING_3_IF_LEVEL_3(function) nullptr
#endif
#ifdef CGAL_JET_FITTING_3_HAS_LEVEL_4
#define CGAL_JET_FITTING_3_IF_LEVEL_4(function) function
#else
#define CGAL_JET_FITTING_3_IF_LEVEL_4(function) nullptr
#endif

#if defined(CGAL_JET_FITTING_3_HAS_LEVEL_3) || defined(CGAL_JET_FITTING_3_HAS_LEVEL_4)
#define CGAL_JET_FITTING_3_HAS_LEVELS
#endif

#ifdef CGAL_JET_FITTING_3_HAS_LEVELS
extern "C" {
using cgal_jet_fitting_3_initializer = void (*)(int, char**, char**);
// The linker names where a section begins and where it ends, if there is any of this name.
extern const cgal_jet_fitting_3_initializer __start_cgal_jet_fitting_3_level_3[] __attribute__((weak)),
    __stop_cgal_jet_fitting_3_level_3[] __attribute__((weak)),
    __start_cgal_jet_fitting_3_level_4[] __attribute__((weak)),
    __stop_cgal_jet_fitting_3_level_4[] __attribute__((weak));
}
#endif

namespace CGAL {
namespace Jet_fitting {

/// The level of this processor: 4, 3 or 1, which stands for all others; less if the environment variable
/// CGAL_JET_FITTING_3_LEVEL says so.
inline int processor_level()
{
  int level = 1;
#ifdef CGAL_JET_FITTING_3_HAS_LEVELS
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
      __builtin_cpu_supports("bmi2"))
    level = 3;
  if (level == 3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
      __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
    level = 4;
#endif
  const char* const most = std::getenv("CGAL_JET_FITTING_3_LEVEL");
  return most == nullptr ? level : (std::min)(level, (std::max)(std::atoi(most), 1));
}

#ifdef CGAL_JET_FITTING_3_HAS_LEVELS
/// Of static objects in the files of a level: other processors must not run it, hence it is done when it is needed.
inline void initialize_level(int level)
{
  const auto run = [](const cgal_jet_fitting_3_initializer* begin, const cgal_jet_fitting_3_initializer* end) {
    std::for_each(begin, end, [](cgal_jet_fitting_3_initializer initialize) { initialize(0, nullptr, nullptr); });
    return true;
  };
  if (level == 3) {
    static const bool done = run(__start_cgal_jet_fitting_3_level_3, __stop_cgal_jet_fitting_3_level_3);
    (void)done;
  } else if (level == 4) {
    static const bool done = run(__start_cgal_jet_fitting_3_level_4, __stop_cgal_jet_fitting_3_level_4);
    (void)done;
  }
}
#endif

/// Of the functions of levels 1, 3 and 4, of which the latter two may be null.
template <class Function>
Function* best_level(Function* of_level_1, std::common_type_t<Function*> of_level_3,
                     std::common_type_t<Function*> of_level_4)
{
#ifdef CGAL_JET_FITTING_3_HAS_LEVELS
  static const int level = processor_level();
  if (level >= 4 && of_level_4 != nullptr) {
    initialize_level(4);
    return of_level_4;
  }
  if (level >= 3 && of_level_3 != nullptr) {
    initialize_level(3);
    return of_level_3;
  }
#endif
  (void)of_level_3;
  (void)of_level_4;
  return of_level_1;
}

} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_PROCESSOR_LEVEL_H
