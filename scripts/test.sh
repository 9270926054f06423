#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Everything that has to pass: set-up, format, the release build of the program by GCC, with a look for one name with two
# definitions, and the tests that go through it; then these, all other tests and a little fuzzing, built by Clang with
# address and undefined-behaviour sanitizers, and what of the code they have run. The last line is `N passed, N failed, N
# skipped`, the test cases of both builds together; a step that fails before its tests (format, build) counts as one
# failure. Exit status 0 only when nothing failed.
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

# The sum of an attribute over GoogleTest's results, files that start with the totals of their program.
total() {
  grep -h '<testsuites ' "${@:2}" | grep -oP " $1=\"\K\d+" | awk '{sum += $1} END {print sum + 0}'
}

# Adds the cases of a build: those in the results of its test programs, and one for each test of CTest that leaves none.
# A program that fails without a failed case (a leak, a crash) is one failure.
count() {
  local tests=$1 results=$2 name result cases failures unrun
  while read -r name result; do
    if [[ ! -f $results/$name.xml ]]; then
      if [[ $result == run ]]; then passed=$((passed + 1)); else failed=$((failed + 1)); fi
      continue
    fi
    cases=$(total tests "$results/$name.xml")
    failures=$(total failures "$results/$name.xml")
    unrun=$(grep -cE 'result="(skipped|suppressed)"' "$results/$name.xml")
    passed=$((passed + cases - failures - unrun))
    skipped=$((skipped + unrun))
    if [[ $failures -eq 0 && $result != run ]]; then failures=1; fi
    failed=$((failed + failures))
  done < <(sed -nE 's/.*<testcase name="([^"]*)".* status="([^"]*)".*/\1 \2/p' "$tests")
}

# Builds the targets (all, if none is named), and runs the tests that have the label (all: ".").
build_and_test() {
  local preset=$1 label=$2 targets=("${@:3}") tests=build/$1/tests.xml results=build/$1/tests/results
  step "build ($preset)"
  if ! scripts/build.sh "$preset" "${targets[@]}"; then
    failed=$((failed + 1))
    return
  fi
  step "tests ($preset)"
  rm -rf "$tests" "$results"
  local labels=()
  [[ $label == . ]] || labels=(--label-regex "$label")
  ctest --preset "$preset" "${labels[@]}" --parallel "$(nproc)" --output-junit tests.xml --no-tests=error
  if [[ -f $tests ]]; then
    count "$tests" "$results"
  else
    failed=$((failed + 1))
  fi
}

step set-up
if ! scripts/setup.sh tests; then
  failed=$((failed + 1))
  finish
fi
step format
scripts/format.sh --check || failed=$((failed + 1))
build_and_test release release -DARMATURE_ODR=ON armature_program armature_odr release_tests
find build/asan -name "*.gcda" -delete 2>/dev/null  # of earlier runs
build_and_test asan . -DARMATURE_COVERAGE=ON
step coverage
scripts/coverage.sh || failed=$((failed + 1))
finish
