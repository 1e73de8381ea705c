#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Called by conda-build in a copy of the sources; $PREFIX, $CMAKE_ARGS and $CPU_COUNT are its own.
set -eu
# shellcheck disable=SC2086
cmake -S . -B build/conda -G Ninja ${CMAKE_ARGS:-} -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$PREFIX" \
  -DASSAY_BUILD_TESTS=OFF
cmake --build build/conda --target assay material_plugins --parallel "${CPU_COUNT:-1}"
cmake --install build/conda
