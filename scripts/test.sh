#!/usr/bin/env bash
# Installs what is missing, builds everything with warnings as errors, runs all tests.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

bash scripts/setup.sh
jobs=$(bash scripts/jobs.sh)
start=$SECONDS
cmake --preset ci
cmake --build --preset ci -j "$jobs"
echo "test: built in $((SECONDS - start)) s"
ctest --preset ci -j "$jobs"
