#!/usr/bin/env bash
# Renders the thesis' test cases, each unlit, lit, and lit with soft and with hard shadows, and lays
# them out on one sheet with what a frame of each costs, as a multiple of the unlit one.
#
#   render-thesis-cases.sh [FOLDER] [OUTPUT]
#
# FOLDER has bonsai.mhd and engine.mhd (Data/fetched); Data/fetch-data.sh brings the CT and the
# skull. What is not there is left out. OUTPUT (build/thesis) gets thesis-cases.png, and the
# pictures and reports it was made of. PENUMBRA_BIN names the folder of programs that are built
# already; without it they are built first.
set -euo pipefail

fail() {
  echo "render-thesis-cases.sh: $*" >&2
  exit "${status:-1}"
}

[[ $# -le 2 && "${1:-}" != -* ]] || status=2 fail "usage: render-thesis-cases.sh [FOLDER] [OUTPUT]"
scenes="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
root="$(cd "$scenes/../.." && pwd)"
given="${1:-$root/Data/fetched}"
output="${2:-$root/build/thesis}"
[[ $# -eq 0 || -d "$given" ]] || status=2 fail "there is no folder $given"
mkdir -p "$output" || fail "the folder $output cannot be made"
given="$(cd "$given" 2>/dev/null && pwd || echo "$given")"
output="$(cd "$output" && pwd)"
if [[ -z "${PENUMBRA_BIN:-}" ]]; then
  "$root/Testing/build.sh" penumbra-render penumbra-contact-sheet
  PENUMBRA_BIN="$root/build/bin"
fi

readonly frames=3
readonly cases=(ct skull bonsai engine)
readonly states=(unlit lit soft hard)
declare -Ar titles=([ct]="CT" [skull]="Skull" [bonsai]="Bonsai" [engine]="Engine")
declare -Ar columns=([unlit]="Unlit" [lit]="Lit" [soft]="Soft shadow" [hard]="Hard shadow")
declare -Ar volumes=(
  [ct]="$root/Data/fetched/ct-chest"
  [skull]="$root/Data/fetched/ct-head/ct-head.mhd"
  [bonsai]="$given/bonsai.mhd"
  [engine]="$given/engine.mhd")
declare -Ar settings=(
  [unlit]="shade=false"
  [lit]="lights.0.shadow=none"
  [soft]="lights.0.shadow=soft"
  [hard]="lights.0.shadow=hard")
# The multiples that the thesis itself tells.
declare -Ar told=(
  [ct-unlit]="1" [ct-lit]="1.08" [ct-soft]="2.1"
  [skull-unlit]="1" [skull-lit]="1" [skull-soft]="2.6")

median_cpu_seconds() { # REPORT
  sed -n '/"frameCpuSeconds"/,/\]/p' "$1" | grep -Eo '[0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?' | sort -g |
    sed -n "$(((frames + 1) / 2))p"
}

list() { # prints its arguments with commas between them
  local IFS=,
  echo "$*"
}

rows=()
for case in "${cases[@]}"; do
  volume="${volumes[$case]}"
  if [[ ! -e "$volume" ]]; then
    hint="give the folder that has it"
    [[ "$volume" != "$root/Data/fetched/ct-"* ]] || hint="Data/fetch-data.sh brings it"
    echo "${titles[$case]} is left out: there is no $volume; $hint."
    continue
  fi
  cells=()
  for state in "${states[@]}"; do
    name="$case-$state"
    "$PENUMBRA_BIN/penumbra-render" "$scenes/$case.json" --set "volume.file=$volume" \
      --set "${settings[$state]}" --frames "$frames" \
      --output "$output/$name.png" --report "$output/$name.json"
    seconds="$(median_cpu_seconds "$output/$name.json")"
    [[ "$state" != unlit ]] || unlit="$seconds"
    multiple="$(LC_ALL=C awk "BEGIN { printf \"%.2f x\", $seconds / $unlit }")"
    detail="$(LC_ALL=C awk "BEGIN { printf \"%.2f s\", $seconds }")"
    [[ -z "${told[$name]:-}" ]] || detail+=", in the thesis ${told[$name]} x"
    cells+=("{\"picture\": \"$name.png\", \"caption\": \"$multiple\\n$detail\"}")
    printf '%-7s %-12s %s  (%s)\n' "${titles[$case]}" "${columns[$state]}" "$multiple" "$detail"
  done
  rows+=("{\"title\": \"${titles[$case]}\", \"cells\": [$(list "${cells[@]}")]}")
done
[[ ${#rows[@]} -gt 0 ]] || fail "there is nothing to render"

heads=()
for state in "${states[@]}"; do
  heads+=("\"${columns[$state]}\"")
done
cat >"$output/thesis-cases.json" <<SHEET
{"title": "The thesis' test cases",
 "note": "Below each picture: what a frame costs as a multiple of the unlit one, and its seconds of processor time (all cores, median of $frames).",
 "columns": [$(list "${heads[@]}")],
 "rows": [$(list "${rows[@]}")],
 "cellSize": [256, 256]}
SHEET
"$PENUMBRA_BIN/penumbra-contact-sheet" "$output/thesis-cases.json" --output "$output/thesis-cases.png"
echo "The sheet is $output/thesis-cases.png"
