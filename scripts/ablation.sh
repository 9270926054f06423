#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# What if something is changed or left out: runs the presets paper and default and every file of configs/ablations on
# the sequences, then prints one table of all of them for each sequence.
#
#   scripts/ablation.sh SEQUENCE... --out DIR [--cad DIR] [--categories DIR] [--only NAME]... [--tables NAMES]
#
# --out   a folder a configuration, DIR/NAME; the tables: DIR/ablation.md, their rows: DIR/detections.csv
# --cad   annotated CAD models, to judge matches
# --categories  category models to use (default: configs/categories)
# --only  this configuration (paper, default or a file's name without .yaml); may be repeated
# --tables  of `armature eval`, joined by commas (default: observations,trajectory,objects,normal,paper)
set -euo pipefail

usage() {
  echo "ablation.sh: $1; usage: scripts/ablation.sh SEQUENCE... --out DIR [--cad DIR] [--categories DIR] [--only NAME]... [--tables NAMES]" >&2
  exit 2
}

root="$(cd "$(dirname "$0")/.." && pwd)"
program="${ARMATURE_PROGRAM:-$root/build/release/armature}"
sequences=()
only=()
out=""
cad=()
categories=()
tables=observations,trajectory,objects,normal,paper
while (($#)); do
  case "$1" in
    --out | --cad | --categories | --only | --tables)
      (($# > 1)) || usage "$1 needs a value"
      case "$1" in
        --out) out="$2" ;;
        --cad) cad=(--cad "$2") ;;
        --categories) categories=(--categories "$2") ;;
        --only) only+=("$2") ;;
        --tables) tables="$2" ;;
      esac
      shift 2
      ;;
    -*) usage "unknown option $1" ;;
    *)
      sequences+=("$1")
      shift
      ;;
  esac
done
((${#sequences[@]})) || usage "no sequence"
[[ -n "$out" ]] || usage "no --out"
[[ -x "$program" ]] || usage "$program is not there, run scripts/build.sh release first"

names=(paper default)
for file in "$root"/configs/ablations/*.yaml; do names+=("$(basename "$file" .yaml)"); done
if ((${#only[@]})); then
  for name in "${only[@]}"; do
    printf '%s\n' "${names[@]}" | grep -qxF -- "$name" || usage "no configuration '$name'"
  done
  names=("${only[@]}")
fi

mkdir -p "$out"
runs=()
for name in "${names[@]}"; do
  case "$name" in
    paper | default) arguments=(--preset "$name") ;;
    *) arguments=(--config "$root/configs/ablations/$name.yaml") ;;
  esac
  echo "ablation.sh: $name" >&2
  "$program" run "${sequences[@]}" --out "$out/$name" "${arguments[@]}" "${categories[@]}" >/dev/null
  runs+=("$out/$name")
done

"$program" eval "${runs[@]}" "${cad[@]}" "${categories[@]}" --tables "$tables" --raw "$out/detections.csv" --format markdown >"$out/ablation.md"
"$program" eval "${runs[@]}" "${cad[@]}" "${categories[@]}" --tables "$tables"
echo
echo "Runs: $out/NAME; tables: $out/ablation.md; a row a detection: $out/detections.csv"
