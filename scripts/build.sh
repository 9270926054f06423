#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Configures and builds: scripts/build.sh [release|asan [TARGET...]], all of it or the targets alone. The result is in
# build/<preset>.
set -euo pipefail
cd "$(dirname "$0")/.."

preset=${1:-release}
launcher=()
if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi

cmake --preset "$preset" --log-level=WARNING "${launcher[@]}"
targets=("${@:2}")
cmake --build --preset "$preset" --parallel "$(nproc)" ${targets:+--target "${targets[@]}"}
