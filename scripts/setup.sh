#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs Debian 12 packages: scripts/setup.sh [program|tests|all]. What the program needs to be built and run; that and
# what its tests need; that and what the other scripts need, which is the default. Does nothing when all are there.
set -euo pipefail

packages=(
  build-essential g++ cmake ninja-build git ca-certificates
  libeigen3-dev libceres-dev libopencv-dev libopencv-contrib-dev
  libyaml-cpp-dev libcli11-dev nlohmann-json3-dev libfmt-dev libembree-dev libflann-dev liblz4-dev
  libpcl-dev
  node-d3 libjs-three gnuplot-nox
)
tests=(libgtest-dev chromium clang-format clang-14 libclang-rt-14-dev libomp-14-dev lld-14 lld gcovr llvm-14)
others=(clang-tidy)
case ${1:-all} in
  program) ;;
  tests) packages+=("${tests[@]}") ;;
  all) packages+=("${tests[@]}" "${others[@]}") ;;
  *)
    echo "setup: program, tests or all, not '$1'" >&2
    exit 2
    ;;
esac

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
  [[ $status == installed ]] || missing+=("$package")
done
if [[ ${#missing[@]} -eq 0 ]]; then
  echo "setup: all ${#packages[@]} packages are installed"
  exit 0
fi

as_root=()
if [[ $(id -u) -ne 0 ]]; then
  if ! command -v sudo >/dev/null; then
    echo "setup: these packages are missing and only root can install them: ${missing[*]}" >&2
    echo "setup: run as root: apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi

echo "setup: installing ${missing[*]}"
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"
