#!/bin/sh
# Builds and runs all tests. On Debian 12 it installs what is missing; it can be run again.
# shellcheck source=scripts/lib.sh
. "$(dirname "$0")/lib.sh"

install_missing g++ make cmake libcgal-dev libcgal-demo libeigen3-dev libboost-dev libboost-program-options-dev \
  libgmp-dev libmpfr-dev liblapacke-dev libtbb-dev libopenmesh-dev clang clang-format-14 doxygen
find_demo_archives

say "configuring $build/test"
cmake --preset test -B "$build/test" -DCGAL_DEMO_ARCHIVES_DIR="$demo_archives" -DJET_FITTING_3_TEST_MATRIX="$build"
say "building with $jobs compilers at a time"
# What does not compile is a test that is not run, and counts as failed there.
cmake --build "$build/test" -j "$jobs" -- -k || say "some programs do not compile"
say "testing"
exec ctest --test-dir "$build/test" -j "$jobs" --output-on-failure
