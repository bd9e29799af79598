#!/bin/sh
# Formats the sources with clang-format 14 and .clang-format; with --check only says which files would change.
set -eu
LC_ALL=C
export LC_ALL
cd "$(dirname "$0")/.."

format=
for candidate in clang-format-14 clang-format; do
  if command -v "$candidate" > /dev/null && "$candidate" --version | grep -q 'version 14\.'; then
    format=$candidate
    break
  fi
done
if [ -z "$format" ]; then
  echo "format.sh: clang-format 14 is not installed: the formatting is not looked at"
  exit 0
fi

sources=$(find include test examples demo benchmark -name '*.h' -o -name '*.cpp')
if [ "${1-}" = --check ]; then
  changes=0
  for source in $sources; do
    "$format" "$source" | cmp -s - "$source" || { echo "$source is not as clang-format leaves it"; changes=1; }
  done
  exit $changes
fi
# shellcheck disable=SC2086
"$format" -i $sources
