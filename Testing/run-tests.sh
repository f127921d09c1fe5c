#!/usr/bin/env bash
# Builds Penumbra and runs all its tests; further arguments go to ctest (run-tests.sh -R Support).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

Testing/install-packages.sh --tests
Testing/build.sh
echo "Testing ..."
ctest --preset release --no-tests=error --parallel "$(nproc)" "$@"
