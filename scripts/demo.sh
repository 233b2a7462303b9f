#!/usr/bin/env bash
# Installs what is missing, builds the command, and runs the main job on a built-in model: a city is made, cut into
# cells, seen from a few cameras, and the maps are proved right by the independent verifier.
#   scripts/demo.sh [MODEL] [CAMERAS]     default: city 4
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
model=${1:-city}
count=${2:-4}

bash scripts/setup.sh
cmake --preset release
cmake --build --preset release -j "$(bash scripts/jobs.sh)"

sightline=$PWD/build/release/bin/sightline
out=$PWD/build/demo
rm -rf "$out"
mkdir -p "$out"
run() {
  echo "\$ sightline $*"
  "$sightline" "$@"
}
run model "$model" -o "$out/$model.obj"
# A few cameras, evenly along the model's walk.
awk -v count="$count" '/^[^#]/ && NF { line[n++] = $0 }
                       END { if (count > n) count = n; for (i = 0; i < count; ++i) print line[int(i * n / count)] }' \
  "$out/$model.cameras" >"$out/few.cameras"
run build "$out/$model.obj" -o "$out/$model.wp" --report "$out/build.json"
run trace "$out/$model.wp" --cameras "$out/few.cameras" -o "$out/maps" --format map,svg,png,csv --report "$out/trace.json"
run verify "$out/$model.obj" "$out"/maps/*.map.json

echo
echo "Exact visibility maps of $model, verified. The picture of the first camera:"
echo "  $out/maps/0000.png"
echo "and beside it every map as JSON, SVG and PNG, and visibility.csv."
