#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Set-up, release build and the main job: the built-in sample is drawn, run and compared with its truth.
set -euo pipefail
cd "$(dirname "$0")/.."

armature() { build/release/armature "$@"; }

main_job() {
  rm -rf runs/sample/sequence
  armature generate --sample --out runs/sample/sequence
  armature run runs/sample/sequence --out runs/sample/run --overlays
  echo
  armature eval runs/sample/run
  echo
  echo "The sample's sequence is in runs/sample/sequence, its results in runs/sample/run (pictures: overlays)."
}

scripts/setup.sh
scripts/build.sh release
main_job
