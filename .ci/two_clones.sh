#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Whether another clone, in another folder, finds in the compiler cache what this one has compiled: 95 % of it at least.
set -eu
cd -- "$(dirname -- "$0")/.."
least=95
trial=$PWD/build/two_clones
rm -rf "$trial"
mkdir -p "$trial/elsewhere"
./dev build >"$trial/log" 2>&1 || { tail -n 30 "$trial/log" >&2; exit 1; }
clone=$trial/elsewhere/clone
git clone -q . "$clone" 2>/dev/null
git diff HEAD --binary | git -C "$clone" apply --allow-empty --whitespace=nowarn -
export CCACHE_STATSLOG="$trial/statistics" # a line for each compilation and for what became of it
(cd "$clone" && ./dev build >"$trial/log" 2>&1) || { tail -n 30 "$trial/log" >&2; exit 1; }
touch "$CCACHE_STATSLOG"
awk -v least=$least '
  /^(direct|preprocessed)_cache_hit$/ { ++hits }
  /^cache_miss$/ { ++misses }
  END {
    if (hits + misses == 0) { print "nothing was compiled through ccache: is it installed, and its folder writable?"; exit 1 }
    rate = 100 * hits / (hits + misses)
    printf "the other clone: %d hits, %d misses, %.1f %% hits\n", hits, misses, rate
    exit rate < least
  }' "$CCACHE_STATSLOG"
rm -rf "$trial"
