#!/bin/sh
# Random fits by this package and by CGAL's own class, both against 50 digits, case by case.
# usage: differential.sh <our include folder> <CGAL's> <Eigen's> <work folder> <compiler> [number of fits, 10000]
# Fails if in any case ours is worse than CGAL's by more than a factor of 2 plus rounding of the results (1e-14 relative
# for the normal and the curvatures, 1e-12 and 1e-10 for third and fourth order).
set -eu
here=$(cd "$(dirname "$0")" && pwd)
ours=$1 theirs=$2 eigen=$3 work=$4 compiler=$5 count=${6:-10000}
mkdir -p "$work"
cd "$here"
"$compiler" -std=c++17 -O2 -I"$ours" -I"$theirs" -I"$eigen" -DCGAL_EIGEN3_ENABLED differential.cpp \
  -o "$work/ours" -lgmp -lmpfr
"$compiler" -std=c++17 -O2 -I"$theirs" -I"$eigen" -DCGAL_EIGEN3_ENABLED differential.cpp \
  -o "$work/theirs" -lgmp -lmpfr
"$work/ours" "$count" > "$work/ours.txt" &
"$work/theirs" "$count" > "$work/theirs.txt"
wait
paste -d ' ' "$work/ours.txt" "$work/theirs.txt" | awk '
  BEGIN { split("normal k b c", name); split("1e-14 1e-14 1e-12 1e-10", floor) }
  {
    for (q = 1; q <= 4; ++q) {
      a = $(3 + q); b = $(14 + q); r = $(7 + q)
      if ($2 < q && q > 2) continue
      ++cases[q]
      if (!(a <= 2 * b + floor[q])) { ++worse[q]; print "WORSE case " $1 ", d = " $2 ", N = " $3 ", " name[q] ": " a " against " b }
      ratio = a > 0 && b > 0 ? log(b / a) / log(10) : 0
      bin = ratio < -1 ? -2 : ratio < 0 ? -1 : ratio < 1 ? 0 : ratio < 2 ? 1 : ratio < 3 ? 2 : ratio < 4 ? 3 : 4
      ++histogram[q, bin]
      if (a > most_a[q]) most_a[q] = a
      if (b > most_b[q]) most_b[q] = b
      if (r > most_r[q]) most_r[q] = r
    }
  }
  END {
    print "how many times smaller our error is, in cases"
    print "quantity cases <0.1 0.1-1 1-10 10-100 100-1e3 1e3-1e4 >1e4 | largest errors: ours, CGAL, rounding of the data"
    for (q = 1; q <= 4; ++q) {
      printf "%s %d", name[q], cases[q]
      for (bin = -2; bin <= 4; ++bin) printf " %d", histogram[q, bin]
      printf " | %.2g %.2g %.2g\n", most_a[q], most_b[q], most_r[q]
      bad += worse[q]
    }
    print bad + 0 " cases in which ours is worse by more than 2x plus rounding"
    exit bad > 0 || NR == 0
  }'
