// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_JET_FITTING_3_INTERNAL_MACHINE_PREFETCH_H
#define CGAL_JET_FITTING_3_INTERNAL_MACHINE_PREFETCH_H

#include <CGAL/license/Jet_fitting_3.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <memory>
#include <type_traits>

namespace CGAL {
namespace Jet_fitting {
namespace internal {

/// Prefetches the cache line at this address.
inline void prefetch(const void* address)
{
#ifdef __GNUC__
  __builtin_prefetch(address);
#else
  (void)address;
#endif
}

/// Prefetches the cache lines of so many bytes, at least one.
inline void prefetch(const void* address, std::size_t size)
{
  const std::size_t cache_line = 64;
  const char* const begin = static_cast<const char*>(address);
  for (std::size_t i = 0; i < size; i += cache_line) prefetch(begin + i);
  prefetch(begin + size - 1);
}

/// Prefetches the value of a key, if the map hands out references: others do not tell where their values are.
template <class PropertyMap, class Key>
void prefetch_value(const PropertyMap& map, const Key& key)
{
  using Traits = boost::property_traits<PropertyMap>;
  if constexpr (std::is_convertible<typename Traits::category, boost::lvalue_property_map_tag>::value &&
                std::is_lvalue_reference<typename Traits::reference>::value)
    prefetch(std::addressof(get(map, key)), sizeof(typename Traits::value_type));
}

} // namespace internal
} // namespace Jet_fitting
} // namespace CGAL

#endif // CGAL_JET_FITTING_3_INTERNAL_MACHINE_PREFETCH_H
