#!/bin/sh
# A point set in 4 x 4 tiles: the results of the tiles together are those of the whole, bit by bit, for the nearest points
# and for a radius; with each engine of scripts/run_tiles.sh that is here. Slurm is started on this machine, if it may be.
# usage: tiles.sh <program Mesh_estimation> <folder to work in> <run_tiles.sh>
set -eu
LC_ALL=C
export LC_ALL
program=$(readlink -f "$1")
run_tiles=$(readlink -f "$3")
rm -rf "$2"
mkdir -p "$2/tiles"
cd "$2"
work=$(pwd)
failures=0

fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

# A thin wavy plate, both sides with normals outwards, denser in a corner; points that occur twice, at borders of tiles; one
# far above. Tile i j holds x in [i, i + 1], y in [j, j + 1].
awk 'BEGIN {
  srand(1)
  for (n = 0; n < 4000; ++n) {
    x = 4 * rand(); y = 4 * rand()
    if (n % 4 == 0) { x = 1.3 * rand(); y = 1.3 * rand() }
    side = n % 3 == 0 ? -1 : 1
    zx = 0.3 * cos(x) * cos(y); zy = -0.3 * sin(x) * sin(y); s = side / sqrt(1 + zx * zx + zy * zy)
    line = sprintf("%.17g %.17g %.17g %.17g %.17g %.17g", x, y, 0.3 * sin(x) * cos(y) + 0.02 * side + 0.001 * rand(),
                   -zx * s, -zy * s, s)
    i = int(x); j = int(y)
    print line > sprintf("tiles/%d_%d.xyz", i, j)
    if (n % 40 == 0) print line > sprintf("tiles/%d_%d.xyz", (i + 1) % 4, j)
  }
  print "0.5 0.5 3 0 0 1" > "tiles/0_0.xyz"
}'
cat tiles/*.xyz > whole.xyz
mkdir tiles_without_normals
for tile in tiles/*.xyz; do
  cut -d ' ' -f 1-3 "$tile" > "tiles_without_normals/$(basename "$tile")"
done
cat tiles_without_normals/*.xyz > whole_without_normals.xyz

# compare <whole> <folder of tiles> <name> <engine> <option>...
compare() {
  whole=$1 tiles=$2 results=$3 engine=$4
  shift 4
  "$program" "$whole" "$@" -q -o "$results.csv" || fail "$results: the whole"
  # shellcheck disable=SC2086
  MESH_ESTIMATION=$program sh "$run_tiles" -e $engine -o csv "$tiles" "$results" "$@" > "$results.log" 2>&1 || {
    cat "$results.log" "$results"/logs/* || true
    fail "$results: the tiles"
    return
  }
  tail -q -n +2 "$results"/*.csv > "$results.union"
  tail -n +2 "$results.csv" | cmp - "$results.union" || fail "$results: the tiles are not the whole"
  echo "$results: $(wc -l < "$results.union") points in $(find "$results" -name '*.csv' | wc -l) tiles"
}

compare whole.xyz tiles nearest "xargs -j 2" -p 30
compare whole.xyz tiles radius "xargs -j 2" -r 0.35 -d 3
compare whole_without_normals.xyz tiles_without_normals without_normals "xargs -j 2" -p 25 -d 3 --robust tukey --no-orient

# Only what is missing is run again, and after a failure the others are there.
touch -d '2020-01-01' nearest/*.csv
rm nearest/1_1.csv
MESH_ESTIMATION=$program sh "$run_tiles" -e xargs -o csv tiles nearest -p 30 > again.log || fail "one tile again"
grep -q '^tile: 1 of 16 tiles' again.log || fail "one tile was missing: $(cat again.log)"
[ "$(find nearest -name '*.csv' -newermt 2021-01-01 | wc -l)" -eq 1 ] || fail "other tiles were run again"
tail -q -n +2 nearest/*.csv | cmp - nearest.union || fail "one tile again is not the same"
mkdir broken
cp tiles/0_*.xyz broken
echo "1 2 x" > broken/9_9.xyz
if MESH_ESTIMATION=$program sh "$run_tiles" -e xargs -n 2 -o csv broken broken_results -p 30 > broken.log 2>&1; then
  fail "a broken tile is no failure"
fi
grep -q '9_9.xyz: see' broken.log || fail "the broken tile is not named: $(cat broken.log)"
MESH_ESTIMATION=$program sh "$run_tiles" -e xargs -o csv tiles nearest -p 20 > other.log 2>&1 && fail "other options in the same folder"

# What the program refuses.
refuse() {
  "$program" "$@" -o refused.csv > refused.log 2>&1 && fail "not refused: $*"
  [ ! -e refused.csv ] || fail "a file is left behind: $*"
}
refuse tiles/0_0.xyz --context tiles/0_1.xyz
refuse tiles_without_normals/0_0.xyz --context tiles/0_1.xyz -p 20
refuse tiles/0_0.xyz -p 20 --context no_such_file.xyz
refuse tiles/0_0.xyz -p 20 --context broken/9_9.xyz

if command -v parallel > /dev/null; then
  compare whole.xyz tiles by_parallel "parallel -j 2" -p 30
  # Other machines: this one, by a command in place of ssh.
  cat > not_ssh << 'END'
#!/bin/sh
while [ "$1" != host ]; do shift; done
shift
[ "$1" != -- ] || shift
SHELL=/bin/sh # as sshd sets it
export SHELL
exec sh -c "$*"
END
  chmod +x not_ssh
  echo "1/$work/not_ssh host" > hosts
  compare whole.xyz tiles by_hosts "parallel -H hosts" -p 30
else
  echo "GNU parallel is not here"
fi

stop_slurm() {
  scontrol shutdown || true
  kill "$(cat munge/pid)" || true
}
may_start_slurm() {
  [ "$(id -u)" -eq 0 ] || return
  for command in sbatch slurmctld slurmd munged; do
    command -v "$command" > /dev/null || return
  done
}
if may_start_slurm; then
  host=$(hostname -s)
  mkdir -m 700 munge
  mkdir state spool
  dd if=/dev/urandom of=munge/key bs=1024 count=1 2> /dev/null
  chmod 400 munge/key
  cat > slurm.conf << END
ClusterName=tiles
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmctldPort=16817
SlurmdPort=16818
AuthInfo=socket=$work/munge.socket
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MpiDefault=none
NodeName=$host NodeAddr=127.0.0.1 CPUs=2
PartitionName=all Nodes=$host Default=YES
END
  SLURM_CONF=$work/slurm.conf
  export SLURM_CONF
  trap stop_slurm EXIT
  munged --force --key-file="$work/munge/key" --socket="$work/munge.socket" --pid-file="$work/munge/pid" \
    --log-file="$work/munge/log" --seed-file="$work/munge/seed"
  slurmctld -f slurm.conf
  slurmd -f slurm.conf -N "$host"
  compare whole.xyz tiles by_slurm slurm -p 30
else
  echo "Slurm is not here, or may not be started"
fi

echo "tiles: $failures failures"
[ "$failures" -eq 0 ]
