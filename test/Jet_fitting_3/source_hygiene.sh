#!/bin/sh
# What CGAL's conventions and the architecture ask of the sources, as far as it can be read off their text.
# usage: source_hygiene.sh <root of the package>
set -u
LC_ALL=C
export LC_ALL
cd "$1" || exit 2
broken=$(mktemp)
trap 'rm -f "$broken"' EXIT

# Reports the lines of standard input, each one finding of the rule that is named.
findings() {
  found=$(cat)
  if [ -n "$found" ]; then
    echo "FAILED $1:"
    echo "$found"
    echo "$1" >> "$broken"
  fi
}

folders=$(ls -d include test examples demo benchmark doc cmake scripts .ci 2> /dev/null)
# shellcheck disable=SC2086
texts=$(find $folders CMakeLists.txt -type f \( -name '*.h' -o -name '*.cpp' -o -name '*.cmake' -o -name '*.in' -o \
  -name 'CMakeLists.txt' -o -name '*.sh' -o -path 'doc/*.txt' -o -path '.ci/*' \))
# shellcheck disable=SC2086
code=$(find $folders -type f \( -name '*.h' -o -name '*.cpp' \) ! -path 'doc/*')
headers=$(find include -type f -name '*.h')
tab=$(printf '\t')

# shellcheck disable=SC2086
grep -nI "[^ -~$tab]" $texts | findings "only ASCII"
# shellcheck disable=SC2086
grep -nE '^.{121}' $code $(find doc -name '*.h') | findings "no line over 120 columns"
# shellcheck disable=SC2086
grep -n "$tab" $texts | findings "no tabs"
# shellcheck disable=SC2086
grep -n ' $' $texts | findings "no trailing blanks"
for file in $texts; do
  [ -z "$(tail -c 1 "$file")" ] || echo "$file"
done | findings "a newline at the end"
find include -type f ! -name '*.h' | findings "include/ holds headers only"

for file in $code; do
  sed -n '1,5p' "$file" | grep -q '^// SPDX-License-Identifier: GPL-3.0-or-later$' || echo "$file"
done | findings "SPDX line in the header block"

for file in $headers; do
  guard=$(echo "${file#include/}" | tr 'a-z/.' 'A-Z__')
  grep -m 2 '^#' "$file" | tr '\n' ' ' | grep -q "^#ifndef $guard #define $guard $" || echo "$file: $guard"
  tail -n 1 "$file" | grep -q "^#endif // $guard\$" || echo "$file: the last line does not close $guard"
done | findings "include guards named after the path"

# shellcheck disable=SC2086
grep -nE '^using namespace|std::c(out|err)\b' $headers | findings "no using namespace and no output in headers"
# shellcheck disable=SC2086
grep -nE '^ *# *define ' $headers | grep -vE '# *define CGAL_' | findings "macros begin with CGAL_"

# Dependencies point one way; a folder is a room, its internal/ belongs to it. The first column is the room of the file, the
# second an include that it may not have.
for file in $headers; do
  sed -n "s|^ *# *include *[<\"]\([^>\"]*\)[>\"].*|$file \1|p" "$file"
done | awk '
  function room(path) {
    if (path !~ /^CGAL\//) return "other"
    if (path !~ /^CGAL\/Jet_fitting_3\//) return ours[path] ? "functions" : "CGAL"
    sub(/^CGAL\/Jet_fitting_3\//, "", path)
    if (path ~ /^internal\/[a-z]+\//) { sub(/^internal\//, "", path); sub(/\/.*/, "", path); return path }
    if (path ~ /^internal\//) return "kernels"
    if (path ~ /\//) { sub(/\/.*/, "", path); return path }
    if (path == "Options.h" || path == "Invalid_input.h") return "values"
    if (path ~ /^(Estimation_status|Estimation_summary|point_weight_map)\.h$/) return "reports"
    if (path ~ /^(Fit_options|Jet_surface|confidence_factor|ridges|Ridge_line|extract_ridges|extract_umbilics)\.h$/) return "forwarding"
    return path ~ /^estimation(_with_normals)?\.h$/ ? "estimation" : "class"
  }
  function also(name, rooms) { may[name] = name " " rooms }
  BEGIN {
    also("numeric", "")
    also("values", "numeric")
    also("steps", may["values"])
    also("solvers", may["values"])
    also("noise", may["steps"])
    also("estimation", may["noise"])
    also("scale", may["noise"])
    also("averaging", may["scale"])
    also("clouds", may["averaging"])
    also("class", may["estimation"] " solvers")
    also("surface", may["class"])
    also("reports", may["values"] " CGAL")
    also("kernels", "CGAL")
    also("machine", "CGAL")
    also("tables", "kernels machine values numeric CGAL")
    also("gathering", may["tables"] " scale")
    also("fitting", may["gathering"] " reports " may["class"] " functions surface " may["clouds"])
    also("neighborhoods", may["fitting"])
    also("prepared", may["neighborhoods"])
    also("functions", may["prepared"])
    also("ridges", may["functions"])
    may["forwarding"] = "*"
  }
  { file[NR] = $1; included[NR] = $2; sub(/^include\//, "", $1); from[NR] = $1; ours[$1] = 1 }
  END {
    for (i = 1; i <= NR; ++i) {
      a = room(from[i]); b = room(included[i])
      if (b != "other" && may[a] != "*" && index(" " may[a] " ", " " b " ") == 0)
        print file[i] " (" a ") includes " included[i] " (" b ")"
    }
  }' | findings "the direction of includes"

for file in $(find test examples demo benchmark -maxdepth 2 -name '*.cpp'); do
  grep -qw "$(basename "$file" .cpp)" "$(dirname "$file")/CMakeLists.txt" || echo "$file"
done | findings "each program is named in the CMakeLists.txt of its folder"

for file in copyright dependencies description.txt license.txt long_description.txt maintainer; do
  [ -s "package_info/Jet_fitting_3/$file" ] || echo "package_info/Jet_fitting_3/$file"
done | findings "package_info is complete"
sort -c package_info/Jet_fitting_3/dependencies 2>&1 | findings "package_info/dependencies is sorted"

sh scripts/format.sh --check | findings "clang-format changes nothing"

echo "source_hygiene: $(echo "$texts" | wc -l) files, $(wc -l < "$broken") rules broken"
[ ! -s "$broken" ]
