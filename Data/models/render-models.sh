#!/usr/bin/env bash
# Renders one scene by every reflection model, gradient estimator and optical model, and lays the
# pictures out on one sheet.
#
#   render-models.sh [OUTPUT]
#
# OUTPUT (build/models) gets models.png and the pictures it was made of. PENUMBRA_BIN names the
# folder of programs that are built already; without it they are built first.
set -euo pipefail

[[ $# -le 1 && "${1:-}" != -* ]] || { echo "usage: render-models.sh [OUTPUT]" >&2; exit 2; }
scenes="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
root="$(cd "$scenes/../.." && pwd)"
output="${1:-$root/build/models}"
mkdir -p "$output"
output="$(cd "$output" && pwd)"
if [[ -z "${PENUMBRA_BIN:-}" ]]; then
  "$root/Testing/build.sh" penumbra-render penumbra-contact-sheet
  PENUMBRA_BIN="$root/build/bin"
fi

cell() { # CAPTION NAME SETTING ...: renders it and prints its entry of the sheet
  local caption="$1" name="$2" settings=()
  shift 2
  for setting in "$@"; do
    settings+=(--set "$setting")
  done
  "$PENUMBRA_BIN/penumbra-render" "$scenes/head.json" "${settings[@]}" --output "$output/$name.png"
  echo "{\"picture\": \"$name.png\", \"caption\": \"$caption\"}"
}

model() { # CAPTION NAME SETTING ...: of the reflection model of that name
  cell "$1" "$2" "material.model=$2" "${@:3}"
}

material() { # CAPTION NAME: of the material of that name
  cell "$1\\n${2/-/ }" "$2" "material={\"preset\":\"$2\"}"
}

near() { # CAPTION NAME: the eye, with the gradient estimator of that name
  cell "$1" "gradient-$2" "gradient=$2" camera.viewAngle=8 "camera.focalPoint=[-88,-68,-55]"
}

optics() { # CAPTION NAME SETTING ...: the optical model of that name, thin enough to look through
  cell "$1" "$2" "opticalModel=$2" transferFunction.opacityUnitDistance=30 \
    "image.background=[0.75,0.75,0.72]" "${@:3}"
}

row() { # TITLE CELL CELL CELL CELL
  local title="$1"
  shift
  local IFS=,
  echo "{\"title\": \"$title\", \"cells\": [$*]}"
}

rows=(
  "$(row "Reflection" "$(model Phong phong)" "$(model Blinn-Phong blinn-phong)" \
    "$(model "Oren-Nayar, roughness .6" oren-nayar material.diffuse=0.9 material.roughness=0.6)" \
    "$(model "Ward, roughness .15" ward material.roughness=0.15 material.specular=0.2)")"
  "$(row "" "$(material "Ward anisotropic" brushed-metal)" \
    "$(material Cook-Torrance gold)" \
    "$(material Cook-Torrance porcelain)" \
    "$(model "Reflection map\\nsky.png" reflection-map material.environmentMap=sky.png \
      material.diffuse=0.5 material.specular=0.7 material.specularPower=60)")"
  "$(row "Gradient" "$(near "Central differences" central)" "$(near "Forward differences" forward)" \
    "$(near "Backward differences" backward)" "$(near Sobel sobel)")"
  "$(row "Optics" "$(optics Absorption absorption)" \
    "$(optics Emission emission "image.background=[0,0,0]" transferFunction.opacityUnitDistance=150)" \
    "$(optics "Absorption and emission" absorption-emission)" \
    "$(optics "Single scattering" single-scattering)")"
)
IFS=,
cat >"$output/models.json" <<SHEET
{"columns": ["", "", "", ""], "rows": [${rows[*]}], "cellSize": [256, 256]}
SHEET
"$PENUMBRA_BIN/penumbra-contact-sheet" "$output/models.json" --output "$output/models.png"
echo "The sheet is $output/models.png"
