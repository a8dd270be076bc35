#!/usr/bin/env bash
# Installs the C++ compiler for building and the system libraries for some tests. Running nearfar needs none of them.
#   g++                           meshoptimizer, one of the two simplifiers, is C++
#   libegl1, libgl1, libosmesa6   off-screen OpenGL for pyrender, an independent renderer for comparisons
#   libvulkan1, mesa-vulkan-drivers   software graphics adapters, which are tested like those of a graphics card
#   glslang-tools                 a compiler of GLSL and HLSL, for the snippets of docs/engines
#   assimp-utils, blender         exporters, whose files must look like those that they were made of; Debian's Blender
#   python3-numpy                 recommends NumPy only, but exports no glTF without it
#   npm, chromium                 other programs' readers of what nearfar writes, some of which need a browser; Ubuntu
#                                 has Chromium as a snap only: install that, or Chrome, first
# As root on Debian or Ubuntu it installs missing packages; elsewhere it prints the command and continues.
set -euo pipefail

packages=(assimp-utils blender g++ glslang-tools libegl1 libgl1 libosmesa6 libvulkan1 mesa-vulkan-drivers)
packages+=(python3-numpy)
command -v npm >/dev/null || packages+=(npm)
command -v google-chrome >/dev/null || command -v chromium-browser >/dev/null || packages+=(chromium)

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
