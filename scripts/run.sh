#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Set-up, release build and the main job: the embedded data is made (once), category models are learnt from its CAD
# models, its three sequences are run, the objects found get their nearest CAD models, and all is compared with the truth.
set -euo pipefail
cd "$(dirname "$0")/.."

armature() { build/release/armature "$@"; }

data=datasets/generated
out=runs/generated

# How the edges lie in our CAD models: datasets/README.md, "Edges and what is seen of them".
learn() {
  local category=$1
  shift
  armature learn --spec "configs/categories/specs/$category.yaml" --annotations "$data/cad/${category}_edges.csv" \
    --format edges --metric "$@" --out "$out/categories/$category.yaml" >/dev/null
}

main_job() {
  armature generate --out "$data"
  learn chair --padding 0.012,0,0.01 --slab-drop 0.012
  learn table --padding 0.001,0,0.001 --slab-drop 0.02
  learn laptop --padding 0,0.009,0.003
  armature run "$data/seq1" "$data/seq2" "$data/seq3" --out "$out/run" --categories "$out/categories"
  echo
  armature retrieve --build --cad "$data/cad" --categories "$out/categories" --out "$out/instances.armlib" >/dev/null
  armature retrieve "$out/run" --library "$out/instances.armlib" --categories "$out/categories" --place
  echo
  armature eval "$out/run" --categories "$out/categories" --library "$out/instances.armlib" \
    --tables edges,trajectory,objects,paper,retrieval
  echo
  # The baselines that wait or really run take minutes: README, "Timing".
  armature bench "$data/seq1" --categories "$out/categories" --tables comparison \
    --engines lines,lines:fast,keypoints:published
  echo
  echo "Sequences: $data (contact_sheet.jpg shows some of their pictures); results, a folder a sequence: $out/run (map.png: the map with its CAD models)"
}

scripts/setup.sh
scripts/build.sh release
main_job
