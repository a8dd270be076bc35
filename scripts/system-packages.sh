#!/usr/bin/env bash
# A C++ compiler, which building needs, and system libraries that some tests use. Running nearfar needs none of them.
#   g++                           meshoptimizer, one of the two simplifiers, is C++
#   libegl1, libgl1, libosmesa6   off-screen OpenGL for pyrender, an independent renderer that pictures are compared with
#   libvulkan1, mesa-vulkan-drivers   graphics adapters in software, which are tested like those of a graphics card
# As root on Debian or Ubuntu it installs what is missing; elsewhere it prints the line and goes on.
set -euo pipefail

packages=(g++ libegl1 libgl1 libosmesa6 libvulkan1 mesa-vulkan-drivers)

missing=()
for package in "${packages[@]}"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
    exit 0
fi
if [ "$(id -u)" -ne 0 ] || ! command -v apt-get >/dev/null; then
    echo "To build and run every test, install: sudo apt-get install ${missing[*]}"
    exit 0
fi
export DEBIAN_FRONTEND=noninteractive
apt-get update -q </dev/null
apt-get install -q -y --no-install-recommends "${missing[@]}" </dev/null
