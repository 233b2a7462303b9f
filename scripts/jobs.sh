#!/usr/bin/env bash
# Prints how many compilers to run at once: one a processor, but no more than the memory holds (2 GB each).
processors=$(nproc)
memory=$(awk '/^MemAvailable:/ {print int($2 / 2000000)}' /proc/meminfo 2>/dev/null || true)
memory=${memory:-$processors}
[ "$memory" -ge 1 ] || memory=1
echo $((memory < processors ? memory : processors))
