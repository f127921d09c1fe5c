#!/usr/bin/env bash
# Builds Penumbra in build/: build.sh [TARGET]..., without targets everything. Needed packages are
# installed first.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

Testing/install-packages.sh
echo "Configuring in $PWD/build ..."
cmake --preset release -Wno-dev --log-level=WARNING
echo "Building ..."
cmake --build --preset release ${1:+--target "$@"}
