#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Everything that has to pass: set-up, format, release build and tests, the same with address and undefined-behaviour
# sanitizers. The last line is `N passed, N failed, N skipped`, the tests of both builds together; a step that fails
# before its tests (format, build) counts as one failure. Exit status 0 only when nothing failed.
set -uo pipefail
cd "$(dirname "$0")/.."

passed=0
failed=0
skipped=0

step() { printf '\n== %s\n' "$*"; }

finish() {
  printf '\n%d passed, %d failed, %d skipped\n' "$passed" "$failed" "$skipped"
  [[ $failed -eq 0 ]]
  exit
}

# Adds the results of a CTest JUnit file to the counts.
count() {
  local file=$1 status=$2 failures
  passed=$((passed + $(grep -c '<testcase .*status="run"' "$file")))
  skipped=$((skipped + $(grep -c '<skipped message="SKIP_' "$file")))
  failures=$(($(grep -c '<testcase ' "$file") - $(grep -c '<testcase .*status="run"' "$file") - \
    $(grep -c '<skipped message="SKIP_' "$file")))
  if [[ $failures -eq 0 && $status -ne 0 ]]; then failures=1; fi
  failed=$((failed + failures))
}

build_and_test() {
  local preset=$1 results=build/$1/tests.xml
  step "build ($preset)"
  if ! scripts/build.sh "$preset"; then
    failed=$((failed + 1))
    return
  fi
  step "tests ($preset)"
  rm -f "$results"
  ctest --preset "$preset" --parallel "$(nproc)" --output-junit tests.xml --no-tests=error
  local status=$?
  if [[ ! -f $results ]]; then
    failed=$((failed + 1))
    return
  fi
  count "$results" "$status"
}

step set-up
if ! scripts/setup.sh; then
  failed=$((failed + 1))
  finish
fi
step format
scripts/format.sh --check || failed=$((failed + 1))
build_and_test release
build_and_test asan
finish
