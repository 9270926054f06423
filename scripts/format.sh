#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Formats all our sources; with --check changes nothing, lists the files that are not formatted and fails if there are any.
set -euo pipefail
cd "$(dirname "$0")/.."

mapfile -t files < <(find src bench eval datasets tests \( -name '*.h' -o -name '*.cc' -o -name '*.js' \) 2>/dev/null | sort)

if [[ ${1:-} != --check ]]; then
  clang-format -i "${files[@]}"
  exit 0
fi

unformatted=()
for file in "${files[@]}"; do
  clang-format --dry-run --Werror "$file" >/dev/null 2>&1 || unformatted+=("$file")
done
if [[ ${#unformatted[@]} -gt 0 ]]; then
  echo "format: not formatted, run scripts/format.sh:" >&2
  printf '  %s\n' "${unformatted[@]}" >&2
  exit 1
fi
echo "format: ${#files[@]} files are formatted"
