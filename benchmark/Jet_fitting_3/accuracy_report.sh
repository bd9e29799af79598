#!/bin/sh
# Prints the table "ours / CGAL's / best possible" of relative errors, the largest over the surfaces of each row.
#
#   sh accuracy_report.sh [program_with_our_header program_with_CGAL's_header]
#
# Without arguments both programs are built here, in a temporary folder, from accuracy_report.cpp (CXX, CXXFLAGS and
# EIGEN3_INCLUDE are respected). "Best possible" is the error that rounding the samples' coordinates to double has
# caused before any fit begins; ours and CGAL's are measured against a 50-digit fit of the rounded samples, so a
# method is as good as the data allow wherever its figure is below that one.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

if [ $# -eq 2 ]; then
  ours=$1
  theirs=$2
else
  ours=$work/ours
  theirs=$work/theirs
  build="${CXX:-c++} -std=c++17 ${CXXFLAGS:--O2} -DCGAL_EIGEN3_ENABLED -I${EIGEN3_INCLUDE:-/usr/include/eigen3}"
  $build -I"$here/../../include" "$here/accuracy_report.cpp" -o "$ours" -lgmp -lmpfr
  $build "$here/accuracy_report.cpp" -o "$theirs" -lgmp -lmpfr
fi
data=$here/../../test/Jet_fitting_3/data/truth_sample.tsv
"$ours" "$data" > "$work/ours.tsv"
"$theirs" "$data" > "$work/theirs.tsv"

awk -F '\t' '
  function larger(a, b) {
    if (b == "-" || a ~ /nan/) return a
    return a == "" || b ~ /nan/ || b + 0 > a + 0 ? b : a
  }
  FNR == 1 { ++file; next }
  {
    row = $1 " " $3 "\t" $4
    if (!(row in seen)) { seen[row] = 1; order[++rows] = row }
    for (q = 1; q <= 4; ++q) {
      worst[file, row, q] = larger(worst[file, row, q], $(4 + q))
      floor_[row, q] = larger(floor_[row, q], $(8 + q))
    }
  }
  END {
    print "| samples | d | normal | k | b | c |"
    print "|---|---|---|---|---|---|"
    for (r = 1; r <= rows; ++r) {
      row = order[r]
      split(row, key, "\t")
      line = "| " key[1] " | " key[2] " |"
      for (q = 1; q <= 4; ++q)
        line = line (worst[1, row, q] == "" ? " |" : " " worst[1, row, q] " / " worst[2, row, q] " / " floor_[row, q] " |")
      print line
    }
  }' "$work/ours.tsv" "$work/theirs.tsv"
