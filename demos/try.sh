#!/usr/bin/env bash
# The main job, from nothing: installs what is missing, builds, and plans the published scenario of [Cheng2020] on
# maps/shangchuan.000. Ends with the route's numbers, build/route.geojson and build/route.png.
set -euo pipefail
cd "$(dirname "$0")/.."

. cmake/debian-packages.sh
install_packages $library_packages $demo_packages

mkdir -p build
cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release -DSEAHEX_BUILD_TESTS=OFF >build/configure.log 2>&1 ||
    { cat build/configure.log; exit 1; }
cmake --build build --parallel "${SEAHEX_JOBS:-$(nproc)}"

build/demos/plan_route --scenario cheng2020 --out build/route.geojson --picture build/route.png
