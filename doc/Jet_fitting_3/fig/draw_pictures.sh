#!/bin/sh
# The pictures (.png) of this folder, by the program Mesh_estimation, which draws with povray.
# Usage: draw_pictures.sh <build folder>
# The build folder is build/demo after scripts/demo.sh; CGAL's data are unpacked there.
set -eu
build=$(cd "$1" && pwd)
program=$build/demo/Jet_fitting_3/Mesh_estimation
scan=$build/cgal_demo/data/meshes/bunny00.off
cd "$(dirname "$0")"
bezier=$(mktemp -d)/bezier_surface.off
trap 'rm -r "$(dirname "$bezier")"' EXIT
"$build/examples/Jet_fitting_3/bezier_surface" "$bezier"

of_scan() {
  "$program" "$scan" -q --no-quality --view 0.2,0.2,1 --up 0,1,0 --width 800 --height 620 "$@"
}
of_bezier() {
  "$program" "$bezier" -q --no-quality --view 0.25,-0.7,1 --width 800 --height 620 "$@"
}

of_scan --color H --percentile 4 --picture mean_curvature.png
# figure 2 of the paper, principal directions on a scan
of_scan -d 2 -a 5 --color none --draw directions --picture directions_scan.png
# figure 3, principal directions on the Bezier surface
of_bezier -d 4 -a 3 --color none --draw directions --picture directions_bezier.png
# figure 4, crest lines on a scan
of_scan -d 4 -a 4 --color none --ridges crest --min-strength 3 --picture crests_scan.png
# figure 5, all ridges and umbilics of the Bezier surface
of_bezier -d 4 -a 4 --color none --ridges all --draw umbilics --picture ridges_bezier.png
# standard errors of k1
of_scan -d 3 -a 4 --errors --color k1_error --picture error_bars.png
