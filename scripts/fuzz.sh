#!/bin/sh
# Runs every fuzzer of test/Jet_fitting_3/fuzz with the address and the undefined behaviour sanitizer.
# usage: fuzz.sh [minutes for each harness]     (default: 10)
# New inputs go to <build>/fuzz/corpus_<name>, which is kept from run to run; the corpora in the repository are read only.
# Exits with 1 if there is a finding, 77 if there is no clang.
# shellcheck source=scripts/lib.sh
. "$(dirname "$0")/lib.sh"

minutes=${1:-10}
install_missing clang libclang-rt-14-dev libcgal-dev libeigen3-dev libboost-dev libboost-program-options-dev libgmp-dev libmpfr-dev
if ! command -v clang++ > /dev/null; then
  say "there is no clang++: nothing is fuzzed"
  exit 77
fi

folder=$build/fuzz
harnesses=$root/test/Jet_fitting_3/fuzz
mkdir -p "$folder"
failed=0
for name in class mesh readers; do
  say "building fuzz_$name"
  # CGAL's readers overflow an int on files that lie about their size
  clang++ -std=c++17 -g -O1 -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all \
    -fsanitize-ignorelist="$harnesses/ignored_sources.txt" -I"$root/include" -isystem /usr/include/eigen3 \
    "$harnesses/fuzz_$name.cpp" -o "$folder/fuzz_$name" -lboost_program_options -lgmp -lmpfr
done
for name in class mesh readers; do
  say "fuzz_$name for $minutes minutes"
  mkdir -p "$folder/corpus_$name" "$folder/found_$name"
  # the harness of the readers has its own operator new, libFuzzer does not know that
  ASAN_OPTIONS=alloc_dealloc_mismatch=0 "$folder/fuzz_$name" -max_total_time=$((minutes * 60)) -max_len=2600 \
    -len_control=0 -timeout=200 -rss_limit_mb=4000 -print_final_stats=1 -artifact_prefix="$folder/found_$name/" \
    "$folder/corpus_$name" "$harnesses/corpus_$name" > "$folder/$name.log" 2>&1 || failed=1
  grep -E 'number_of_executed_units|SUMMARY|does not hold|runtime error|what\(\)' "$folder/$name.log" || true
done
[ "$failed" -eq 0 ] || say "findings: see $folder/found_*, and the logs beside them"
exit "$failed"
