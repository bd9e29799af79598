#!/bin/sh
# Compiles tests for processors and systems that are not this one, and runs them: ARM with 64 bits, which has other
# registers; IBM's s390x, which has the high byte first; Windows by MinGW, where there is Wine (else they are only
# linked). Files of the program are written on one processor and read on another. CGAL and Boost are headers: those of
# this system, without GMP.
# usage: other_processors.sh
# shellcheck source=scripts/lib.sh
. "$(dirname "$0")/lib.sh"

install_missing g++-aarch64-linux-gnu g++-s390x-linux-gnu g++-mingw-w64-x86-64-posix qemu-user \
  libboost-dev libcgal-dev libeigen3-dev

folder=$build/other_processors
mkdir -p "$folder/include"
for library in CGAL boost; do # alone: the other headers of this system are not those of the others
  ln -sfn "/usr/include/$library" "$folder/include/$library"
done
failed=

# compile <compiler> <source> <program> [argument]...
compile() {
  compiler=$1
  source=$2
  program=$3
  shift 3
  if ! "$compiler" -std=c++17 -O1 -Wall -Wextra -Wno-psabi -Iinclude -isystem "$folder/include" \
      -isystem /usr/include/eigen3 -DCGAL_EIGEN3_ENABLED -DCGAL_DISABLE_GMP "$@" "$source" -o "$program" \
      > "$program.log" 2>&1; then
    failed="$failed $program"
    say "$program does not compile:"
    head -n 40 "$program.log"
    return 1
  fi
}

# run <command>...
run() {
  say "$*"
  "$@" || failed="$failed $1:$(basename "$2")"
}

say "compiling"
for processor in aarch64 s390x; do
  for test in other_processors packs; do
    program=$folder/${test}_$processor
    compile "$processor-linux-gnu-g++" "test/Jet_fitting_3/$test.cpp" "$program" -static || continue
    run "qemu-$processor" "$program"
  done
done

for processors in "aarch64 s390x" "s390x aarch64"; do
  writer=${processors% *}
  reader=${processors#* }
  mkdir -p "$folder/from_$writer"
  run "qemu-$writer" "$folder/other_processors_$writer" write "$folder/from_$writer"
  run "qemu-$reader" "$folder/other_processors_$reader" read "$folder/from_$writer"
done

windows=x86_64-w64-mingw32-g++-posix
program=$folder/other_processors.exe
if compile "$windows" test/Jet_fitting_3/other_processors.cpp "$program" -static -D_USE_MATH_DEFINES -Wa,-mbig-obj &&
    command -v wine > /dev/null; then
  run wine "$program"
fi
# The whole program, of whose libraries there is none for Windows here.
compile "$windows" demo/Jet_fitting_3/Mesh_estimation.cpp "$folder/Mesh_estimation.obj" -c -D_USE_MATH_DEFINES \
  -Wa,-mbig-obj || true

[ -z "$failed" ] || { say "FAILED:$failed"; exit 1; }
say "passed"
