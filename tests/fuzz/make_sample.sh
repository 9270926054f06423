#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Makes tests/fuzz/sample, a small file of each kind that the program reads, with the program itself; what is long is
# cut. What the program only reads is in it by hand. Run again when a format has changed: tests/fuzz/make_sample.sh [PROGRAM]
set -euo pipefail
cd "$(dirname "$0")/../.."

armature=$(realpath "${1:-build/release/armature}")
configs=$PWD/configs
sample=$PWD/tests/fuzz/sample
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# A sequence of a few pictures, and CAD models: two of each category.
"$armature" generate --quiet --out data --only sample --frames 12
mkdir cad
{
  head -1 data/cad/instances.csv
  for category in chair table laptop; do grep -m 2 ",$category," data/cad/instances.csv; done
} >cad/instances.csv
ids=$(tail -n +2 cad/instances.csv | cut -d, -f1 | paste -sd'|')
for edges in data/cad/*edges*.csv; do grep -E "^(model|$ids)," "$edges" >"cad/$(basename "$edges")"; done
cut -d, -f2,1 cad/instances.csv | tail -n +2 | while IFS=, read -r id category; do
  mkdir -p "cad/$category"
  cp "data/cad/$category/$id.ply" "cad/$category/"
done

"$armature" run data/sample --out run --configs "$configs" --quiet
"$armature" retrieve --build --cad cad --out library.armlib --categories "$configs/categories" --save-index >tables.txt
"$armature" retrieve run --library library.armlib --categories "$configs/categories" --quiet >tables.txt
"$armature" eval run --out eval --groundtruth data/sample --quiet >tables.txt
"$armature" eval run --groundtruth data/sample --quiet --tables trajectory --json >tables.json

rm -rf "$sample"/{sequence,run,cad,eval}
mkdir -p "$sample"/{sequence/rgb,run,cad,eval}
for file in sequence.yaml rgb.txt detections.csv detections_gt.csv groundtruth.txt objects_gt.csv odometry.txt; do
  cp "data/sample/$file" "$sample/sequence"
done
"$armature" generate --quiet --out lines --only sample --frames 3 --lines-only --without-cad
awk -F, '/^#|^t/ || count[$1]++ < 5' lines/sample/segments.csv >"$sample/segments.csv"
head -12 data/sample/edges_gt.csv >"$sample/sequence/edges_gt.csv"
for image in data/sample/rgb/*; do : >"$sample/sequence/rgb/$(basename "$image")"; done
grep -v '^ *#' data/sample/scene.yaml >"$sample/scene.yaml"
grep -v '^ *#' "$configs/rooms/handheld.yaml" >"$sample/recipe.yaml"
cp run/*.{csv,yaml,json,txt} "$sample/run"
for table in associations observations timings; do head -20 "run/$table.csv" >"$sample/run/$table.csv"; done
cp cad/*.csv "$sample/cad"
cp cad/chair/*1.ply "$sample/mesh.ply"
cp library.armlib library.armlib*index* "$sample"
cp eval/records.json "$sample/eval"
sed -i "s#$work##g" "$sample"/{run,eval}/*.json
cp tables.json "$sample"
cp "$configs/categories/laptop.yaml" "$sample/category.yaml"
cp "$configs/presets/paper.yaml" "$sample/options.yaml"
cp "$configs/categories/specs/laptop.yaml" "$sample/specification.yaml"
grep -v '^ *#' "$configs/reproduce.yaml" >"$sample/matrix.yaml"
