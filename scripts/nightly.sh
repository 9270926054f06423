#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# What is too long for scripts/test.sh: an hour of fuzzing (or scripts/nightly.sh SECONDS a reader) and 30 kills of each
# command at moments of their own. Exit status 0 only when nothing was found.
set -uo pipefail
cd "$(dirname "$0")/.."

failed=0
scripts/setup.sh tests || exit 1
scripts/fuzz.sh all "${1:-150}" || failed=1
scripts/build.sh release faults_program_tests || exit 1
ARMATURE_KILLS=30 ARMATURE_KILL_SEED=$(date +%Y%m%d) \
  build/release/tests/faults_program_tests --gtest_filter='Faults.*' || failed=1
exit "$failed"
