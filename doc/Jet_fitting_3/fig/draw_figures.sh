#!/bin/sh
# Draws the figures of the manual that are not pictures of data: <name>.svg from <name>.awk.
# usage: draw_figures.sh [folder to write to]
set -eu
LC_ALL=C
export LC_ALL
here=$(cd "$(dirname "$0")" && pwd)
draw() {
  figure=$1
  shift
  awk "$@" -f "$here/svg.awk" -f "$here/$figure.awk" < /dev/null > "$folder/$figure.svg"
}
folder=${1-$here}
draw bases -f "$here/space.awk"
draw conventions -f "$here/space.awk"
draw neighborhoods
