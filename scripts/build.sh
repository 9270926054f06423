#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Configures and builds: scripts/build.sh [release|asan [-DNAME=VALUE...] [TARGET...]], all of it or the targets alone. The
# result is in build/<preset>, which remembers the settings.
set -euo pipefail
cd "$(dirname "$0")/.."

preset=${1:-release}
launcher=()
if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi

settings=() targets=()
for argument in "${@:2}"; do
  if [[ $argument == -D* ]]; then settings+=("$argument"); else targets+=("$argument"); fi
done
cmake --preset "$preset" --log-level=WARNING "${launcher[@]}" "${settings[@]}"
cmake --build --preset "$preset" --parallel "$(nproc)" ${targets:+--target "${targets[@]}"}
