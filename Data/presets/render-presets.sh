#!/usr/bin/env bash
# Renders every preset on data of its kind and lays the pictures out on one sheet.
#
#   render-presets.sh [OUTPUT]
#
# Needs what Data/fetch-data.sh brings. OUTPUT (build/presets) gets presets.png and the pictures it
# was made of. PENUMBRA_BIN names the folder of programs that are built already; without it they are
# built first.
set -euo pipefail

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
chest="$root/Data/fetched/ct-chest"
head="$root/Data/fetched/ct-head/ct-head.mhd"
brain="$root/Data/brainsmall.mhd"
stent="$root/Data/stent.mhd"
for volume in "$chest" "$head"; do
  if [[ ! -e "$volume" ]]; then
    echo "render-presets.sh: there is no $volume; Data/fetch-data.sh brings it" >&2
    exit 1
  fi
done
output="${1:-$root/build/presets}"
mkdir -p "$output"
output="$(cd "$output" && pwd)"
if [[ -z "${PENUMBRA_BIN:-}" ]]; then
  "$root/Testing/build.sh" penumbra-render penumbra-contact-sheet
  PENUMBRA_BIN="$root/build/bin"
fi

cell() { # PRESET VOLUME: renders it and prints its entry of the sheet
  "$PENUMBRA_BIN/penumbra-render" "$2" --preset "$1" --output "$output/$1.png" 2>/dev/null
  echo "{\"picture\": \"$1.png\", \"caption\": \"$1\"}"
}

row() { # PRESET VOLUME ...: four of them
  local cells=()
  while [[ $# -gt 0 ]]; do
    cells+=("$(cell "$1" "$2")")
    shift 2
  done
  local IFS=,
  echo "{\"title\": \"\", \"cells\": [${cells[*]}]}"
}

rows=(
  "$(row ct-bone "$head" ct-skin "$head" ct-skin-bone "$chest" ct-lung "$chest")"
  "$(row ct-vessels "$chest" ct-abdomen "$chest" ct-muscle "$chest" mr-head "$root/Data/mr-brain")"
  "$(row mr-brain "$brain" mr-angiography "$stent" surface "$stent" cloud "$brain")"
)
IFS=,
cat >"$output/presets.json" <<SHEET
{"columns": ["", "", "", ""], "rows": [${rows[*]}], "cellSize": [512, 512]}
SHEET
"$PENUMBRA_BIN/penumbra-contact-sheet" "$output/presets.json" --output "$output/presets.png"
echo "The sheet is $output/presets.png"
