#!/bin/sh
# The main job on real input: curvatures, principal directions and ridges of a scanned shape and of the paper's Bezier
# surface, with a summary and pictures. On Debian 12 it installs what is missing; it can be run again.
# shellcheck source=scripts/lib.sh
. "$(dirname "$0")/lib.sh"

install_missing g++ make cmake libcgal-dev libcgal-demo libeigen3-dev libboost-program-options-dev libtbb-dev povray
find_demo_archives

say "configuring $build/demo"
cmake --preset release -B "$build/demo" -DJET_FITTING_3_TESTS=OFF -DCGAL_DEMO_ARCHIVES_DIR="$demo_archives"
say "building with -O3"
cmake --build "$build/demo" -j "$jobs" --target Single_estimation Mesh_estimation bezier_surface

examples=$build/demo/examples/Jet_fitting_3
demo=$build/demo/demo/Jet_fitting_3
meshes=$build/demo/cgal_demo/data/meshes
results=$build/demo/results
rm -rf "$results"
mkdir -p "$results"
cd "$results"

say "one point: the Monge form from 30 points"
"$examples/Single_estimation" "$root/examples/Jet_fitting_3/data/in_points_d4.txt" 4 4 | tee Single_estimation.txt

say "a scanned shape: curvatures, directions, crest lines, pictures"
view="--view 0.2,0.2,1 --up 0,1,0 --width 900 --height 700"
# shellcheck disable=SC2086
"$demo/Mesh_estimation" "$meshes/bunny00.off" -d 4 -a 4 -o bunny.ply bunny.vtp --directions bunny_directions.vtp \
  --ridges crest --min-strength 3 --ridges-output bunny_crests.vtp bunny_crests.obj \
  --color none $view --picture bunny_crests.png
# shellcheck disable=SC2086
"$demo/Mesh_estimation" "$meshes/bunny00.off" -q -d 4 -a 4 --no-quality -o bunny_curvatures.csv \
  --color H --percentile 4 $view --picture bunny_mean_curvature.png

say "the Bezier surface of the paper: all ridges and umbilics"
"$examples/bezier_surface" bezier_surface.off
"$demo/Mesh_estimation" bezier_surface.off -d 4 -a 4 -o bezier_surface.ply --ridges all \
  --ridges-output bezier_ridges.vtp bezier_ridges.obj --draw umbilics --color none --view 0.25,-0.7,1 \
  --width 900 --height 700 --picture bezier_ridges.png

say "the results and pictures (.png) are in $results:"
ls -l "$results"
