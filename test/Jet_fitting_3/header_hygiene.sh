#!/bin/sh
# Compiles each header as if alone, and reads off the compiler's dependency lists what the headers include.
# usage: header_hygiene.sh <root of the package> <scratch folder> <compiler> <version of CGAL or ""> <file of flags>
#        the flags lead to CGAL, Eigen, LAPACKE, TBB, where they are found: lines "I <folder>" and "D <macro>"
set -u
LC_ALL=C
export LC_ALL
root=$1 scratch=$2 compiler=$3 cgal_version=$4 flags=$5
set --
while read -r kind value; do
  case $kind$value in
    I | D | I/usr/include | I/usr/include/*-linux-gnu) ;; # given by -isystem they would hide the C++ library
    I*) set -- "$@" -isystem "$value" ;;
    D*) set -- "$@" "-D$value" ;;
  esac
done < "$flags"
rm -rf "$scratch"
mkdir -p "$scratch"
cd "$root/include" || exit 2
failures=0

fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

needs() {
  case $1 in
    CGAL/Lapack*) echo lapacke.h ;;
    CGAL/*/internal/*|CGAL/*/neighborhoods/*|CGAL/*/ridges/*|CGAL/*/ridges.h|CGAL/*/extract_*.h) echo CGAL/config.h ;;
    CGAL/*/prepared/*|CGAL/*/point_weight_map.h) echo CGAL/config.h ;;
    CGAL/Jet_fitting_3/*) ;;
    *) echo CGAL/config.h ;;
  esac
}

exists() {
  echo "#include <$1>" > "$scratch/exists.cpp"
  shift
  "$compiler" -std=c++17 "$@" -E "$scratch/exists.cpp" > /dev/null 2>&1
}

missing=
for library in lapacke.h CGAL/config.h; do exists "$library" "$@" || missing="$missing $library "; done

is_missing() {
  case $missing in
    *" $1 "*) true ;;
    *) false ;;
  esac
}

warnings="-Wall -Wextra -Wshadow -Wconversion -Wsign-conversion -Werror"
for header in $(find CGAL -name '*.h' | sort); do
  needed=$(needs "$header")
  if [ -n "$needed" ] && is_missing "$needed"; then
    echo "$header is left out: there is no $needed" >&2
    continue
  fi
  echo "$header $header"
  sed -n 's|^ *# *include *<\(CGAL/.*\)>.*|\1 '"$header"'|p' "$header"
done > "$scratch/includes"

# In the order of a chain each header includes those before, which so bring nothing that it lacks: it is compiled as if
# alone, but the libraries are read once for all of the chain.
tsort "$scratch/includes" | awk -v scratch="$scratch" '
  FNR == NR { if ($1 == $2) ours[$1]; else direct[$2] = direct[$2] " " $1; next }
  $1 in ours {
    count = split(direct[$1], included)
    for (i = 1; i <= count; ++i) {
      reached[$1, included[i]]
      below = split(all[included[i]], indirect)
      for (j = 1; j <= below; ++j) reached[$1, indirect[j]]
    }
    for (h in ours) if (($1, h) in reached) all[$1] = all[$1] " " h
    chain = 0
    for (c = 1; c <= chains; ++c)
      if (($1, last[c]) in reached && (!chain || length(all[last[c]]) > length(all[last[chain]]))) chain = c
    if (!chain) chain = ++chains
    last[chain] = $1
    unit = scratch "/chain_" chain ".cpp"
    printf "#include <%s>\n#include <%s>\n", $1, $1 > unit
  }' "$scratch/includes" -
find "$scratch" -name 'chain_*.cpp' | sed 's/\.cpp$//' |
  xargs -I '{}' "$compiler" -std=c++17 -fsyntax-only $warnings -I. "$@" -MD -MF '{}.d' '{}.cpp' ||
  fail "a header does not compile alone, or with a warning"

# Door (b), without any folder but our own: all it includes lies in CGAL/Jet_fitting_3/.
door=CGAL/Jet_fitting_3/Monge_via_jet_fitting.h
echo "#include <$door>" > "$scratch/door_b.cpp"
if "$compiler" -std=c++17 -I"$root/include" -M -MF "$scratch/door_b.d" "$scratch/door_b.cpp"; then
  foreign=$(tr ' \\' '\n\n' < "$scratch/door_b.d" | grep '/CGAL/' | grep -v "^$root/include/CGAL/Jet_fitting_3/")
  [ -z "$foreign" ] || fail "$door includes headers of CGAL: $foreign"
  grep -q "$door" "$scratch/door_b.d" || fail "the dependency list of $door is empty"
else
  fail "$door does not compile alone"
fi

# NaN could not be told from numbers: refused, with the reason, through each door.
for header in CGAL/Monge_via_jet_fitting.h CGAL/estimate_vertex_monge_forms.h CGAL/estimate_point_monge_forms.h "$door"; do
  if [ "$header" != "$door" ] && is_missing CGAL/config.h; then continue; fi
  for flag in -ffast-math -ffinite-math-only; do
    echo "#include <$header>" > "$scratch/fast_math.cpp"
    "$compiler" -std=c++17 -fsyntax-only "$flag" -I. "$@" "$scratch/fast_math.cpp" > "$scratch/fast_math.log" 2>&1 &&
      fail "$header compiles with $flag"
    grep -q 'error.*compile without -ffast-math' "$scratch/fast_math.log" || fail "$header: the reason against $flag is not told"
  done
done

# A user's global variables do not hide the functions that our headers call: all names that are called there are
# variables first, but those that the libraries keep for themselves.
if ! is_missing CGAL/config.h; then
  {
    grep -rho '#include <[^>]*>' CGAL | sed 's|#include <\(.*\)>|\1|' | sort -u | while read -r header; do
      [ -e "$header" ] || printf '#if __has_include(<%s>)\n#include <%s>\n#endif\n' "$header" "$header"
    done
    for header in Surface_mesh Polyhedron_3 Simple_cartesian; do echo "#include <CGAL/$header.h>"; done
  } > "$scratch/libraries.h"
  cat $(find CGAL -name '*.h') | sed 's|//.*||' | grep -oE '(^|[^A-Za-z0-9_.:>~])[a-z][a-z0-9_]* *\(' |
    grep -oE '[a-z][a-z0-9_]*' | sort -u | sed 's/.*/int & = 1;/' > "$scratch/variables.h"
  printf '#include "libraries.h"\n#include "variables.h"\n' > "$scratch/taken.cpp"
  while
    "$compiler" -std=c++17 -fsyntax-only -w -I. "$@" "$scratch/taken.cpp" 2>&1 |
      sed -n 's/^.*variables\.h:\([0-9]*\):[0-9]*: error.*/\1d/p' > "$scratch/taken"
    [ -s "$scratch/taken" ]
  do
    sed -f "$scratch/taken" "$scratch/variables.h" > "$scratch/left.h"
    mv "$scratch/left.h" "$scratch/variables.h"
  done
  grep -qx 'int cross = 1;' "$scratch/variables.h" || fail "no variable is named as a function of ours"
  cat > "$scratch/variables.cpp" << 'EOF'
#include "libraries.h"
#include "variables.h"
#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/estimate_noise.h>
#include <CGAL/estimate_point_monge_forms.h>
#include <CGAL/estimate_vertex_monge_forms.h>
#include <CGAL/Jet_fitting_3/extract_ridges.h>
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Form = CGAL::Monge_via_jet_fitting<Kernel>::Monge_form;
template <class Mesh, class Forms>
void use(Mesh& mesh, Forms forms, std::vector<Point> points)
{
  CGAL::estimate_vertex_monge_forms(mesh, CGAL::Jet_fitting::automatic(), forms);
  CGAL::estimate_vertex_monge_forms(mesh, CGAL::Jet_fitting::k_rings(2), forms);
  CGAL::estimate_noise(mesh);
  std::vector<Form> of_points;
  CGAL::estimate_point_monge_forms(points, CGAL::Jet_fitting::automatic(), std::back_inserter(of_points));
  CGAL::estimate_point_monge_forms(points, CGAL::Jet_fitting::nearest(20), std::back_inserter(of_points));
  CGAL::estimate_noise(points);
  CGAL::Monge_via_jet_fitting<Kernel>()(points.begin(), points.end(), 4, 4);
}
template void use(CGAL::Surface_mesh<Point>&, CGAL::Surface_mesh<Point>::Property_map<CGAL::SM_Vertex_index, Form>,
                  std::vector<Point>);
EOF
  "$compiler" -std=c++17 -fsyntax-only -w -I. "$@" "$scratch/variables.cpp" ||
    fail "a user's global variable hides a function of ours"
fi

# CGAL's headers name their package in the $URL$ line. As in CGAL, a package depends on all packages that a header of
# its own reaches; the list in package_info is that of CGAL 5.5.
case $cgal_version in
  5.5.*)
    cat "$scratch"/*.d | tr ' \\' '\n\n' | grep '/CGAL/' | grep -v "^\./\|^CGAL/\|^$root/" | sort -u |
      xargs sed -n 's|.*\$URL: .*/blob/[^/]*/\([^/]*\)/include/.*|\1|p' | sort -u | grep -vx Jet_fitting_3 \
      > "$scratch/dependencies"
    diff "$root/package_info/Jet_fitting_3/dependencies" "$scratch/dependencies" ||
      fail "package_info/Jet_fitting_3/dependencies (<) is not what the headers include (>)"
    ;;
  *) echo "package_info/dependencies is not compared: it is the list for CGAL 5.5, here is CGAL '$cgal_version'" ;;
esac

echo "header_hygiene: $(awk '$1 == $2' "$scratch/includes" | wc -l) headers, $failures failures"
[ "$failures" -eq 0 ]
