#!/usr/bin/env bash
# Builds and runs every test, from nothing. Charts beyond the project's own are read from the folder that SEAHEX_TEST_DATA
# names, or from a folder `shared` beside the project; tests that need them skip where there is none.
#
#   tests/run.sh                        the whole suite
#   SEAHEX_PRESET=asan-ubsan tests/run.sh   the same under the sanitizers, in build-asan-ubsan
set -euo pipefail
cd "$(dirname "$0")/.."

. cmake/debian-packages.sh
install_packages $library_packages $demo_packages $test_packages

if [ -z "${SEAHEX_TEST_DATA:-}" ] && [ -d ../shared/charts ]; then
    SEAHEX_TEST_DATA=$(cd ../shared && pwd)
fi
export SEAHEX_TEST_DATA="${SEAHEX_TEST_DATA:-}"

# What fontconfig keeps until the end is no leak of ours.
export LSAN_OPTIONS="suppressions=$PWD/tests/support/leaks.supp:print_suppressions=0:${LSAN_OPTIONS:-}"

preset="${SEAHEX_PRESET:-release}"
jobs="${SEAHEX_JOBS:-$(nproc)}"
folder=build
[ "$preset" = release ] || folder="build-$preset"

cmake --preset "$preset" -DSEAHEX_BUILD_TESTS=ON -DSEAHEX_BUILD_BENCHMARKS=ON -DSEAHEX_DEVELOPER=ON
cmake --build "$folder" --parallel "$jobs"
ctest --test-dir "$folder" --output-on-failure --parallel "$jobs" "$@"
