#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# How often each floor includes each other one, from the ground up, a row a floor that includes. What runs up would stand
# right of the diagonal; scripts/cmake/floors.cmake sees to it that nothing does.
set -euo pipefail
cd "$(dirname "$0")/.."

floors="base geometry category lines odometry association resection tracking mapping retrieval pipeline io drawing cli truth
  app datasets bench eval"
grep -ro --include='*.h' --include='*.cc' -E '^#include "[a-z_]+/' src bench eval datasets |
  grep -vE '^src/app/(commands|program|main)\.' |
  sed -E 's/^(src\/)?([a-z_]+)\/.*"([a-z_]+)\/$/\2 \3/' |
  awk -v names="$floors" '
    $1 != $2 { count[$1, $2]++ }
    END {
      n = split(names, floor)
      printf "%-12s", "includes of"
      for (j = 1; j <= n; j++) printf " %5.5s", floor[j]
      print ""
      for (i = 1; i <= n; i++) {
        printf "%-12s", floor[i]
        for (j = 1; j <= n; j++) {
          c = count[floor[i], floor[j]]
          printf " %5s", c ? c : (i == j ? "\\" : ".")
          if (j > i) up += c
        }
        print ""
      }
      printf "upward: %d\n", up
    }'
