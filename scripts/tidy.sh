#!/bin/sh
# Runs clang-tidy 14 with .clang-tidy over our headers, by way of the test programs that use them.
# usage: tidy.sh [<test program>...]     (names without .cpp; default: all)
# shellcheck source=scripts/lib.sh
. "$(dirname "$0")/lib.sh"

command -v clang-tidy-14 > /dev/null || install_missing clang-tidy-14
cmake --preset clang -B "$build/tidy" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON > /dev/null
if [ $# -eq 0 ]; then
  set -- $(sed -n 's|^ *"file": ".*/test/Jet_fitting_3/\([^/]*\)\.cpp",*$|\1|p' "$build/tidy/compile_commands.json")
fi
for name in "$@"; do
  echo "test/Jet_fitting_3/$name.cpp"
done | xargs -P "$jobs" -n 1 clang-tidy-14 -quiet -p "$build/tidy"
