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
cmake --build "$build/demo" -j "$jobs" --target Single_estimation Mesh_estimation ridges_and_umbilics bezier_surface

programs=$build/demo/examples/Jet_fitting_3
meshes=$build/demo/cgal_demo/data/meshes
results=$build/demo/results
rm -rf "$results"
mkdir -p "$results"
cd "$results"

say "one point: the Monge form of the paper's form"
"$programs/Single_estimation" "$root/examples/Jet_fitting_3/data/in_points_d4.txt" 4 4 | tee Single_estimation.txt

say "a scanned shape"
"$programs/Mesh_estimation" -f "$meshes/bunny00.off" -d 4 -m 4
"$programs/ridges_and_umbilics" "$meshes/bunny00.off"

say "the Bezier surface of the paper"
"$programs/bezier_surface" bezier_surface.off
"$programs/Mesh_estimation" -f bezier_surface.off -d 4 -m 4
"$programs/ridges_and_umbilics" bezier_surface.off

say "the results are in $results:"
ls -l "$results"
