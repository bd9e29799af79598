#!/bin/sh
# Builds CGAL's own programs with CGAL's header and with ours, runs both and compares what they write.
# usage: run_and_compare.sh <cmake> <build folder> <folder of the programs> <CGAL examples> <CGAL data> <our include folder>
#                           <package/program>...
set -u
LC_ALL=C
export LC_ALL
cmake=$1 build=$2 here=$3 examples=$4 data=$5 include=$6
shift 6
failures=0
compared=0

fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

# run <side> <package> <program> <arguments>...: in a fresh folder that holds the data of the example.
run() {
  side=$1 package=$2 program=$3
  shift 3
  folder=$here/runs/$side
  rm -rf "$folder"
  mkdir -p "$folder/data"
  [ ! -d "$examples/$package/data" ] || cp -R "$examples/$package/data/." "$folder/data"
  ln -s "$here/$side/$program" "$folder/$program"
  ln -s "$data/meshes" "$folder/meshes"
  cp "$here/sunflower.txt" "$folder"
  (cd "$folder" && "./$program" "$@" > stdout 2> stderr) || fail "$program ($side) $*: exit code $?"
}

# compare <package/program> <kind> <tolerance> <output> <arguments>...
# A program that writes nothing is only run: <kind> is "nothing" then.
compare() {
  package=${1%/*} program=${1#*/} kind=$2 tolerance=$3 output=$4
  shift 4
  case " $programs " in *" $package/$program "*) ;; *) return ;; esac
  echo "$program $*: $output"
  run theirs "$package" "$program" "$@"
  run ours "$package" "$program" "$@"
  compared=$((compared + 1))
  if [ "$kind" = nothing ]; then
    cmp "$here/runs/theirs/$output" "$here/runs/ours/$output" || fail "$program: $output differs"
  else
    "$here/compare_outputs" "$kind" "$tolerance" "$here/runs/theirs/$output" "$here/runs/ours/$output" ||
      fail "$program $*: $output differs"
  fi
}

# What the compiler says that a program depends on: in a file beside the object, or, of ninja, in its log.
dependencies() {
  if [ -f "$build/build.ninja" ]; then
    ninja -C "$build" -t deps | awk -v object="/$1.dir/.*/$2.cpp" '/^[^ ]/ { is_its = $0 ~ object } is_its'
  else
    find "$build" -path "*/$1.dir/*" -name "$2.cpp*.d" -exec cat {} +
  fi | tr ' ' '\n'
}

check_header() {
  program=${1#*/}
  taken=$(dependencies "${2}_$program" "$program" | grep 'CGAL/Monge_via_jet_fitting\.h$' | sort -u)
  echo "$program ($2) took $taken"
  case $2 in
    ours) [ "$taken" = "$include/CGAL/Monge_via_jet_fitting.h" ] || fail "$program was not built on our header" ;;
    theirs) case $taken in "" | "$include"/*) fail "$program was not built on CGAL's header" ;; esac ;;
  esac
}

programs=$*
"$cmake" --build "$build" --target cgal_programs || { echo "FAILED: the programs do not compile"; exit 1; }
for program in $programs; do
  check_header "$program" theirs
  check_header "$program" ours
done

# 60 points of a polynomial-like surface whose orders two to four are all present.
awk 'BEGIN {
  for (i = 0; i < 60; ++i) {
    r = 0.3 * sqrt(i / 60); t = 2.399963229728653 * i; x = r * cos(t); y = r * sin(t)
    z = 0.7 * x * x + 0.4 * x * y - 0.3 * y * y + 0.5 * x^3 - 0.8 * x * x * y + 0.3 * y^3 + 0.6 * sin(2 * x + y) * x * y
    printf "%.17g %.17g %.17g\n", x, y, z
  }
}' > "$here/sunflower.txt"

# Tolerances: CGAL rounds its samples at eps |P| before it fits, which its 9-37 neighbors at distances of |P|/100 carry
# to 1e-14 in the normal and up to 1e-11 in k; 1e-9 leaves two digits for other compilers. The points of
# normal_estimation lie at |P| = 1000 with 10 neighbors for 6 unknowns, where CGAL's own normals move by 6e-10
# between two optimization levels.
jets=Jet_fitting_3
compare $jets/Single_estimation form 1e-9 stdout
for degree in 2 3 4; do
  compare $jets/Single_estimation form 1e-9 stdout sunflower.txt $degree $degree
done
compare $jets/Mesh_estimation directions 1e-9 meshes_ellipe0.003.off.4ogl.txt -f meshes/ellipe0.003.off
compare $jets/Mesh_estimation directions 1e-9 meshes_ellipe0.003.off.4ogl.txt -f meshes/ellipe0.003.off -d 4 -m 4 -a 3
compare $jets/Mesh_estimation directions 1e-9 meshes_bunny00.off.4ogl.txt -f meshes/bunny00.off
compare $jets/Mesh_estimation numbers 1e-9 meshes_ellipe0.003.off.verb.txt -f meshes/ellipe0.003.off -v true

for program in Compute_Ridges_Umbilics Ridges_Umbilics_SM Ridges_Umbilics_LCC; do
  set -- -f meshes/ellipe0.003.off
  compare Ridges_3/$program numbers 1e-9 stdout "$@"
  compare Ridges_3/$program numbers 1e-9 data/meshes_ellipe0.003.offRIDGES-d3-m3-t3-a0-p0.4ogl.txt "$@"
  compare Ridges_3/$program numbers 1e-9 data/meshes_ellipe0.003.offRIDGES-d4-m4-t4-a0-p0.4ogl.txt "$@" -d 4 -m 4 -t 4
  compare Ridges_3/$program numbers 1e-9 stdout
done
compare Ridges_3/Compute_Ridges_Umbilics numbers 1e-9 data/meshes_bunny00.offRIDGES-d3-m3-t3-a0-p0.4ogl.txt \
  -f meshes/bunny00.off

points=Point_set_processing_3
compare $points/jet_smoothing_example nothing - stdout
compare $points/callback_example nothing - stdout
compare $points/normal_estimation normals 1e-7 ChineseDragon-10kv.pwn
compare $points/scale_estimation_example numbers 1e-9 stdout
compare $points/orient_scanlines_example nothing - stdout

# Programs whose later steps (random sampling, Delaunay ties) magnify the last bit of a normal: counts and labels.
compare Property_map/custom_property_map numbers 1e-9 stderr
compare Point_set_3/point_set_algo numbers 1e-3 stderr
compare Classification/example_cluster_classification nothing - stdout
compare Poisson_surface_reconstruction_3/tutorial_example numbers 1e-9 stdout
compare Scale_space_reconstruction_3/scale_space_advancing_front numbers 1e-9 stderr

echo "cgal_programs: $compared comparisons, $failures failures"
[ "$failures" -eq 0 ] && [ "$compared" -gt 0 ]
