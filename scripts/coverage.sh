#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# What the tests that ran in build/asan have not run: the share of covered lines of our sources, and the ten files of
# which the most lines are not covered.
set -euo pipefail
cd "$(dirname "$0")/.."

gcovr --root . --object-directory build/asan --gcov-executable 'llvm-cov-14 gcov' -j "$(nproc)" \
  --filter src/ --filter bench/ --filter eval/ --filter datasets/ --csv --output build/asan/coverage.csv build/asan
# Columns: filename,line_total,line_covered,... Headers are named by the links that restrict who may include them.
sed -Ei 's|^build/asan/floors/[^/]+/|src/|' build/asan/coverage.csv
tail -n +2 build/asan/coverage.csv | awk -F, '
  { total += $2; covered += $3 }
  END { printf "coverage: %.1f %% of %d lines\n", total ? 100 * covered / total : 0, total }'
echo "least covered (lines not run, of all):"
tail -n +2 build/asan/coverage.csv | awk -F, '{ printf "  %4d of %4d  %s\n", $2 - $3, $2, $1 }' | sort -rn | sed -n 1,10p
