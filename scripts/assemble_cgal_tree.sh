#!/bin/sh
# Assembles the package as it would stand in CGAL's own tree, where every package has a folder with the same parts:
#   include/ examples/ demo/ test/ benchmark/ doc/ package_info/   ->  <tree>/Jet_fitting_3/...
#   cmake/FindLAPACKE.cmake                                  ->  <tree>/Installation/cmake/modules/
#   CHANGES.md                                               ->  an entry of <tree>/Installation/CHANGES.md
#   doc/.../Jet_fitting_3.txt, the bibliography at its end   ->  <tree>/Documentation/doc/biblio/, see CONTRIBUTING.md
# The CMakeLists.txt of examples, demo and tests are written anew, with CGAL's own commands. The tests of this repository that
# CGAL's testsuite makes itself (of headers, of the text of sources, of installing) or that need arguments, the scripts, and
# what builds the manual without CGAL stay behind.
# usage: assemble_cgal_tree.sh <tree>
#        if <tree> is a checkout of CGAL, its Jet_fitting_3 is replaced: commit or copy it before
set -eu
LC_ALL=C
export LC_ALL
if [ $# -ne 1 ]; then
  sed -n 's/^# usage: /usage: /p' "$0"
  exit 2
fi
root=$(cd "$(dirname "$0")/.." && pwd)
mkdir -p "$1"
tree=$(cd "$1" && pwd)
package=$tree/Jet_fitting_3

for part in include examples demo test benchmark doc package_info; do
  rm -rf "${package:?}/$part"
  mkdir -p "$package"
  cp -R "$root/$part" "$package/$part"
done
rm -rf "$package/doc/Jet_fitting_3/CMakeLists.txt" "$package/doc/Jet_fitting_3/stand_alone" \
  "$package/test/Jet_fitting_3/install_consumer" "$package/test/Jet_fitting_3/cgal_programs" \
  "$package/test/Jet_fitting_3/levels" \
  "$package/test/Jet_fitting_3/fuzz" "$package/test/Jet_fitting_3/mesh_estimation_tool.cpp" "$package/test/Jet_fitting_3"/*.sh \
  "$package/benchmark/Jet_fitting_3/CMakeLists.txt"
mkdir -p "$tree/Installation/cmake/modules"
cp "$root/cmake/FindLAPACKE.cmake" "$tree/Installation/cmake/modules/"

# library <source>...: the target that the sources need beyond CGAL and Eigen
library() {
  if grep -qi '^#include <CGAL/Lapack' "$@"; then echo CGAL::Lapacke_support
  elif grep -q '^#include <OpenMesh/' "$@"; then echo OpenMesh
  elif grep -q '^#include <tbb/' "$@"; then echo CGAL::TBB_support
  elif grep -q '^#include "tool/' "$@"; then echo Boost::program_options
  fi
}

# cmake_lists <folder> <project>: a program for each source, as CGAL's packages declare them
cmake_lists() {
  cat << END
cmake_minimum_required(VERSION 3.12...3.29)
project($2)

find_package(CGAL REQUIRED)
list(APPEND CMAKE_MODULE_PATH "\${CMAKE_CURRENT_SOURCE_DIR}/../../../Installation/cmake/modules")
find_package(Eigen3 3.1.0 QUIET)
include(CGAL_Eigen3_support)
find_package(TBB QUIET)
include(CGAL_TBB_support)
find_package(LAPACKE QUIET)
find_package(Boost QUIET OPTIONAL_COMPONENTS program_options)
if(NOT TARGET CGAL::Eigen3_support)
  message("NOTICE: This project requires the Eigen library, and will not be compiled.")
  return()
endif()
set(CMAKE_CXX_STANDARD 17)
END
  for source in "$1"/*.cpp; do
    program=$(basename "$source" .cpp)
    needed=$(library "$source")
    if [ -z "$needed" ]; then
      printf '\ncreate_single_source_cgal_program("%s.cpp")\ntarget_link_libraries(%s PRIVATE CGAL::Eigen3_support)\n' \
        "$program" "$program"
      continue
    fi
    cat << END

if(TARGET $needed)
  create_single_source_cgal_program("$program.cpp")
  target_link_libraries($program PRIVATE CGAL::Eigen3_support $needed)
else()
  message(STATUS "NOTICE: $program.cpp requires $needed, and will not be compiled.")
endif()
END
  done
}
cmake_lists "$package/examples/Jet_fitting_3" Jet_fitting_3_Examples > "$package/CMakeLists.new"
mv "$package/CMakeLists.new" "$package/examples/Jet_fitting_3/CMakeLists.txt"
cmake_lists "$package/demo/Jet_fitting_3" Jet_fitting_3_Demo > "$package/CMakeLists.new"
mv "$package/CMakeLists.new" "$package/demo/Jet_fitting_3/CMakeLists.txt"
cat >> "$package/demo/Jet_fitting_3/CMakeLists.txt" << END
if(TARGET Mesh_estimation)
  target_sources(Mesh_estimation PRIVATE tool/estimate.cpp)
endif()
END
cmake_lists "$package/test/Jet_fitting_3" Jet_fitting_3_Tests > "$package/CMakeLists.new"
mv "$package/CMakeLists.new" "$package/test/Jet_fitting_3/CMakeLists.txt"

echo "assembled in $package"
