#!/bin/sh
# Assembles the tree as it would stand in CGAL, and configures and builds its examples and tests there: an example and a test
# are compiled and run.
# usage: docs_cgal_tree.sh <root of the package> <scratch folder> <cmake> <compiler> <CGAL_DIR>
set -u
LC_ALL=C
export LC_ALL
root=$1 scratch=$2 cmake=$3 compiler=$4 cgal_dir=$5
failures=0

fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

rm -rf "$scratch"
mkdir -p "$scratch"
sh "$root/scripts/assemble_cgal_tree.sh" "$scratch/tree" || fail "the tree cannot be assembled"
package=$scratch/tree/Jet_fitting_3
for file in include/CGAL/Monge_via_jet_fitting.h examples/Jet_fitting_3/README test/Jet_fitting_3/check.h \
  doc/Jet_fitting_3/Jet_fitting_3.txt doc/Jet_fitting_3/PackageDescription.txt doc/Jet_fitting_3/Concepts/SvdTraits.h \
  package_info/Jet_fitting_3/dependencies; do
  [ -s "$package/$file" ] || fail "there is no $file"
done
grep -rlF "$root" "$scratch/tree" && fail "these files of the tree name the folder they come from"

# build <folder of the tree> <program>
build() {
  if "$cmake" -S "$package/$1" -B "$scratch/$1" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER="$compiler" \
    -DCMAKE_CXX_FLAGS="-O1 -I$package/include" -DCGAL_DIR="$cgal_dir" > "$scratch/log" 2>&1 &&
    "$cmake" --build "$scratch/$1" --target "$2" >> "$scratch/log" 2>&1; then
    (cd "$package/$1" && "$scratch/$1/$2") > "$scratch/$2.txt" || fail "$2 exits with $?"
  else
    cat "$scratch/log"
    fail "$1 of the tree does not build $2"
  fi
}
build examples/Jet_fitting_3 Single_estimation
grep -q '^k1 : 0.8' "$scratch/Single_estimation.txt" || fail "Single_estimation does not find k1 = 0.8"
build test/Jet_fitting_3 bad_input

find "$package/examples/Jet_fitting_3" "$package/demo/Jet_fitting_3" "$package/test/Jet_fitting_3" -maxdepth 1 -name '*.cpp' | while read -r source; do
  program=$(basename "$source")
  cat "$package"/examples/*/CMakeLists.txt "$package"/demo/*/CMakeLists.txt "$package"/test/*/CMakeLists.txt | grep -qF "\"$program\"" || echo "$program"
done > "$scratch/forgotten"
[ ! -s "$scratch/forgotten" ] || fail "no CMakeLists.txt of the tree has $(cat "$scratch/forgotten")"

echo "docs_cgal_tree: $failures failures"
[ "$failures" -eq 0 ]
