#!/bin/sh
# Builds the manual. Fails on a warning of doxygen, and those include: a public name without documentation, a parameter
# that is left out, a link that leads nowhere, an example or figure that is not there.
# usage: docs_build.sh <doxygen> <configured Doxyfile> <scratch folder>
set -u
LC_ALL=C
export LC_ALL
doxygen=$1 config=$2 scratch=$3
failures=0

fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

# build <folder for the pages> [<more input>]: prints the warnings
build() {
  mkdir -p "$1"
  {
    cat "$config"
    printf 'OUTPUT_DIRECTORY = "%s"\nWARN_LOGFILE = "%s/warnings"\n' "$1" "$1"
    [ $# -lt 2 ] || printf 'INPUT += "%s"\n' "$2"
  } > "$1/Doxyfile"
  "$doxygen" "$1/Doxyfile" > "$1/log" 2>&1 || fail "doxygen exits with $?"
  cat "$1/log" "$1/warnings"
}

rm -rf "$scratch"
warnings=$(build "$scratch/manual")
[ -z "$warnings" ] || fail "the manual builds with warnings:
$warnings"

html=$scratch/manual/html
for page in index.html group__PkgJetFitting3Ref.html classCGAL_1_1Monge__via__jet__fitting.html \
  classNeighborhood.html Jet_fitting_3_2first_example_8cpp-example.html conventions.svg; do
  [ -s "$html/$page" ] || fail "there is no $page"
done
grep -l 'class="math"' "$html/index.html" > /dev/null || fail "the formulas were not turned into HTML"
grep -lE '\\f[$[]|\\cgal[A-Z]' "$html"/*.html && fail "these pages show commands that nobody understood"
grep -lE '(src|href)="(https?:)?//' "$html"/*.html | while read -r page; do
  grep -oE '(src)="(https?:)?//[^"]*"' "$page"
done | grep . && fail "these are fetched from the network"

# The check itself: an undocumented member, and a link to nowhere, must be found.
mkdir -p "$scratch/bad_input"
cat > "$scratch/bad_input/bad.h" << 'END'
namespace CGAL {
namespace Jet_fitting {
/// Refers to \ref nowhere_at_all.
struct Badly_documented
{
  void forgotten_member() const;
};
}
}
END
warnings=$(build "$scratch/bad" "$scratch/bad_input")
for word in forgotten_member nowhere_at_all; do
  echo "$warnings" | grep -q "$word" || fail "doxygen did not complain about $word"
done

echo "docs_build: $(find "$html" -name '*.html' | wc -l) pages, $failures failures"
[ "$failures" -eq 0 ]
