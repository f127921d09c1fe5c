#!/usr/bin/env bash
# Builds Penumbra and renders the example scene Data/stent.json to build/stent.png.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

Testing/build.sh penumbra-render
echo "Rendering Data/stent.json ..."
build/bin/penumbra-render Data/stent.json --output build/stent.png
echo "The picture is $PWD/build/stent.png"
