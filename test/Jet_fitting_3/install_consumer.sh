#!/bin/sh
# Installs the package into a scratch prefix and builds a consumer with find_package(Jet_fitting_3 CONFIG) against it,
# with the CGAL of this machine and with a CGAL in a prefix of its own, whose folders come before ours on the link line.
# usage: install_consumer.sh <cmake> <build folder> <scratch folder> <compiler> <CGAL_DIR> <include folder of CGAL>
set -u
LC_ALL=C
export LC_ALL
here=$(cd "$(dirname "$0")" && pwd)
cmake=$1 build=$2 scratch=$3 compiler=$4 cgal_dir=$5 cgal_include=$6
failures=0

fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

# consumer <name> <cmake argument>...
consumer() {
  name=$1
  shift
  if ! "$cmake" -S "$here/install_consumer" -B "$scratch/$name" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER="$compiler" \
      -DCMAKE_PREFIX_PATH="$scratch/prefix" "$@" > "$scratch/$name.log" 2>&1 ||
      ! "$cmake" --build "$scratch/$name" >> "$scratch/$name.log" 2>&1; then
    cat "$scratch/$name.log"
    fail "$name: the consumer does not build"
    return
  fi
  "$scratch/$name/consumer" || fail "$name: the consumer exits with $?"
  headers=$(find "$scratch/$name" -name 'consumer.cpp*.d' -exec cat {} + | tr ' \\' '\n\n' | grep '/CGAL/' | sort -u)
  taken=$(echo "$headers" | grep '/CGAL/Monge_via_jet_fitting\.h$')
  echo "$name: took $taken"
  [ "$taken" = "$scratch/prefix/include/Jet_fitting_3/CGAL/Monge_via_jet_fitting.h" ] ||
    fail "$name: our header did not win"
}

# took_from <name> <folder>: the last consumer used the CGAL of that folder.
took_from() {
  echo "$headers" | grep -q "^$2/CGAL/Simple_cartesian\.h$" || fail "$1: CGAL was not taken from $2"
}

rm -rf "$scratch"
mkdir -p "$scratch"
"$cmake" --install "$build" --prefix "$scratch/prefix" > "$scratch/install.log" || fail "cmake --install"
grep -rlF -e "$build/" -e "$(dirname "$here")" "$scratch/prefix" && fail "these installed files name folders of the build"

if [ -e "$build/demo/Jet_fitting_3/Mesh_estimation" ]; then
  "$scratch/prefix/bin/Mesh_estimation" --help > "$scratch/help.txt" || fail "the installed program exits with $?"
  grep -qs '^.TH Mesh_estimation 1$' "$scratch"/prefix/*/man1/Mesh_estimation.1 "$scratch"/prefix/*/man/man1/Mesh_estimation.1 ||
    fail "the manual page of the program is not installed"
fi

consumer configured_cgal -DCGAL_DIR="$cgal_dir"
took_from configured_cgal "$cgal_include"

# As `dpkg -x` unpacks it: the same folders below another root.
unpacked=$scratch/unpacked
mkdir -p "$unpacked$cgal_include" "$unpacked$(dirname "$cgal_dir")"
cp -R "$cgal_include/CGAL" "$unpacked$cgal_include/CGAL"
cp -R "$cgal_dir" "$unpacked$cgal_dir"
consumer unpacked_cgal -DCGAL_DIR="$unpacked$cgal_dir"
took_from unpacked_cgal "$unpacked$cgal_include"
rm -rf "$unpacked"

echo "install_consumer: $failures failures"
[ "$failures" -eq 0 ]
