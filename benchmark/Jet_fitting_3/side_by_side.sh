#!/bin/sh
# Ours and CGAL's side by side: builds the same programs with both, compares all their answers, runs them in turn, and
# prints medians and ratios as tables: single fits, normals of points, whole meshes, many vertices, two threads, and CGAL 6's
# interpolated corrected curvatures.
#
#   sh side_by_side.sh          everything: about half an hour
#   sh side_by_side.sh quick    a first look: one run, no large meshes, no CGAL 6
#
# Variables, with their defaults:
#   CXX=c++  CXXFLAGS="-O3 -DNDEBUG"
#   RUNS=5                    interleaved runs (quick: 1)
#   PEERS_DIR=                folder with the sources libigl/, vcglib/ and ponca/, for their time and error; none: left out
#   FILTER=.                  regular expression for the names of benchmarks
#   RUN=                      a command to start programs with, such as "taskset -c 0"
#   CGAL_6=sid                release of Debian whose CGAL is unpacked for surface_peers (scripts/fetch_cgal.sh); none: left out
#   BUILD_DIR=<root>/build    programs are built in its folder side_by_side; CMAKE_ARGUMENTS are added for cmake
# Needs CMake, Google Benchmark and CGAL with its examples and data (Debian: libbenchmark-dev libcgal-dev libcgal-demo).
# One thread is timed by its processor time, two threads and the one beside them by the clock. Columns: microseconds per fit,
# vertex or point; CGAL's over ours; how far the checksums differ.
set -eu
mode=${1:-full}
case $mode in
  full) runs=${RUNS:-5} filter=${FILTER:-.} ;;
  quick) runs=${RUNS:-1} filter=${FILTER:-'^fit/|armadillo/d|^points|^cloud/torus_100000/'} ;;
  *) echo "usage: side_by_side.sh [quick]" >&2 && exit 2 ;;
esac
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
build=${BUILD_DIR:-$root/build}
compiler=${CXX:-c++}
flags=${CXXFLAGS:--O3 -DNDEBUG}
work=$build/side_by_side/$(echo "$(basename "$compiler") $flags" | tr -cs 'A-Za-z0-9=+\n' _)
mkdir -p "$work"
results=$work/results.csv
: > "$results"

# programs <folder> "<target>..." <arguments of cmake>...: builds them there.
programs() {
  folder=$1
  targets=$2
  shift 2
  # shellcheck disable=SC2086
  {
    cmake -S "$here" -B "$folder" -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER="$compiler" \
      -DCMAKE_CXX_FLAGS_RELEASE="$flags" ${CMAKE_ARGUMENTS:-} "$@" && cmake --build "$folder" --target $targets
  } > "$folder.log" 2>&1 || {
    tail -n 20 "$folder.log" >&2
    echo "side_by_side.sh: the programs cannot be built; the log is $folder.log" >&2
    exit 1
  }
}

# has_program <folder> <target>: whether it was declared there; what it requires may be missing.
has_program() {
  cmake --build "$1" --target help | grep "$2" > /dev/null
}

echo "building with $compiler $flags" >&2
sides='fits_per_second_ours fits_per_second_cgal point_normals_ours point_normals_cgal mesh_throughput mesh_throughput_cgal point_throughput'
programs "$work/cgal" "$sides compare_answers"
data=$(sed -n 's/^CGAL_DATA_DIR:[A-Z]*=//p' "$work/cgal/CMakeCache.txt")

two_threads=
if [ "$mode" = full ]; then
  if has_program "$work/cgal" mesh_throughput_two_threads; then
    two_threads=$work/cgal/mesh_throughput_two_threads
    programs "$work/cgal" mesh_throughput_two_threads
  else
    echo "side_by_side.sh: without TBB there are no two threads to time" >&2
  fi
fi

# CGAL 6, where it can be had.
peers=
suite=${CGAL_6:-sid}
if [ "$mode" = full ] && [ "$suite" != none ]; then
  if unpacked=$(BUILD_DIR=$build sh "$root/scripts/fetch_cgal.sh" "$suite"); then
    programs "$work/cgal-$suite" surface_peers "-DCGAL_DIR=$(dirname "$(find "$unpacked/usr" -name CGALConfig.cmake)")" \
      "-DEigen3_DIR=$(dirname "$(find "$unpacked/usr" -name Eigen3Config.cmake)")" "-DCGAL_DATA_DIR=$data"
    peers=surface_peers
  else
    echo "side_by_side.sh: without CGAL 6 there are no interpolated corrected curvatures to compare with" >&2
  fi
fi

if [ "$mode" = full ]; then
  echo "answers" >&2
  for pair in fits_per_second_ours:fits_per_second_cgal mesh_throughput:mesh_throughput_cgal; do
    "$work/cgal/${pair%:*}" "--answers=$work/ours.answers" "$data"
    "$work/cgal/${pair#*:}" "--answers=$work/cgal.answers" "$data"
    "$work/cgal/compare_answers" "$work/ours.answers" "$work/cgal.answers" "$data"
    echo
  done
  rm "$work/ours.answers" "$work/cgal.answers"
fi

# timed <side> <program> [<option>]: its rows are added to the results.
timed() {
  side=$1
  timed_program=$2
  shift 2
  # shellcheck disable=SC2086
  ${RUN:-} "$timed_program" "--benchmark_filter=$filter" --benchmark_format=csv "$@" "$data" > "$work/rows" 2>> "$work/log" || {
    tail -n 5 "$work/log" >&2
    echo "side_by_side.sh: $timed_program does not run" >&2
    exit 1
  }
  sed "s/^/$side,/" "$work/rows" >> "$results"
}

run=0
while [ "$run" -lt "$runs" ]; do
  run=$((run + 1))
  echo "run $run of $runs" >&2
  for program in fits_per_second point_normals mesh_throughput; do
    ours=${program}_ours
    [ "$program" != mesh_throughput ] || ours=$program
    timed ours "$work/cgal/$ours"
    timed cgal "$work/cgal/${program}_cgal"
  done
  timed ours "$work/cgal/point_throughput"
  timed cgal "$work/cgal/point_throughput" --normals-of-cgal
  [ -z "$two_threads" ] || timed ours "$two_threads"
  [ -z "$peers" ] || timed ours "$work/cgal-$suite/$peers"
done

if [ -n "${PEERS_DIR:-}" ] && [ "$mode" = full ]; then
  echo "libigl, vcglib, Ponca and PCL" >&2
  programs "$work/peers" help "-DPEERS_DIR=$PEERS_DIR"
  for program in mesh_peers point_peers; do
    if ! has_program "$work/peers" "$program"; then
      echo "side_by_side.sh: $program is left out, $work/peers.log says what it needs" >&2
      continue
    fi
    programs "$work/peers" "$program"
    # shellcheck disable=SC2086
    ${RUN:-} "$work/peers/$program" 2>> "$work/log"
  done
fi

# The columns of the counters are named in a header line before each run's rows.
awk -F, -v runs="$runs" '
  function median(list, values, n, i, j, t) {
    n = split(list, values, " ")
    for (i = 2; i <= n; ++i)
      for (j = i; j > 1 && values[j - 1] + 0 > values[j] + 0; --j) { t = values[j]; values[j] = values[j - 1]; values[j - 1] = t }
    return n % 2 ? values[(n + 1) / 2] : (values[n / 2] + values[n / 2 + 1]) / 2
  }
  function time_of(side, name) { return (side, name) in times ? median(times[side, name]) : 0 }
  function ratio(text, slower, faster) {
    if (slower > 0 && faster > 0) printf "%s: %.2f\n", text, slower / faster
  }
  { gsub(/"/, "") }
  $2 == "name" {
    gain = 0
    for (i = 1; i <= NF; ++i) {
      if ($i == "gain") gain = i
      if ($i == "gain_apart") apart = i
      if ($i == "gain_over_apart") over = i
      if ($i ~ /_per_second$/ && $i !~ /^(bytes|items)/) rate = i
      if ($i == "checksum") sum = i
    }
    next
  }
  rate && $rate > 0 {
    sub(/\/(iterations|min_time).*/, "", $2)
    if (!($2 in seen)) { seen[$2] = 1; names[++count] = $2 }
    times[$1, $2] = times[$1, $2] " " 1e6 / $rate
    checksum[$1, $2] = $sum
    if (gain && $gain > 0) {
      gains[$2] = gains[$2] " " $gain
      gains_apart[$2] = gains_apart[$2] " " $apart
      gains_over[$2] = gains_over[$2] " " $over
    }
  }
  END {
    print "| " runs " runs | ours, us | CGAL, us | ratio | checksums differ by |"
    print "|---|---|---|---|---|"
    for (i = 1; i <= count; ++i) {
      name = names[i]
      ours = time_of("ours", name)
      theirs = time_of("cgal", name)
      line = sprintf("| %s | %.3f |", name, ours)
      if (theirs > 0) {
        difference = checksum["ours", name] / checksum["cgal", name] - 1
        line = line sprintf(" %.2f | %.1f | %.1e |", theirs, theirs / ours, difference < 0 ? -difference : difference)
      }
      else line = line " | | |"
      print line
    }
    print ""
    ratio("a form of order 4 over one of order 2, degree 4", time_of("ours", "fit/d:4/dprime:4/points:40"),
          time_of("ours", "fit/d:4/dprime:2/points:40"))
    for (d = 2; d <= 4; ++d) {
      for (n = 100000; n <= 1000000; n *= 10) {
        torus = "torus_" n
        name = "two_threads/" torus "/d:" d
        if (name in gains)
          printf "degree %d, %d vertices: one thread over two: %.2f; jobs that share nothing: %.2f; over one another: %.2f\n", d, n,
            median(gains[name]), median(gains_apart[name]), median(gains_over[name])
        ratio("degree " d ", " n " vertices: a vertex over one of 10000", time_of("ours", "mesh/" torus "/d:" d),
              time_of("ours", "mesh/torus_10000/d:" d))
        ratio("degree " d ", " n " vertices: shuffled over natural order",
              time_of("ours", "mesh/" torus "_shuffled/d:" d), time_of("ours", "mesh/" torus "/d:" d))
      }
    }
    for (ball = 0; ball <= 2; ball += 2)
      ratio("interpolated corrected curvatures, ball of " ball " edges, over forms of degree 2",
            time_of("ours", "interpolated_corrected_curvatures/ball:" ball), time_of("ours", "monge_forms/d:2/rings:2"))
  }' "$results"
