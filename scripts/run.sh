#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Set-up, release build and the main job.
set -euo pipefail
cd "$(dirname "$0")/.."

armature() { build/release/armature "$@"; }

main_job() {
  armature run datasets/sample --out runs/sample
}

scripts/setup.sh
scripts/build.sh release
main_job
