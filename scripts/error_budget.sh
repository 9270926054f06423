#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# What the error over rooms is made of: scripts/error_budget.sh ROOMS OUT [options of `armature run`]. Each part of the
# input is replaced by the truth in turn, the rooms of the folder ROOMS are run anew, and the differences printed as
# one table, which is kept in OUT/evaluation. Rooms to begin with (the others have no lines that could be replaced):
#   build/release/armature generate --rooms configs/rooms/mixed.yaml --count 40 --lines-only --out runs/rooms
# TRUTHS="scale shapes" gives only these; JOBS=4 runs four rooms at once.
set -euo pipefail
if [[ $# -lt 2 ]]; then
  echo "usage: scripts/error_budget.sh ROOMS OUT [options of 'armature run']" >&2
  exit 2
fi
armature=${ARMATURE:-$(dirname "$0")/../build/release/armature}
rooms=$1 out=$2
shift 2
read -ra truths <<<"${TRUTHS:-scale cameras detections viewpoints lines identities shapes}"

"$armature" --quiet substitute "$rooms"/*/ --truth "$(IFS=,; echo "${truths[*]}")" --out "$out/input" >/dev/null

# run_room VARIANT ROOM OPTION...: rooms whose objects are categories of their own bring their models.
run_room() {
  local variant=$1 room=${2%/} name
  shift 2
  name=$(basename "$room")
  if [[ -d $room/categories ]]; then set -- "$@" --categories "$room/categories"; fi
  "$armature" --quiet run "$room" --out "$out/$variant/$name" "$@" >/dev/null
}
export -f run_room
export armature out

run_variant() {
  local variant=$1 folder=$2
  shift 2
  echo "$variant" >&2
  printf '%s\0' "$folder"/*/ | xargs -0 -P "${JOBS:-2}" -I{} bash -c 'run_room "$@"' run_room "$variant" {} "$@"
}
run_variant none "$rooms" "$@"
for truth in "${truths[@]}"; do run_variant "$truth" "$out/input/$truth" "$@"; done
"$armature" eval "$out/none" "${truths[@]/#/$out/}" --tables error_budget,rooms,room_differences --format markdown \
  --out "$out/evaluation" >/dev/null
"$armature" eval "$out/none" "${truths[@]/#/$out/}" --tables error_budget --format markdown
