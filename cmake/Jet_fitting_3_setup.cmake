# What the folders examples/, test/ and benchmark/ share, whether they are configured alone or by the top CMakeLists.txt:
# the libraries found on this machine, the targets of the package, compiler options, and how a program is declared.
#
# CGAL::Jet_fitting_3_core   our headers alone: enough for the stand-alone class
# CGAL::Jet_fitting_3        our headers before CGAL's own, with CGAL and Eigen where they are found
# CGAL::Lapacke_support      what CGAL::Lapack_svd needs, where LAPACKE is found

include_guard(GLOBAL)

get_filename_component(JET_FITTING_3_ROOT "${CMAKE_CURRENT_LIST_DIR}" DIRECTORY)
list(APPEND CMAKE_MODULE_PATH "${JET_FITTING_3_ROOT}/cmake")

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release, RelWithDebInfo or MinSizeRel" FORCE)
endif()
if(NOT CMAKE_CXX_STANDARD)
  set(CMAKE_CXX_STANDARD 17)
endif()
set(CMAKE_CXX_EXTENSIONS OFF)

option(JET_FITTING_3_NATIVE "Compile for the processor of this machine (-march=native)" OFF)
option(JET_FITTING_3_WARNINGS_AS_ERRORS "A warning in our headers or programs stops the build" OFF)
set(JET_FITTING_3_SANITIZE "" CACHE STRING "Sanitizers of the programs, as in -fsanitize=: address,undefined or thread")

if(JET_FITTING_3_NATIVE)
  add_compile_options(-march=native)
endif()
if(JET_FITTING_3_SANITIZE)
  add_compile_options(-fsanitize=${JET_FITTING_3_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${JET_FITTING_3_SANITIZE})
endif()

include(unpack_cgal_demo)
include(Jet_fitting_3_levels)
set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE ON)
find_package(CGAL QUIET)
set(jet_fitting_3_cgal_version "${CGAL_VERSION}" CACHE INTERNAL "Version of the CGAL that was found")
find_package(Eigen3 QUIET)
include(CGAL_Eigen3_support OPTIONAL)
find_package(TBB QUIET)
include(CGAL_TBB_support OPTIONAL)
find_package(LAPACKE QUIET)
find_package(Boost QUIET OPTIONAL_COMPONENTS program_options)

add_library(Jet_fitting_3_core INTERFACE)
add_library(CGAL::Jet_fitting_3_core ALIAS Jet_fitting_3_core)
target_compile_features(Jet_fitting_3_core INTERFACE cxx_std_17)
target_include_directories(Jet_fitting_3_core INTERFACE
  "$<BUILD_INTERFACE:${JET_FITTING_3_ROOT}/include>" "$<INSTALL_INTERFACE:include/Jet_fitting_3>")

add_library(Jet_fitting_3 INTERFACE)
add_library(CGAL::Jet_fitting_3 ALIAS Jet_fitting_3)
target_link_libraries(Jet_fitting_3 INTERFACE Jet_fitting_3_core)
# Not exported: find_package(Jet_fitting_3) finds these again on the machine of the user.
foreach(library IN ITEMS CGAL::CGAL CGAL::Data CGAL::Eigen3_support)
  if(TARGET ${library})
    target_link_libraries(Jet_fitting_3 INTERFACE "$<BUILD_INTERFACE:${library}>")
  else()
    message(STATUS "NOTICE: ${library} is not found: the programs that need it are left out.")
  endif()
endforeach()

# jet_fitting_3_add_program(<target> <source> [CORE] [STRICT] [REQUIRES <library>...] [USES <library>...])
#   declares an executable, linked with CGAL::Jet_fitting_3 (CORE: with our headers alone, CGAL may be missing), with the
#   required libraries and with those of the used ones that are found; leaves it out with a notice where a required one
#   is missing. STRICT turns on the warnings that our headers are to be free of.
function(jet_fitting_3_add_program target source)
  cmake_parse_arguments(PARSE_ARGV 2 program "CORE;STRICT" "" "REQUIRES;USES")
  if(NOT program_CORE)
    list(PREPEND program_REQUIRES CGAL::CGAL CGAL::Eigen3_support)
  endif()
  foreach(library IN LISTS program_REQUIRES)
    if(NOT TARGET ${library})
      message(STATUS "NOTICE: ${source} needs ${library} and will not be compiled.")
      return()
    endif()
  endforeach()
  add_executable(${target} ${source})
  if(program_CORE)
    target_link_libraries(${target} PRIVATE CGAL::Jet_fitting_3_core)
  else()
    target_link_libraries(${target} PRIVATE CGAL::Jet_fitting_3 ${program_REQUIRES})
  endif()
  foreach(library IN LISTS program_USES)
    if(TARGET ${library})
      target_link_libraries(${target} PRIVATE ${library})
    endif()
  endforeach()
  if(program_STRICT)
    # clang counts changes of sign as conversions, g++ does not: test source_hygiene_headers asks for them in our headers.
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion)
  endif()
  if(JET_FITTING_3_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()
