#!/bin/sh
# Ours and CGAL's class side by side: builds fits_per_second and mesh_throughput with both, runs them in turn, and prints
# medians and their ratios as tables.
#
#   sh side_by_side.sh <CGAL's data folder> <CGAL's examples folder> [runs]
#
# CXX, CXXFLAGS (-O3 -DNDEBUG) and EIGEN3_INCLUDE are respected. FILTER is a regular expression for the benchmarks.
# Columns: microseconds per fit or vertex, ours and CGAL's; their ratio; the relative difference of the checksums.
set -eu
data=$1
examples=$2
runs=${3:-5}
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

build="${CXX:-c++} -std=c++17 ${CXXFLAGS:--O3 -DNDEBUG} -DCGAL_EIGEN3_ENABLED -DCGAL_DATA_DIR=\"\""
theirs="-isystem ${EIGEN3_INCLUDE:-/usr/include/eigen3}"
ours="-I$here/../../include $theirs"
libraries="-lbenchmark -lpthread -lgmp -lmpfr"
# shellcheck disable=SC2086
{
  $build $ours "$here/fits_per_second.cpp" -o "$work/fits_ours" $libraries
  $build $theirs "$here/fits_per_second.cpp" -o "$work/fits_cgal" $libraries
  $build $ours -DCGAL_LINKED_WITH_TBB "$here/mesh_throughput.cpp" -o "$work/mesh_ours" $libraries -ltbb
  $build $theirs "-I$examples/Ridges_3" "$here/mesh_throughput_cgal.cpp" -o "$work/mesh_cgal" $libraries
}

run=0
while [ "$run" -lt "$runs" ]; do
  run=$((run + 1))
  echo "run $run of $runs" >&2
  for program in fits mesh; do
    for side in ours cgal; do
      "$work/${program}_$side" "--benchmark_filter=${FILTER:-.}" --benchmark_format=csv "$data" 2>> "$work/log" |
        sed "s/^/$side,/" >> "$work/results.csv"
    done
  done
done

# The columns of the counters are named in a header line before each run's rows.
awk -F, -v runs="$runs" '
  function median(list, values, n, i, j, t) {
    n = split(list, values, " ")
    for (i = 2; i <= n; ++i)
      for (j = i; j > 1 && values[j - 1] + 0 > values[j] + 0; --j) { t = values[j]; values[j] = values[j - 1]; values[j - 1] = t }
    return n % 2 ? values[(n + 1) / 2] : (values[n / 2] + values[n / 2 + 1]) / 2
  }
  { gsub(/"/, "") }
  $2 == "name" {
    for (i = 1; i <= NF; ++i) {
      if ($i ~ /_per_second$/ && $i !~ /^(bytes|items)/) rate = i
      if ($i == "checksum") sum = i
    }
    next
  }
  rate && $rate > 0 {
    sub(/\/(real_time|min_time).*/, "", $2)
    if (!($2 in seen)) { seen[$2] = 1; names[++count] = $2 }
    times[$1, $2] = times[$1, $2] " " 1e6 / $rate
    checksum[$1, $2] = $sum
  }
  END {
    print "| " runs " runs | ours, us | CGAL, us | ratio | checksums differ by |"
    print "|---|---|---|---|---|"
    for (i = 1; i <= count; ++i) {
      name = names[i]
      ours = median(times["ours", name])
      line = sprintf("| %s | %.3f |", name, ours)
      if (("cgal", name) in times) {
        theirs = median(times["cgal", name])
        difference = checksum["ours", name] / checksum["cgal", name] - 1
        line = line sprintf(" %.2f | %.1f | %.1e |", theirs, theirs / ours, difference < 0 ? -difference : difference)
      }
      else line = line " | | |"
      print line
    }
  }' "$work/results.csv"
