#!/bin/sh
# A program with a file that is compiled for several levels of processors: each level gives the right curvatures, and no
# code for a level can be taken by what runs on all processors.
# usage: levels.sh <program> <folder to work in> <object of a level>...
set -u
LC_ALL=C
export LC_ALL
program=$1 work=$2
shift 2
mkdir -p "$work"
failures=0

fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

for level in 1 3 4; do
  CGAL_JET_FITTING_3_LEVEL=$level "$program" > "$work/$level" || fail "level $level: exit code $?, or no unit sphere"
  head -n 1 "$work/$level"
done
grep -q '^level 1, the first copy' "$work/1" || fail "the level is not lowered"
if [ $# -gt 0 ] && grep -qs '^flags.* avx2 .* bmi2 ' /proc/cpuinfo; then
  grep -q '^level 3, another copy' "$work/3" || fail "level 3 is not taken"
fi

if [ $# -gt 1 ] && grep -qs '^flags.* avx512f .* avx512vl ' /proc/cpuinfo; then
  grep -q '^level 4, another copy' "$work/4" || fail "level 4 is not taken"
fi

# Names of a level belong to it alone; what initializes it is not run at the start of the program.
for object in "$@"; do
  nm --defined-only --extern-only "$object" | grep -v '_level_[34]' && fail "$object: others may take these"
  nm --defined-only --extern-only "$object" | grep -q 'mean_curvatures_level_[34]' || fail "$object: no function of the level"
  readelf -SW "$object" | grep -E ' \.(init_array|ctors)' && fail "$object: run on all processors"
  readelf -SW "$object" | grep -q ' cgal_jet_fitting_3_level_[34] ' || fail "$object: its initialization is lost"
  objdump -d "$object" | grep -q 'ymm' || fail "$object: no wide registers"
done
if command -v qemu-x86_64 > /dev/null; then # a processor without AVX
  qemu-x86_64 -cpu Nehalem "$program" > "$work/nehalem" || fail "Nehalem: exit code $?"
  cmp "$work/nehalem" "$work/1" || fail "Nehalem differs from level 1"
fi
echo "levels: $# objects, $failures failures"
[ "$failures" -eq 0 ]
