#!/usr/bin/env bash
# Installs from Debian's packages what building and testing sightline needs and this machine lacks. Asks nothing;
# does nothing when nothing is missing. With --peers also what bench/compare sets beside it.
set -euo pipefail

packages=(
  g++ cmake ninja-build ccache pkg-config
  libglm-dev libgmp-dev libcairo2-dev libpng-dev  # the library: vectors, integers, pictures
  libtbb-dev libembree-dev libroaring-dev  # threads, rays, bitmaps
  libcli11-dev                          # the command: options
  nlohmann-json3-dev libeigen3-dev
  libcgal-dev                           # the slow, independent way to the same answers: tests and sightline-verify
  libgtest-dev librapidcheck-dev libbenchmark-dev
  valgrind                              # counts instructions: tests/instructions
  clang libclang-rt-dev llvm            # the builds under sanitizers, fuzzing; names in their traces
)
peers=(
  libgl2ps-dev
  libocct-modeling-algorithms-dev libocct-visualization-dev
  zlib1g-dev gnuplot-nox                # zipped scenes, pictures
)

case "${1:-}" in
  "") ;;
  --peers) packages+=("${peers[@]}") ;;
  *) echo "usage: $0 [--peers]" >&2; exit 2 ;;
esac

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  echo "setup: this is no Debian system; please install the equivalents of: ${packages[*]}" >&2
  exit 1
fi

missing=()
installed=$(dpkg-query -W -f='${db:Status-Abbrev} ${Package}\n' 2>/dev/null | sed -n 's/^ii *//p')
for package in "${packages[@]}"; do
  grep -qxF "$package" <<<"$installed" || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
  echo "setup: everything needed is installed"
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "setup: run this as root, or install sudo; missing: ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
echo "setup: installing from Debian's packages: ${missing[*]}"
"${as_root[@]}" apt-get update -q
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -q -y --no-install-recommends -o Dpkg::Use-Pty=0 "${missing[@]}" </dev/null
echo "setup: done"
