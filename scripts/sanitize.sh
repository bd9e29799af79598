#!/bin/sh
# Runs the tests under sanitizers.
# usage: sanitize.sh [address|thread|valgrind]...     (default: all three)
#   address   all programs, by clang's address and undefined behaviour sanitizers, leaks included
#   thread    the tests that use threads, by g++'s thread sanitizer, with a TBB that is built for it from Debian's
#             sources: in the TBB of the system it does not see which thread waits for which. A race that is put into a
#             copy of our header must be found.
#   valgrind  the examples, by memcheck
# Exits with 1 if there is a finding.
# shellcheck source=scripts/lib.sh
. "$(dirname "$0")/lib.sh"

install_missing g++ clang libclang-rt-14-dev make cmake libcgal-dev libcgal-demo libeigen3-dev libboost-dev \
  libboost-program-options-dev libgmp-dev libmpfr-dev liblapacke-dev libtbb-dev
find_demo_archives
failed=0

# Not these: they run no program of ours, or build their own without the sanitizer.
without_sanitizer='^(source_hygiene.*|docs_.*|install_consumer|differential|cgal_programs|matrix_.*)$'

configure() {
  say "configuring $build/$1"
  cmake --preset "$1" -B "$build/$1" -DCGAL_DEMO_ARCHIVES_DIR="$demo_archives" > /dev/null
}

address() {
  configure asan
  cmake --build "$build/asan" -j "$jobs" -- -k || say "some programs do not compile"
  # The umbilics that CGAL hands out by pointers are not ours.
  printf '%s\n' leak:CGAL::Umbilic_approximation > "$build/asan/suppressions.txt"
  LSAN_OPTIONS="suppressions=$build/asan/suppressions.txt:print_suppressions=0" \
    ctest --test-dir "$build/asan" -j "$jobs" -E "$without_sanitizer" --output-on-failure || failed=1
}

# Leaves the folder of a libtbb.so with the thread sanitizer in tbb.
build_tbb() {
  folder=$build/tbb-thread
  if [ ! -e "$folder/complete" ]; then
    rm -rf "$folder"
    mkdir -p "$folder/lists/partial" "$folder/cache/archives/partial"
    mirror=$(debian_mirror)
    suite=$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)
    echo "deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $mirror $suite main" > "$folder/sources.list"
    set -- -q -o Dir::Etc::SourceList="$folder/sources.list" -o Dir::Etc::SourceParts=- \
      -o Dir::State::Lists="$folder/lists" -o Dir::Cache="$folder/cache" -o APT::Sandbox::User="$(id -un)"
    apt-get "$@" update > "$folder/log" 2>&1
    (cd "$folder" && apt-get "$@" source --download-only onetbb >> log 2>&1 && mkdir source &&
      tar -xf onetbb_*.orig.tar.* -C source --strip-components=1)
    say "building TBB for the thread sanitizer"
    cmake -S "$folder/source" -B "$folder/build" -DCMAKE_CXX_COMPILER=g++ -DCMAKE_C_COMPILER=gcc \
      -DCMAKE_BUILD_TYPE=RelWithDebInfo -DTBB_TEST=OFF -DTBB_STRICT=OFF -DTBB_SANITIZE=thread >> "$folder/log"
    cmake --build "$folder/build" --target tbb -j "$jobs" >> "$folder/log" 2>&1
    touch "$folder/complete"
  fi
  tbb=$(dirname "$(find "$folder/build" -name libtbb.so)")
}

thread() {
  build_tbb
  configure tsan
  for name in faults parallel_doors user_parallelism; do
    cmake --build "$build/tsan" --target "test_$name"
  done
  LD_LIBRARY_PATH=$tbb ctest --test-dir "$build/tsan" -R '^(faults|parallel_doors|user_parallelism)$' --output-on-failure || failed=1

  say "a deliberate race"
  raced=$build/tsan/race/CGAL/Jet_fitting_3/internal/machine
  mkdir -p "$raced"
  sed "s/std::atomic<std::size_t> next/std::size_t next/" include/CGAL/Jet_fitting_3/internal/machine/parallel.h \
    > "$raced/parallel.h"
  g++ -std=c++17 -O1 -g1 -fsanitize=thread -Wno-tsan -DCGAL_EIGEN3_ENABLED -DCGAL_LINKED_WITH_TBB \
    -I"$build/tsan/race" -Iinclude -isystem /usr/include/eigen3 test/Jet_fitting_3/parallel_doors.cpp \
    -o "$build/tsan/race/parallel_doors" -ltbb -lgmp -lmpfr
  if LD_LIBRARY_PATH=$tbb TSAN_OPTIONS=halt_on_error=1 "$build/tsan/race/parallel_doors" > "$build/tsan/race/log" 2>&1 ||
      ! grep -q 'data race' "$build/tsan/race/log"; then
    say "the thread sanitizer does not see it"
    failed=1
  else
    say "is found, as it must be"
  fi
}

valgrind() {
  install_missing valgrind
  configure valgrind
  cmake --build "$build/valgrind" -j "$jobs"
  for folder in examples demo; do
    ctest --test-dir "$build/valgrind/$folder/Jet_fitting_3" -j "$jobs" --output-on-failure || failed=1
  done
}

[ $# -gt 0 ] || set -- address thread valgrind
for kind in "$@"; do
  case $kind in
    address) address ;;
    thread) thread ;;
    valgrind) valgrind ;;
    *) say "unknown: $kind"; exit 2 ;;
  esac
done
[ "$failed" -eq 0 ] || say "there are findings"
exit "$failed"
