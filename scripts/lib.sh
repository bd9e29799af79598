# Sourced by the scripts of this folder: where things are, and how Debian packages get here.
# shellcheck shell=sh
# BUILD_DIR (default: build) is the folder for everything that is made, JOBS the number of compilers at a time.

set -eu
LC_ALL=C
export LC_ALL
root=$(cd "$(dirname "$0")/.." && pwd)
cd "$root"
mkdir -p "${BUILD_DIR:-build}"
build=$(cd "${BUILD_DIR:-build}" && pwd)

say() {
  printf '== %s\n' "$*"
}

# A compiler on CGAL's headers takes up to 2 GB.
default_jobs() {
  cores=$(nproc 2> /dev/null || echo 1)
  fitting=$(awk '/^MemAvailable:/ { print int($2 / 2000000) }' /proc/meminfo 2> /dev/null || echo 1)
  [ "${fitting:-1}" -ge 1 ] || fitting=1
  [ "$cores" -le "$fitting" ] && echo "$cores" || echo "$fitting"
}
jobs=${JOBS:-$(default_jobs)}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo > /dev/null; then
    sudo "$@"
  else
    say "only root can do this, and there is no sudo: $*"
    exit 1
  fi
}

is_installed() {
  dpkg-query -W -f '${Status}' "$1" 2> /dev/null | grep -q '^install ok installed$'
}

# install_missing <Debian package>...
install_missing() {
  if ! command -v dpkg-query > /dev/null; then
    say "not a Debian system: these packages, or their like, are taken to be there: $*"
    return
  fi
  missing=
  for package in "$@"; do
    is_installed "$package" || missing="$missing $package"
  done
  if [ -z "$missing" ]; then
    say "packages: nothing is missing"
    return
  fi
  say "installing$missing"
  as_root apt-get -q update || say "the package lists could not be updated: going on with those that are here"
  # shellcheck disable=SC2086
  as_root env DEBIAN_FRONTEND=noninteractive apt-get -q install -y --no-install-recommends $missing
}

# Sets demo_archives to the folder of CGAL's data.tar.gz and examples.tar.gz. Where dpkg is configured to leave out
# /usr/share/doc, as in small container images, the package is unpacked into the build folder.
find_demo_archives() {
  demo_archives=/usr/share/doc/libcgal-dev
  if [ -e "$demo_archives/data.tar.gz" ]; then
    return
  fi
  demo_archives=$build/libcgal-demo/usr/share/doc/libcgal-dev
  if [ ! -e "$demo_archives/data.tar.gz" ]; then
    say "unpacking libcgal-demo into $build/libcgal-demo"
    mkdir -p "$build/libcgal-demo"
    (cd "$build/libcgal-demo" && apt-get -q download libcgal-demo && dpkg-deb -x libcgal-demo_*.deb . && rm libcgal-demo_*.deb)
  fi
}

# The mirror that this system takes its own packages from; nothing if its sources name none.
debian_mirror() {
  apt-get --print-uris update 2> /dev/null | sed -n "s|^'\(http[^']*\)/dists/.*|\1|p" | grep -v security | head -n 1
}
