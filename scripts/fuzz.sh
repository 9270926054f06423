#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Fuzzes what the program reads: scripts/fuzz.sh [READER|all [SECONDS]], with address and undefined-behaviour sanitizers;
# `scripts/fuzz.sh list` names the readers. Prints a table, a row a reader. What a reader falls over is left in
# build/asan/fuzz/READER, its log too, and exit status 1 says so; what it has learnt is used the next time.
set -euo pipefail
cd "$(dirname "$0")/.."

reader=${1:-all}
export SECONDS_EACH=${2:-60}
scripts/build.sh asan fuzz_readers >&2
export FUZZER=$PWD/build/asan/tests/fuzz_readers
mapfile -t readers < <("$FUZZER" list)
case $reader in
  list)
    printf '%s\n' "${readers[@]}"
    exit 0
    ;;
  all) ;;
  *) readers=("$reader") ;;
esac

# | reader | executions | seconds | edges | faults |: libFuzzer ends at the first fault.
fuzz() {
  local folder=build/asan/fuzz/$1 log faults=0
  log=$folder/log.txt
  rm -rf "$folder/faults"
  mkdir -p "$folder"/{faults,corpus}
  "$FUZZER" "$1" -max_total_time="$SECONDS_EACH" -max_len=16384 -timeout=20 -print_funcs=0 -print_final_stats=1 \
    -artifact_prefix="$folder/faults/" "$folder/corpus" >"$log" 2>&1 || faults=1
  awk -v reader="$1" -v faults="$faults" -v most="$SECONDS_EACH" '
    /stat::number_of_executed_units/ { executions = $2 }
    / cov: / { for (i = 1; i < NF; i++) if ($i == "cov:") edges = $(i + 1) }
    /^Done .* runs in / { seconds = $5 }
    END { printf "| %s | %d | %d | %d | %d |\n", reader, executions, seconds ? seconds : most, edges, faults }' "$log"
}
export -f fuzz

echo "| reader | executions | seconds | edges | faults |"
echo "|---|---|---|---|---|"
printf '%s\n' "${readers[@]}" | xargs -P "$(nproc)" -I{} bash -c 'fuzz {}' | tee build/asan/fuzz_rows.txt
awk -F'|' '{ executions += $3; seconds += $4; edges += $5; faults += $6 }
  END { printf "| all | %d | %d | %d | %d |\n", executions, seconds, edges, faults; exit faults > 0 }' build/asan/fuzz_rows.txt
