#!/usr/bin/env bash
# Renders every preset on data of its kind, lays the pictures out on one sheet, and writes a table of
# how bright they are.
#
#   render-presets.sh [OUTPUT] [VOLUME ...]
#
# Needs what Data/fetch-data.sh brings. OUTPUT (build/presets) gets presets.png, presets.md, and the
# pictures they were made of. Each VOLUME adds lines to the table, one by the preset that is chosen
# for it and one each by surface and cloud. PENUMBRA_BIN names the folder of programs that are built
# already; without it they are built first.
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
volumes=("${@:2}")
mkdir -p "$output"
output="$(cd "$output" && pwd)"
if [[ -z "${PENUMBRA_BIN:-}" ]]; then
  "$root/Testing/build.sh" penumbra-render penumbra-contact-sheet
  PENUMBRA_BIN="$root/build/bin"
fi

told() { # KEY REPORT: a number of the picture's brightness
  sed -n '/"brightness"/,/}/p' "$2" | sed -En "s/.*\"$1\": ([-+.0-9e]+).*/\1/p"
}

render() { # PRESET|"" VOLUME NAME: renders it, and adds its line to the table
  local preset=() report="$output/$3.json" values=()
  [[ -z "$1" ]] || preset=(--preset "$1")
  "$PENUMBRA_BIN/penumbra-render" "$2" "${preset[@]}" --output "$output/$3.png" \
    --report "$report" 2>/dev/null
  for key in luminance burntOut black foreground; do
    values+=("$(told "$key" "$report")")
  done
  LC_ALL=C printf '| %s | %s | %.2f | %.3f | %.3f | %.2f |\n' "${1:-chosen}" \
    "$(basename "${2%.*}")" "${values[@]}" | tee -a "$output/presets.md" >&2
}

cell() { # PRESET VOLUME: renders it and prints its entry of the sheet
  render "$1" "$2" "$1"
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

cat >"$output/presets.md" <<HEAD
| preset | volume | mean luminance | burnt out | black | of the picture |
|---|---|---|---|---|---|
HEAD
rows=(
  "$(row ct-bone "$head" ct-skin "$head" ct-skin-bone "$chest" ct-lung "$chest")"
  "$(row ct-vessels "$chest" ct-abdomen "$chest" ct-muscle "$chest" mr-head "$root/Data/mr-brain")"
  "$(row mr-brain "$brain" mr-angiography "$stent" surface "$stent" cloud "$brain")"
)
IFS=,
cat >"$output/presets.json" <<SHEET
{"columns": ["", "", "", ""], "rows": [${rows[*]}], "cellSize": [256, 256]}
SHEET
"$PENUMBRA_BIN/penumbra-contact-sheet" "$output/presets.json" --output "$output/presets.png"
for preset in ct-bone ct-skin; do
  render "$preset" "$chest" "$preset-chest"
done
render ct-skin-bone "$head" ct-skin-bone-head
for preset in surface cloud; do
  render "$preset" "$root/Data/mr-brain" "$preset-mr-brain"
done
for volume in "${volumes[@]}"; do
  name="$(basename "${volume%.*}")"
  render "" "$volume" "$name"
  render surface "$volume" "$name-surface"
  render cloud "$volume" "$name-cloud"
done
echo "The sheet is $output/presets.png, the table $output/presets.md"
