#!/bin/sh
# Every C++ code block of README.md, CONTRIBUTING.md and the manual is a run of lines of an example, test or header that is
# compiled, up to indentation; every command in a block of shell lines names a file that is there.
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

# blocks <file> <first line> <last line> <prefix>: writes what is between these lines to <prefix>1, <prefix>2, ...
blocks() {
  begin=$2 end=$3 prefix=$4 awk '
    inside && $0 == ENVIRON["end"] { inside = 0; close(file) }
    inside { print > file }
    !inside && $0 == ENVIRON["begin"] { inside = 1; file = ENVIRON["prefix"] (++n); printf "" > file }' "$1"
}

# What is compiled: what a CMakeLists.txt names, and the headers beside it.
compiled="$(for folder in examples/Jet_fitting_3 test/Jet_fitting_3; do
  tr -c 'A-Za-z0-9_./' '\n' < $folder/CMakeLists.txt | sort -u | while read -r word; do
    for file in "$folder/$word" "$folder/$word.cpp"; do
      case $file in *.cpp) [ ! -f "$file" ] || echo "$file" ;; esac
    done
  done
  find $folder -maxdepth 2 -name '*.h'
done | sort -u) $(find include -name '*.h')"

# is_in_a_compiled_file <block>
is_in_a_compiled_file() {
  # shellcheck disable=SC2086
  awk '
    function stripped(text) { sub(/^ +/, "", text); return text }
    FNR == 1 { ++file }
    file == 1 { block[++size] = stripped($0); next }
    found { next }
    {
      line[FNR] = stripped($0)
      same = FNR >= size
      for (i = 1; i <= size && same; ++i) same = line[FNR - size + i] == block[i]
      if (same) { found = 1; print FILENAME ":" FNR - size + 1 }
    }
    END { exit !found }' "$1" $compiled
}

for text in README.md CONTRIBUTING.md; do
  blocks "$text" '```cpp' '```' "$scratch/cpp_$text."
  blocks "$text" '```sh' '```' "$scratch/sh_$text."
done
for text in doc/Jet_fitting_3/*.txt; do
  blocks "$text" '\code{.cpp}' '\endcode' "$scratch/cpp_$(basename "$text")."
done

count=0
for block in "$scratch"/cpp_*; do
  count=$((count + 1))
  [ -s "$block" ] || fail "an empty block: ${block#"$scratch"/cpp_}"
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

# Every example is listed in the manual.
for example in examples/Jet_fitting_3/*.cpp; do
  grep -qx "\\\\example Jet_fitting_3/$(basename "$example")" doc/Jet_fitting_3/examples.txt ||
    fail "doc/Jet_fitting_3/examples.txt has no $(basename "$example")"
done

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
