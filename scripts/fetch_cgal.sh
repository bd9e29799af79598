#!/bin/sh
# Unpacks the CGAL and Eigen of another Debian release into the build folder, once; nothing is installed.
# usage: fetch_cgal.sh <suite of Debian>
# Prints the folder; exits with 77 and one line on stderr where the packages cannot be reached.
# shellcheck source=scripts/lib.sh
. "$(dirname "$0")/lib.sh"

suite=$1
folder=$build/cgal-$suite
if [ -e "$folder/complete" ]; then
  echo "$folder"
  exit
fi

skip() {
  echo "fetch_cgal.sh: $*: CGAL of Debian $suite is left out" >&2
  exit 77
}

command -v apt-get > /dev/null || skip "there is no apt-get"
mirror=$(debian_mirror)
[ -n "$mirror" ] || skip "the apt sources of this system name no mirror"

rm -rf "$folder"
mkdir -p "$folder/apt/lists/partial" "$folder/apt/cache/archives/partial" "$folder/packages"
echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $mirror $suite main" > "$folder/apt/sources.list"
own_apt() {
  apt-get -q -o Dir::Etc::SourceList="$folder/apt/sources.list" -o Dir::Etc::SourceParts=- -o Dir::State::Lists="$folder/apt/lists" \
    -o Dir::Cache="$folder/apt/cache" -o APT::Sandbox::User="$(id -un)" -o Acquire::Retries=2 -o Acquire::http::Timeout=20 "$@"
}
own_apt update > "$folder/apt/log" 2>&1 || skip "the mirror $mirror cannot be reached"
(cd "$folder/packages" && own_apt download libcgal-dev libcgal-demo libeigen3-dev) >> "$folder/apt/log" 2>&1 ||
  skip "the packages cannot be downloaded from $mirror"
for package in "$folder"/packages/*.deb; do
  dpkg-deb -x "$package" "$folder"
done
rm -rf "$folder/packages" "$folder/apt"
touch "$folder/complete"
echo "$folder"
