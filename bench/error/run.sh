#!/usr/bin/env bash
# bench/error/run.sh COMMAND FOLDER [MODEL[@DEGREES] | SCENE.obj[.gz]]..
# Runs `sightline compare` (COMMAND: the built command) over models and scenes: its tables go to FOLDER/tables.txt, its
# pictures to FOLDER/NAME.svg and .png, everything view by view to FOLDER/NAME.csv. Without a list: five models, the
# same turned by 17 degrees, and the scenes of ../shared/scenes beside the checkout where they are. A scene file has its .cameras beside it.
# CAMERAS: so many of each file's cameras, evenly spread (default 6). METHODS: for all but turned models. MEMORY: the built
# bench_error, which adds what sampled methods hold in memory to the tables, and makes no pictures.
set -euo pipefail

[ $# -ge 2 ] || { sed -n '2,7s/^# //p' "$0" >&2; exit 2; }
command=$1 folder=$2
shift 2
cameras=${CAMERAS:-6}
exact=front-to-back,cells,double
sampled=ids:64,ids:256,ids:1024,ids:4096,rays:64,rays:256,rays:1024,rays:4096
methods=${METHODS:-$exact,$sampled}

if [ $# -eq 0 ]; then
  set -- maze city building tower random maze@17 city@17 building@17 tower@17 random@17
  scenes=$(cd "$(dirname "$0")/../../.." && pwd)/shared/scenes
  if [ -d "$scenes" ]; then
    set -- "$@" "$scenes"/*.obj*
  else
    echo "bench/error: no shared scenes beside the checkout; models only" >&2
  fi
fi

mkdir -p "$folder"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
: > "$folder/tables.txt"

# Every so-manieth camera of a file.
some() {
  grep -v '^[[:space:]]*\(#\|$\)' "$1" | awk -v n="$cameras" '
    { line[NR] = $0 }
    END { if (n > NR) n = NR; for (k = 0; k < n; ++k) print line[1 + int(k * NR / n)] }'
}

for subject in "$@"; do
  list=$methods
  case "$subject" in
    *.obj | *.obj.gz)
      name=$(basename "${subject%.gz}" .obj)
      if [ "${subject##*.}" = gz ]; then gzip -dc "$subject"; else cat "$subject"; fi > "$work/$name.obj"
      some "${subject%.obj*}.cameras" > "$work/some.cameras"
      ;;
    *)
      name=${subject/@/-}
      turned=()
      if [ "$subject" != "${subject%@*}" ]; then
        turned=(--rotate "${subject#*@}")
        list=$exact
      fi
      "$command" model "${subject%@*}" "${turned[@]}" -o "$work/$name.obj" -q
      some "$work/$name.cameras" > "$work/some.cameras"
      ;;
  esac
  echo "bench/error: $name" >&2
  {
    echo "$name"
    if [ -n "${MEMORY:-}" ]; then
      run=("$MEMORY")
      made=()
    else
      run=("$command" compare)
      made=(-o "$work/out")
    fi
    if ! "${run[@]}" "$work/$name.obj" --cameras "$work/some.cameras" --methods "$list" "${made[@]}" 2>&1; then
      echo "(failed)"
    fi
    echo
  } >> "$folder/tables.txt"
  for ending in csv json svg png; do
    if [ -e "$work/out/compare.$ending" ]; then mv "$work/out/compare.$ending" "$folder/$name.$ending"; fi
  done
  rm -rf "$work/out" "$work/$name.obj"
done
