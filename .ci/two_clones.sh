#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Whether a second clone, in another folder, finds in the compiler cache what a first clone has compiled.
# It compiles units of each floor and of the tests in both, with a cache of their own, and asks for 95 % of hits.
set -eu
cd -- "$(dirname -- "$0")/.."
least=95
trial=$PWD/build/two_clones
rm -rf "$trial"
mkdir -p "$trial"
export CCACHE_DIR="$trial/cache"
for clone in one another/one; do
  git clone -q . "$trial/$clone" 2>/dev/null
  git diff HEAD --binary | git -C "$trial/$clone" apply --allow-empty --whitespace=nowarn -
  ccache --zero-stats >/dev/null
  (cd "$trial/$clone" && CI=${CI:-} ./dev build ${1:-} >"$trial/log" 2>&1) || { tail -n 30 "$trial/log" >&2; exit 1; }
  ccache --print-stats >"$trial/stats"
done
awk -v least=$least '
  /^(direct|preprocessed)_cache_hit\t/ { hits += $2 }
  /^cache_miss\t/ { misses = $2 }
  END {
    if (hits + misses == 0) { print "nothing was compiled through ccache"; exit 1 }
    rate = 100 * hits / (hits + misses)
    printf "the second clone: %d hits, %d misses, %.1f %% hits\n", hits, misses, rate
    exit rate < least
  }' "$trial/stats"
rm -rf "$trial"
