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

# Many files a call, a call a processor; each complaint starts with the file's name.
complaints=$(printf '%s\0' "${files[@]}" |
  xargs -0 -P "$(nproc)" -n 64 clang-format --dry-run --Werror 2>&1) && status=0 || status=$?
mapfile -t unformatted < <(grep -oP '^[^:]+(?=:\d+:\d+: error:)' <<<"$complaints" | sort -u)
if [[ ${#unformatted[@]} -gt 0 ]]; then
  echo "format: not formatted, run scripts/format.sh:" >&2
  printf '  %s\n' "${unformatted[@]}" >&2
  exit 1
fi
if [[ $status -ne 0 ]]; then
  echo "format: clang-format failed: $complaints" >&2
  exit 1
fi
echo "format: ${#files[@]} files are formatted"
