#!/bin/sh
# A large set of points, cut into files (tiles) of one folder: estimates each by a job of its own, with neighbors from the
# others, so that all results together are those of the whole. After a failure run it again: tiles that have a result are
# left as they are.
#
# usage: run_tiles.sh [-e engine] [-j jobs] [-t threads] [-H hosts] [-n rounds] [-o format] <tiles> <results> <option>...
#   -e   slurm: an array of jobs (sbatch takes further options from its variables SBATCH_*); parallel: GNU parallel;
#        xargs. The first of these that is installed
#   -j   how many jobs at a time (slurm: as many as there is room for; else: as many as processors)
#   -t   threads of each job (1)
#   -H   a file of hosts for GNU parallel, a line each, as its --sshloginfile. They see the same folders
#   -n   how often a tile is tried (3)
#   -o   ply or csv: the format of the results (ply)
#   the options are those of Mesh_estimation, -p or -r among them. MESH_ESTIMATION is the program, if not in the PATH
set -eu
LC_ALL=C
export LC_ALL

fail() {
  echo "run_tiles.sh: $*" >&2
  exit 2
}

# The result of the tile that is line $3 of the list in folder $1: its box, or its forms ($2).
job() {
  cd "$1"
  tile=$(sed -n "$3p" tiles.list)
  name=$(basename "${tile%.*}")
  # shellcheck source=/dev/null
  . ./settings
  if [ "$2" = box ]; then
    "$program" "$tile" --box > "boxes/$name.part" 2> "logs/$name.log" && mv "boxes/$name.part" "boxes/$name"
    return
  fi
  set --
  while IFS= read -r option; do
    set -- "$@" "$option"
  done < options
  "$program" "$tile" --context tiles.boxes -o "$name.$format" -t "$threads" "$@" > "logs/$name.log" 2>&1
}

if [ "${1:-}" = --job ]; then
  job "$2" "$3" "$4"
  exit
fi
if [ "${1:-}" = --slurm-job ]; then # of an array: its number is that of a line of the list of what is missing
  job "$2" "$3" "$(sed -n "$((SLURM_ARRAY_TASK_ID + $4))p" "$2/missing")"
  exit
fi

engine='' jobs='' threads=1 hosts='' rounds=3 format=ply
while getopts e:j:t:H:n:o: option; do
  case $option in
    e) engine=$OPTARG ;;
    j) jobs=$OPTARG ;;
    t) threads=$OPTARG ;;
    H) hosts=$(readlink -f "$OPTARG") ;;
    n) rounds=$OPTARG ;;
    o) format=$OPTARG ;;
    *) exit 2 ;;
  esac
done
shift $((OPTIND - 1))
[ $# -ge 3 ] || fail "usage: run_tiles.sh [-e engine] [-j jobs] [-t threads] [-H hosts] [-n rounds] [-o format] tiles results options"
tiles=$(readlink -f "$1")
mkdir -p "$2/boxes" "$2/logs"
results=$(readlink -f "$2")
shift 2
self=$(readlink -f "$0")
program=$(command -v "${MESH_ESTIMATION:-Mesh_estimation}") || fail "no program Mesh_estimation: MESH_ESTIMATION may name it"
program=$(readlink -f "$program")
if [ -z "$engine" ]; then
  if command -v sbatch > /dev/null; then
    engine=slurm
  elif command -v parallel > /dev/null; then
    engine=parallel
  else
    engine='xargs'
  fi
fi
case $engine in
  slurm | parallel | xargs) ;;
  *) fail "-e takes slurm, parallel or xargs" ;;
esac

# What is in the folder already must be of the same options.
printf '%s\n' "$@" > "$results/options.new"
if [ -e "$results/options" ] && ! cmp -s "$results/options" "$results/options.new"; then
  fail "$results has results of other options: $(tr '\n' ' ' < "$results/options")"
fi
mv "$results/options.new" "$results/options"
printf "program='%s' threads='%s' format='%s'\n" "$program" "$threads" "$format" > "$results/settings"

# And of the same tiles: one more would change the results around it.
find "$tiles" -maxdepth 1 -type f \( -name '*.xyz' -o -name '*.pwn' -o -name '*.ply' -o -name '*.las' \) | sort > "$results/tiles.new"
[ -s "$results/tiles.new" ] || fail "$tiles has no files of points"
if [ -e "$results/tiles.list" ] && ! cmp -s "$results/tiles.list" "$results/tiles.new"; then
  fail "$results has results of other tiles than those in $tiles"
fi
mv "$results/tiles.new" "$results/tiles.list"
number=$(wc -l < "$results/tiles.list")
[ "$(sed 's|.*/||; s|\.[^.]*$||' "$results/tiles.list" | sort -u | wc -l)" -eq "$number" ] || fail "two tiles of one name"

# The numbers of the tiles without a box, or a result ($1), into the file `missing`.
find_missing() {
  n=0
  while IFS= read -r tile; do
    n=$((n + 1))
    name=$(basename "${tile%.*}")
    if [ "$1" = box ]; then result=boxes/$name; else result=$name.$format; fi
    [ -e "$results/$result" ] || echo "$n"
  done < "$results/tiles.list" > "$results/missing"
  [ -s "$results/missing" ]
}

# As many jobs as there are lines in `missing`; which of them fail is seen from their results.
run_xargs() {
  xargs -P "${jobs:-$(nproc)}" -n 1 sh "$self" --job "$results" "$1" < "$results/missing"
}

run_parallel() {
  if [ -n "$hosts" ]; then set -- "$1" --sshloginfile "$hosts"; fi
  kind=$1
  shift
  parallel --will-cite -q ${jobs:+-j "$jobs"} "$@" sh "$self" --job "$results" "$kind" '{}' < "$results/missing"
}

# Arrays of at most a thousand, which is what Slurm takes by default.
run_slurm() {
  count=$(wc -l < "$results/missing")
  first=0
  while [ "$first" -lt "$count" ]; do
    size=$((count - first < 1000 ? count - first : 1000))
    sbatch --quiet --wait --job-name "tiles_$1" --cpus-per-task "$threads" --array "1-$size${jobs:+%$jobs}" \
      --output /dev/null "$self" --slurm-job "$results" "$1" "$first" || true
    first=$((first + size))
  done
}

# All tiles of one kind of job, with those that fail again. \return whether all succeeded
run_all() {
  round=1
  while find_missing "$1"; do
    if [ "$round" -gt "$rounds" ]; then
      echo "run_tiles.sh: these have failed $rounds times:" >&2
      while read -r n; do
        tile=$(sed -n "${n}p" "$results/tiles.list")
        echo "  $tile: see $results/logs/$(basename "${tile%.*}").log" >&2
      done < "$results/missing"
      return 1
    fi
    echo "$1: $(wc -l < "$results/missing") of $number tiles by $engine, round $round"
    "run_$engine" "$1" || true
    round=$((round + 1))
  done
}

run_all box
sed 's|.*/||; s|\.[^.]*$||' "$results/tiles.list" | while IFS= read -r name; do cat "$results/boxes/$name"; done > "$results/tiles.boxes"
run_all tile
echo "$number tiles are done: $results"
