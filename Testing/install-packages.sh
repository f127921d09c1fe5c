#!/usr/bin/env bash
# Installs the Debian packages that Penumbra needs to be built, and with --tests those whose files
# the tests read. This is the one list of them. Where all are there already, apt is not called.
set -euo pipefail

packages=(
  cmake
  g++
  ninja-build
  libvtk9-dev
  libosmesa6-dev
  nlohmann-json3-dev
  libcli11-dev
  libgdcm-dev
  catch2
  libvtk9-qt-dev
  qtbase5-dev
)
if [[ "${1:-}" == --tests ]]; then
  packages+=(python3-pydicom xvfb)
fi

is_installed() {
  [[ "$(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null)" == installed ]]
}

as_root() {
  if [[ "$(id -u)" -eq 0 ]]; then
    env DEBIAN_FRONTEND=noninteractive "$@"
  elif command -v sudo >/dev/null; then
    sudo env DEBIAN_FRONTEND=noninteractive "$@"
  else
    echo "Not root, and there is no sudo. As root: apt-get install ${missing[*]}" >&2
    exit 1
  fi
}

if ! command -v apt-get >/dev/null; then
  echo "This system has no apt-get. Install what is like Debian's: ${packages[*]}" >&2
  exit 1
fi

missing=()
for package in "${packages[@]}"; do
  is_installed "$package" || missing+=("$package")
done
if [[ ${#missing[@]} -eq 0 ]]; then
  echo "All needed packages are installed."
  exit 0
fi

echo "Installing ${missing[*]} and what they depend on ..."
as_root apt-get -o DPkg::Lock::Timeout=300 --quiet update
as_root apt-get -o DPkg::Lock::Timeout=300 --quiet --yes --no-install-recommends \
  install "${missing[@]}"
