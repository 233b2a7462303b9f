#!/usr/bin/env bash
# bench/error/cost.sh COMMAND SCENE.obj CAMERAS
# What exact stages cost where the engine on plain doubles does not survive to be compared with: instructions of the
# engine `front-to-back` under callgrind (Debian: valgrind), tracing alone, and those in its exact stages, the making of
# lines included. If these cost nothing, the engine would be so many times faster: a bound on what exactness costs.
set -euo pipefail
[ $# -eq 3 ] || { sed -n '2,6s/^# //p' "$0" >&2; exit 2; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# `compare` traces every view once for the reference.
valgrind --tool=callgrind --callgrind-out-file="$work/out" --toggle-collect='sightline::Tracer::trace(*' \
  "$1" compare "$2" --cameras "$3" --methods ids:1 -o "$work" -q 2> "$work/log"
callgrind_annotate --auto=no --inclusive=yes --threshold=100 --show-percs=no "$work/out" | tr -d , | awk -v scene="$(basename "$2")" '
  # The line with the whole of a function is the largest of those that name it.
  function take(name) { if ($1 > most[name]) most[name] = $1 }
  /sightline::Tracer::trace\(/ { if ($1 > all) all = $1 }
  /SightlineTable::exact_order\(/ { take("order") }
  /SightlineTable::exact_(eye_)?side\(/ { take($0 ~ /eye/ ? "eye" : "side") }
  /SightlineTable::make_of_points\(/ { take("points") }
  /SightlineTable::make_of_short_points\(/ { take("short points") }
  /SightlineTable::make_of_planes\(/ { take("planes") }
  /SightlineTable::corner\(/ { take("corner") }
  /Window::(st|forwardness)\(/ { take($0 ~ /::st\(/ ? "st" : "forwardness") }
  /stitching::compare_places\(/ { take("places") }
  END {
    if (all == 0) { print "cost: nothing was counted" > "/dev/stderr"; exit 1 }
    for (name in most) sum += most[name]
    printf "%s: %.1f million instructions, %.0f %% in exact stages (order %.0f %%, lines %.0f %%), bound %.2f\n", scene,
           all / 1e6, 100 * sum / all, 100 * most["order"] / all,
           100 * (most["points"] + most["short points"] + most["planes"]) / all, all / (all - sum)
  }'
