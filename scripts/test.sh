#!/usr/bin/env bash
# Installs what is missing, builds everything with warnings as errors and runs all tests; then the same tests in a second
# build, under address and undefined-behaviour sanitizers. With one argument, `ci` or `asan`, only that build.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

bash scripts/setup.sh
jobs=$(bash scripts/jobs.sh)
for preset in ${1:-ci asan}; do
  start=$SECONDS
  cmake --preset "$preset"
  cmake --build --preset "$preset" -j "$jobs"
  built=$SECONDS
  echo "test: $preset built in $((built - start)) s"
  ctest --preset "$preset" -j "$jobs"
  echo "test: $preset tested in $((SECONDS - built)) s"
done
