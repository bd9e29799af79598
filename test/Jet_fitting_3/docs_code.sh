#!/bin/sh
# Every C++ code block of README.md, CONTRIBUTING.md and the manual is a run of lines of an example or test that is
# compiled, up to a common indentation; every command in a block of shell lines names a file that is there.
# usage: docs_code.sh <root of the package>
set -u
LC_ALL=C
export LC_ALL
cd "$1" || exit 2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0

fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

# blocks <file> <begin> <end> <prefix>: writes the lines between begin and end to <prefix>1, <prefix>2, ...
blocks() {
  awk -v begin="$2" -v end="$3" -v prefix="$4" '
    inside && $0 ~ end { inside = 0; close(file) }
    inside { print > file }
    !inside && $0 ~ begin { inside = 1; file = prefix ++n; printf "" > file }' "$1"
}

# What is compiled: what a CMakeLists.txt names, and the headers beside it.
compiled=$(for folder in examples/Jet_fitting_3 test/Jet_fitting_3; do
  tr -c 'A-Za-z0-9_./' '\n' < $folder/CMakeLists.txt | sort -u | while read -r word; do
    for file in "$folder/$word" "$folder/$word.cpp"; do
      case $file in *.cpp) [ ! -f "$file" ] || echo "$file" ;; esac
    done
  done
  find $folder -maxdepth 2 -name '*.h'
done | sort -u)

# is_in_a_compiled_file <block>
is_in_a_compiled_file() {
  # shellcheck disable=SC2086
  awk '
    function stripped(line) { sub(/^ +/, "", line); return line }
    FNR == 1 { ++file; matched = 0 }
    file == 1 { block[++n] = stripped($0); if ($0 !~ /^ *$/ || n > 1) size = n; next }
    found { next }
    {
      # matched lines so far; on a mismatch the search starts again behind the first of them
      line[FNR] = stripped($0)
      for (start = FNR - size + 1; start > 0; start = 0) {
        same = 1
        for (i = 1; i <= size && same; ++i) same = line[start + i - 1] == block[i]
        if (same) { found = 1; print FILENAME ":" start }
      }
    }
    END { exit !found }' "$1" $compiled
}

for text in README.md CONTRIBUTING.md; do
  blocks "$text" '^```(cpp|c\+\+)$' '^```$' "$scratch/cpp_$text."
  blocks "$text" '^```sh$' '^```$' "$scratch/sh_$text."
done
for text in doc/Jet_fitting_3/*.txt; do
  blocks "$text" '^\\code\{.cpp\}$' '^\\endcode$' "$scratch/cpp_$(basename "$text")."
done

count=0
for block in "$scratch"/cpp_*; do
  count=$((count + 1))
  is_in_a_compiled_file "$block" || fail "this block of ${block#"$scratch"/cpp_} is in no compiled example:
$(cat "$block")"
done
[ "$count" -ge 8 ] || fail "only $count code blocks were found"

for block in "$scratch"/sh_*; do
  # shellcheck disable=SC2013
  for file in $(grep -oE '(scripts|benchmark|examples|test)/[A-Za-z0-9_./-]*\.sh' "$block"); do
    [ -f "$file" ] || fail "${block#"$scratch"/sh_} names $file, which is not there"
  done
done

# The first example of the README is the program as a whole.
whole=$(sed '1,/^$/d' examples/Jet_fitting_3/first_example.cpp)
[ "$(cat "$scratch/cpp_README.md.1")" = "$whole" ] ||
  fail "the first block of README.md is not examples/Jet_fitting_3/first_example.cpp behind its header"

# Files that the texts name in backquotes are there.
for text in README.md CONTRIBUTING.md; do
  grep -oE '`[a-z_]+/[A-Za-z0-9_./-]+`' "$text" | tr -d '`' | sort -u | while read -r file; do
    case $file in build/*) continue ;; esac
    [ -e "$file" ] || [ -e "include/$file" ] || echo "$text: $file"
  done
done > "$scratch/missing"
[ ! -s "$scratch/missing" ] || fail "these files are named, but not there:
$(cat "$scratch/missing")"

# The check itself: a line that no program has must not be found.
echo 'this is in no program;' > "$scratch/nowhere"
is_in_a_compiled_file "$scratch/nowhere" && fail "a line was found that no program has"

echo "docs_code: $count code blocks, $failures failures"
[ "$failures" -eq 0 ]
