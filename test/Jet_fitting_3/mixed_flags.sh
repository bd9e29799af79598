#!/bin/sh
# One program of two files, one compiled with -march=native and the other without, linked in both orders: each file has the
# same bits as in a program where all is compiled as it is.
# usage: mixed_flags.sh <folder for the programs> <compiler> <include folder or flag>...
set -eu
here=$(cd "$(dirname "$0")" && pwd)/mixed_flags
work=$1
compiler=$2
shift 2
for folder in "$@"; do
  set -- "$@" "-I$folder"
  shift
done
rm -rf "$work"
mkdir -p "$work"
cd "$work"

# objects <kind> <flags>: <kind>_first.o and <kind>_second.o, the same but for the name of their function. Inline functions
# are not inlined but linked, as they are without optimization.
objects() {
  # shellcheck disable=SC2086
  "$compiler" -std=c++17 -O1 -fno-inline $2 -DCGAL_EIGEN3_ENABLED $includes -c "$here/part.cpp" -o "$1.o"
  for name in first second; do
    objcopy --redefine-sym "_Z4partv=_Z${#name}${name}v" "$1.o" "$1_$name.o"
  done
}
includes=$*
objects plain ""
objects native -march=native
"$compiler" -c "$here/both.cpp" -o both.o

# results <object> <object>: what the program prints, linked in that order
results() {
  "$compiler" both.o "$1.o" "$2.o" -o program -lgmp -lmpfr
  ./program
}
results plain_first plain_second > plain
results native_first native_second > native
half=$(($(wc -l < plain) / 2))
{ head -n "$half" plain; tail -n "$half" native; } > expected_plain_first
{ head -n "$half" native; tail -n "$half" plain; } > expected_native_first
failed=0
for order in "plain_first native_second" "native_second plain_first" "native_first plain_second" "plain_second native_first"; do
  case $order in *plain_first*) expected=expected_plain_first ;; *) expected=expected_native_first ;; esac
  # shellcheck disable=SC2086
  if ! results $order > mixed || ! cmp -s mixed "$expected"; then
    echo "FAILED: $order differs from the programs of one kind"
    failed=1
  fi
done
cmp -s plain native && echo "both flags give the same bits here: nothing was told apart"
echo "mixed_flags: $half forms a file, compared in four programs"
exit $failed
