#!/usr/bin/env bash
# fuzz.sh [SECONDS] [HARNESS..]: builds the harnesses of tests/fuzz for libFuzzer and runs each of them, or those named,
# for so many seconds (default 60), one after the other. What they find is in build/fuzz/findings: after mending, the
# input goes to tests/corpus/fuzz/HARNESS under a name that says what it is. Inputs that reach new code are kept in
# build/fuzz/corpus and used again.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

seconds=${1:-60}
shift || true
case "$seconds" in
  ""|*[!0-9]*) echo "usage: $0 [SECONDS] [HARNESS..]" >&2; exit 2 ;;
esac
harnesses=("$@")
if [ ${#harnesses[@]} -eq 0 ]; then
  for folder in tests/corpus/fuzz/*/; do harnesses+=("$(basename "$folder")"); done
fi

bash scripts/setup.sh
cmake --preset fuzz
cmake --build --preset fuzz -j "$(bash scripts/jobs.sh)"

found=0
mkdir -p build/fuzz/findings
for name in "${harnesses[@]}"; do
  mkdir -p "build/fuzz/corpus/$name"
  log=build/fuzz/$name.log
  if ! "build/fuzz/tests/fuzz/fuzz_$name" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=3000 -max_len=4096 \
      -print_final_stats=1 -artifact_prefix="build/fuzz/findings/$name-" \
      "build/fuzz/corpus/$name" "tests/corpus/fuzz/$name" >"$log" 2>&1; then
    found=1
    grep -E '^fault:|runtime error|SUMMARY' "$log" || tail -n 20 "$log"
  fi
  runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
  cover=$(grep -Eo 'cov: [0-9]+' "$log" | tail -n 1)
  echo "fuzz: $name: ${runs:-0} inputs, ${cover:-cov: 0}"
done
exit $found
