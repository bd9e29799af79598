#!/bin/sh
# Builds and runs the tests. On Debian 12 it installs what is missing; it can be run again, and says at the end how long
# it took.
#   sh test.sh quick    the core, documents and style: under three minutes on two free processors
#   sh test.sh          all tests on the CGAL of this machine
#   sh test.sh all      also a few of them with other versions of CGAL, which are fetched; the default where CI=true
# shellcheck source=scripts/lib.sh
. "$(dirname "$0")/lib.sh"

mode=${1:-default}
case $mode in
  quick | all) ;;
  default) [ "${CI:-}" != true ] || mode=all ;;
  *) echo "usage: test.sh [quick|all]" >&2 && exit 2 ;;
esac
begin=$(date +%s)

install_missing g++ make cmake libcgal-dev libcgal-demo libeigen3-dev libboost-dev libboost-program-options-dev \
  libgmp-dev libmpfr-dev liblapacke-dev libtbb-dev libopenmesh-dev clang clang-format-14 doxygen python3-meshio parallel
[ "$mode" != all ] || install_missing slurm-wlm munge qemu-user
find_demo_archives

matrix=
[ "$mode" != all ] || matrix=$build
say "configuring $build/test"
cmake --preset test -B "$build/test" -DCGAL_DEMO_ARCHIVES_DIR="$demo_archives" -DJET_FITTING_3_TEST_MATRIX="$matrix"

say "building with $jobs compilers at a time"
if [ "$mode" = quick ]; then
  programs='formulas theorem_2_1 bad_input drop_in_interface'
  targets=$(for program in $programs; do echo "test_$program"; done)
  tests="^($(echo "$programs" | tr ' ' '|')|source_hygiene|docs_build|docs_code)\$"
else
  targets=all
  tests=.
fi
# What does not compile is a test that is not run, and counts as failed there.
# shellcheck disable=SC2086
cmake --build "$build/test" -j "$jobs" --target $targets -- -k || say "some programs do not compile"
say "testing"
result=0
ctest --test-dir "$build/test" -j "$jobs" --output-on-failure -R "$tests" || result=$?
seconds=$(($(date +%s) - begin))
say "$mode tests: $((seconds / 60)) min $((seconds % 60)) s, $([ "$result" -eq 0 ] && echo passed || echo FAILED)"
exit "$result"
