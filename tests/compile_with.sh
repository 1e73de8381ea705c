#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# usage: compile_with.sh COMPILER [LAUNCHER] OTHER_COMPILER ARGUMENT...: what CMake has another compiler do, this one does.
set -eu
compiler=$1
shift
launcher=
case ${1##*/} in ccache) launcher=$1; shift ;; esac
shift
exec $launcher "$compiler" "$@"
