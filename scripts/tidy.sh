#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs clang-tidy (.clang-tidy, warnings are errors) over our sources, or over those given: scripts/tidy.sh [FILE.cc...].
# Needs clang-tidy's own compile_commands.json, of files that are compiled each alone: it is made here.
set -euo pipefail
cd "$(dirname "$0")/.."

cmake --preset tidy --log-level=WARNING >/dev/null
cmake --build build/tidy --target armature_git_state >/dev/null
database=build/tidy/compile_commands.json

files=("$@")
if [[ ${#files[@]} -eq 0 ]]; then
  mapfile -t files < <(grep -oP '"file": "\K[^"]+\.cc' "$database" | sort -u)
fi

failed=0
# shellcheck disable=SC2016
printf '%s\n' "${files[@]}" | xargs -P "$(nproc)" -n 1 bash -c '
  output=$(clang-tidy -p build/tidy --quiet "$0" 2>/dev/null) || { printf "%s\n" "$output"; exit 1; }' || failed=1
if [[ $failed -ne 0 ]]; then
  echo "tidy: correct what is listed above" >&2
  exit 1
fi
echo "tidy: ${#files[@]} files are clean"
