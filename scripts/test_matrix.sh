#!/bin/sh
# Runs the tests on other versions of CGAL and Eigen, other compilers and options, and prints a table.
# usage: test_matrix.sh [all|spread|subset|processors|<part of the name of rows>]
# "all", the default, takes hours. "spread" runs every test once with each CGAL: a row has its share of the tests, and all
# that need libraries which other rows do without. "subset" is what the continuous integration has time for: two rows and a
# few tests. "processors" are the other processors alone (scripts/other_processors.sh), which "all" also takes.
# sid-clang++, say, takes the rows whose names, which are their settings joined by "-", contain this.
# CGAL 5.5 is the one of this system; those of Debian's trixie and sid are unpacked into the build folder, once.
# Exits with 77 if every row had to be left out.
# shellcheck source=scripts/lib.sh
. "$(dirname "$0")/lib.sh"

# CGAL     compiler standard flags   optional assertions programs
#   flags       O0, O2, native (-O3 -march=native), plain (-O2 -march=native -ffp-contract=off)
#   optional    all, or none: without TBB and LAPACK
#   programs    yes: also CGAL's own programs, on its header and on ours
# Each pair of two settings (programs apart) occurs in at least one row of "all", and no row could be left out;
# "subset" is the rows that are marked: with "class" the tests of the class, with "program" that of the program as well.
rows='
sid     clang++ 17 native none off yes program
trixie  g++     17 plain  all  on  yes
system  clang++ 20 O2     all  off no
sid     g++     20 O2     all  on  no
trixie  clang++ 20 native all  off no
system  g++     17 native all  on  yes
sid     clang++ 20 plain  all  on  no
trixie  g++     20 O0     none off no
system  clang++ 17 O0     all  on  no
trixie  clang++ 17 O2     none on  no  class
sid     g++     17 O0     all  off no
system  clang++ 20 plain  none off yes
'

matrix=$build/matrix
mkdir -p "$matrix"
table=$matrix/results.txt
printf '%-8s %-9s %-7s %-3s %-7s %-8s %-10s %-8s %s\n' \
  suite CGAL comp. C++ flags optional assertions programs result > "$table"

# The arguments that make CMake take CGAL and Eigen from the unpacked packages of a suite.
cgal_arguments() {
  [ "$1" != system ] || return 0
  folder=$(BUILD_DIR=$build sh "$root/scripts/fetch_cgal.sh" "$1") || return $?
  echo "-DCGAL_DIR=$(dirname "$(find "$folder/usr" -name CGALConfig.cmake)")"
  echo "-DEigen3_DIR=$(dirname "$(find "$folder/usr" -name Eigen3Config.cmake)")"
  echo "-DEIGEN3_INCLUDE_DIR=$folder/usr/include/eigen3"
  echo "-DCGAL_DEMO_ARCHIVES_DIR=$folder/usr/share/doc/libcgal-dev"
}

flags_of() {
  case $1 in
    O0) echo -O0 ;;
    O2) echo -O2 ;;
    native) echo -O3 -march=native ;;
    plain) echo -O2 -march=native -ffp-contract=off ;;
  esac
}

# Builds and tests one row; sets result and version. $targets, if any, are all that is built, $tests all that is run.
run_row() {
  log=$matrix/$name.log
  version=-
  if ! command -v "$compiler" > /dev/null; then
    result="left out: there is no $compiler"
    return
  fi
  if ! arguments=$(cgal_arguments "$suite"); then
    result="left out: the packages of $suite cannot be reached"
    return
  fi
  flags=$(flags_of "$flags")
  [ "$assertions" = on ] || flags="$flags -DNDEBUG"
  disable=OFF
  [ "$optional" = all ] || disable=ON
  excluded='source_hygiene.*|docs_.*|install_consumer'
  [ "$programs" = yes ] || excluded="$excluded|cgal_programs"
  start=$(date +%s)
  # shellcheck disable=SC2086
  if ! cmake --preset test -B "$matrix/$name" -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_STANDARD="$standard" \
      -DCMAKE_CXX_FLAGS_DEBUG="$flags" $arguments -DCMAKE_DISABLE_FIND_PACKAGE_TBB=$disable \
      -DCMAKE_DISABLE_FIND_PACKAGE_LAPACKE=$disable > "$log" 2>&1; then
    result="FAILED to configure: $log"
    return
  fi
  version=$(sed -n 's/^jet_fitting_3_cgal_version:INTERNAL=//p' "$matrix/$name/CMakeCache.txt")
  [ "$wanted" != spread ] || take_share
  if [ -n "$targets" ]; then # one after the other by make itself
    # shellcheck disable=SC2086
    printf '%s\n' $targets | xargs -P "$jobs" -I @ cmake --build "$matrix/$name" --target @ >> "$log" 2>&1 || true
  else
    cmake --build "$matrix/$name" -j "$jobs" -- -k >> "$log" 2>&1 || true
  fi
  if ctest --test-dir "$matrix/$name" -j "$jobs" -R "$tests" -E "^($excluded)\$" --output-on-failure >> "$log" 2>&1; then
    verdict=passed
  else
    verdict=FAILED
  fi
  result="$verdict: $(sed -n 's/^\([0-9]*%\) tests passed, \([0-9]*\) tests failed out of \([0-9]*\).*/\2 of \3 failed/p' "$log" |
    tail -n 1), $(($(date +%s) - start)) s"
  [ "$verdict" = passed ] || result="$result: $(sed -n '/^The following tests FAILED/,$s/^[ \t]*[0-9]* - \([^ ]*\).*/\1/p' "$log" | tr '\n' ' ')"
}

# Sets targets and tests to the part of the tests that this row has. The sum of a name's bytes does not depend on which
# tests the other rows have.
take_share() {
  of=$(echo "$rows" | grep -c "^$suite ")
  place=$(echo "$rows" | grep "^$suite " | tr -s ' ' | grep -n "^$suite $line" | cut -d: -f 1)
  targets=
  tests='^('
  for test in $(ctest --test-dir "$matrix/$name" -N -E "^($excluded)\$" | sed -n 's/^ *Test *#[0-9]*: //p'); do
    case $test in
      cgal_programs | lapack_svd | parallel_doors | user_parallelism) ;;
      *) [ $(($(echo "$test" | cksum | cut -d' ' -f 1) % of + 1)) -eq "$place" ] || continue ;;
    esac
    tests="$tests$test|"
    case $test in
      cgal_programs | differential) ;;
      example_*) targets="$targets ${test#example_}" ;;
      demo_*) targets="$targets ${test#demo_}" ;;
      mesh_estimation_tool) targets="$targets test_$test Mesh_estimation" ;;
      *) targets="$targets test_$test" ;;
    esac
  done
  tests="$tests-)\$"
}

# Sets targets and tests to what a row of the subset has by its mark.
take_subset() {
  targets='test_drop_in_interface test_kernels_and_traits test_packs'
  tests='drop_in_interface|kernels_and_traits|packs'
  if [ "$mark" = program ]; then
    targets="$targets test_mesh_estimation_tool Mesh_estimation"
    tests="$tests|mesh_estimation_tool"
  fi
  tests="^($tests)\$"
}

wanted=${1:-all}
targets=
tests=.
failed=0
done=0
case $wanted in
  all | processors)
    say "other processors"
    start=$(date +%s)
    if BUILD_DIR=$build sh "$root/scripts/other_processors.sh" > "$matrix/processors.log" 2>&1; then
      result="passed: $(($(date +%s) - start)) s"
      done=1
    else
      result="FAILED: $matrix/processors.log"
      failed=1
    fi
    printf '%-8s %-9s %s\n' processors - "$result" | tee -a "$table"
    ;;
esac
while read -r suite compiler standard flags optional assertions programs mark; do
  [ -n "$suite" ] || continue
  name=$suite-$compiler-$standard-$flags-$optional-$assertions
  case $wanted in
    all | spread) ;;
    subset)
      [ -n "$mark" ] || continue
      take_subset
      ;;
    *) case $name in *"$wanted"*) ;; *) continue ;; esac ;;
  esac
  line="$compiler $standard $flags $optional $assertions $programs"
  say "$suite $line"
  run_row < /dev/null
  # shellcheck disable=SC2086
  printf '%-8s %-9s %-7s %-3s %-7s %-8s %-10s %-8s %s\n' "$suite" "$version" $line "$result" | tee -a "$table"
  case $result in
    passed*) done=$((done + 1)) ;;
    FAILED*) failed=$((failed + 1)) ;;
  esac
done << EOT
$rows
EOT

say "the table is in $table, a log of each row beside it:"
cat "$table"
[ "$failed" -eq 0 ] || exit 1
[ "$done" -gt 0 ] || exit 77
