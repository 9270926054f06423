#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Set-up and release build of the program alone, then the main job: everything that `armature reproduce` does, from
# rendering the embedded data to the report. Arguments are its own: scripts/run.sh --fast, scripts/run.sh --seeds 3.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh program
scripts/build.sh release armature_program
# A first report within minutes: few frames of each sequence.
if [[ $# -eq 0 ]]; then build/release/armature reproduce --fast; fi
build/release/armature reproduce "$@"
