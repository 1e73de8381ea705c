#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# usage: each_file.sh VERB [OPTION...] FILE...
# Calls `assay VERB FILE OPTION...` for one file after another: a verb takes one file, and pre-commit passes many.
# The files are the last arguments that are files with an ending of a model or a scene. Prints the output of the files
# that fail. Exit status: 0 if every call ended with 0, otherwise 1.
set -u

if [ $# -lt 1 ]; then
  echo "usage: each_file.sh VERB [OPTION...] FILE..." >&2
  exit 1
fi
verb=$1
shift
if ! command -v assay >/dev/null 2>&1; then
  echo "there is no assay in \$PATH: install its package first" >&2
  exit 1
fi

is_input() {
  [ -f "$1" ] || return 1
  case $1 in
    *.[fF] | *.[fF][oO][rR] | *.[fF][tT][nN] | *.[fF][pP][pP] | *.[fF]77 | *.[fF]9[05] | *.[fF]0[38] | *.[fF]1[58]) ;;
    *.[yY][aA][mM][lL] | *.[yY][mM][lL]) ;;
    *) return 1 ;;
  esac
}

count=$# options=0 at=0
for argument; do
  at=$((at + 1))
  is_input "$argument" || options=$at # what comes before the last argument that is no input is an option
done

folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
at=0
while [ "$at" -lt "$count" ]; do # the options go round to the end, where each call takes them
  at=$((at + 1))
  argument=$1
  shift
  if [ "$at" -le "$options" ]; then
    set -- "$@" "$argument"
  else
    printf '%s\n' "$argument" >>"$folder/inputs"
  fi
done
[ -f "$folder/inputs" ] || exit 0
failed=0
while IFS= read -r input; do
  assay "$verb" "$input" --quiet "$@" >"$folder/output" 2>&1 </dev/null && continue
  failed=1
  printf '%s: assay %s\n' "$input" "$verb"
  cat "$folder/output"
done <"$folder/inputs"
exit "$failed"
