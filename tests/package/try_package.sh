#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# try_package.sh PACKAGE.deb [CACHE]: installs the package in a bare system, uses it, removes it.
# The bare system is this machine's Debian, made by debootstrap from this machine's own sources of packages. CACHE, or
# $ASSAY_CLEAN_ROOT, is a folder that keeps it and what apt fetched for the next time. Without one nothing is kept.
# Exit: 0 all is well; 1 something fails; 2 usage; 77 no bare system can be had here, and the one line says why.
set -eu
unset CDPATH
here=$(cd -- "$(dirname -- "$0")" && pwd -P)
checkout=$(cd -- "$here/../.." && pwd -P)

say() { printf 'try_package: %s\n' "$*"; }
fail() { say "FAILED: $*"; exit 1; }
not_tried() { say "not tried: $*"; exit 77; }

# ---- outside: a name space of mounts, which takes them along when it ends -------------------------------------------

if [ "${1:-}" != --inside ]; then
  if [ $# -lt 1 ] || [ $# -gt 2 ]; then
    sed -n '3,6p' "$0" | cut -c3- >&2
    exit 2
  fi
  [ -f "$1" ] || { say "no such file: $1" >&2; exit 2; }
  [ "$(id -u)" = 0 ] || not_tried "only root can make a bare system"
  command -v debootstrap >/dev/null 2>&1 || not_tried "debootstrap is not installed"
  unshare --mount true 2>/dev/null || not_tried "mounts are not allowed here"
  work=$(mktemp -d "${TMPDIR:-/var/tmp}/assay-package.XXXXXX")
  trap 'rm -rf --one-file-system "$work"' EXIT
  trap 'exit 130' INT TERM
  cache=${2:-${ASSAY_CLEAN_ROOT:-$work/cache}}
  mkdir -p "$cache"
  chmod 700 "$cache" # what apt needs to reach its sources may not be for everybody's eyes
  cp -- "$1" "$work/"
  code=0
  unshare --mount sh "$here/try_package.sh" --inside "$work" "$(cd -- "$cache" && pwd -P)" </dev/null || code=$?
  exit $code
fi

work=$2 cache=$3
package=$(find "$work" -maxdepth 1 -name '*.deb')
name=$(basename "$package")
base=$cache/base root=$work/root log=$work/log

# ---- the bare system ------------------------------------------------------------------------------------------------

# The sources of packages, their keys and how they are reached are those of this machine, whatever they are.
copy_sources() {
  rm -rf "$1/etc/apt/sources.list" "$1/etc/apt/sources.list.d" "$1/etc/apt/apt.conf.d"
  for file in sources.list sources.list.d apt.conf.d auth.conf auth.conf.d trusted.gpg.d keyrings; do
    [ ! -e "/etc/apt/$file" ] || cp -a "/etc/apt/$file" "$1/etc/apt/"
  done
  cp -r /usr/share/keyrings/. "$1/usr/share/keyrings/"
  cp /etc/resolv.conf /etc/hosts "$1/etc/"
  if [ -d /usr/local/share/ca-certificates ]; then
    cp -r /usr/local/share/ca-certificates "$1/usr/local/share/"
    chroot "$1" update-ca-certificates >/dev/null 2>&1 || :
  fi
  for helper in /usr/lib/apt/methods/*; do
    [ -e "$1$helper" ] || cp "$helper" "$1$helper"
  done
  # Containers throw away what apt has fetched; here it is kept in the cache.
  printf '#clear DPkg::Post-Invoke;\n#clear APT::Update::Post-Invoke;\n' >"$1/etc/apt/apt.conf.d/zz-keep"
  printf 'Binary::apt-get::APT::Keep-Downloaded-Packages "true";\n' >>"$1/etc/apt/apt.conf.d/zz-keep"
}

make_base() {
  # shellcheck disable=SC1091
  suite=$(. /etc/os-release && echo "${VERSION_CODENAME:-}")
  address=$(sed -n 's/^URIs: *//p' /etc/apt/sources.list.d/debian.sources /etc/apt/sources.list.d/ubuntu.sources \
    2>/dev/null | head -n 1)
  [ -n "$address" ] || address=$(awk '/^deb /{for (i = 2; i <= NF; i++) if ($i ~ /^[a-z+]+:/) {print $i; exit}}' \
    /etc/apt/sources.list 2>/dev/null || :)
  if [ -z "$suite" ] || [ -z "$address" ]; then not_tried "this system names no source of packages"; fi
  rm -rf --one-file-system "$base"
  debootstrap --variant=minbase --include=ca-certificates "$suite" "$base" "$address" >"$log" 2>&1 ||
    not_tried "debootstrap: $(tail -n 1 "$log")"
  copy_sources "$base"
  mkdir -p "$cache/archives"
  : >"$cache/made"
}

# Proxies are this machine's; nothing else of its environment is passed on.
in_root() {
  folder=$1
  shift
  env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 HOME=/root \
    DEBIAN_FRONTEND=noninteractive ${http_proxy:+http_proxy="$http_proxy"} ${https_proxy:+https_proxy="$https_proxy"} \
    chroot "$folder" "$@" </dev/null
}

start() { # a fresh copy of the bare system, with the package in its root folder
  for folder in var/cache/apt/archives dev proc; do
    mountpoint -q "$root/$folder" && umount -l "$root/$folder"
  done
  rm -rf --one-file-system "$root"
  cp -a --reflink=auto "$base" "$root"
  cp "$package" "$root/"
  mount -t proc proc "$root/proc" 2>/dev/null || not_tried "/proc cannot be mounted here"
  mount --rbind /dev "$root/dev"
  mount --bind "$cache/archives" "$root/var/cache/apt/archives"
  mkdir -m 777 "$root/trial"
}

as_root() { in_root "$root" "$@" >"$log" 2>&1 || { cat "$log"; fail "$*"; }; }

# What the tries need is fetched before: a failure of the network is none of the package.
tools='cmake g++ gfortran ninja-build pkg-config'
fetch_tools() {
  in_root "$root" apt-get update -qq >"$log" 2>&1 || not_tried "apt-get update: $(tail -n 1 "$log")"
  # shellcheck disable=SC2086
  in_root "$root" apt-get install -y --no-install-recommends --download-only "/$name" $tools >"$log" 2>&1 ||
    not_tried "apt-get cannot fetch packages: $(tail -n 1 "$log")"
}

# As somebody who may write into one folder only.
as_user() {
  in_root "$root" setpriv --reuid=1000 --regid=1000 --clear-groups env HOME=/trial/home sh -ec 'cd /trial && exec "$@"' \
    sh "$@"
}

expect() { # WORDS COMMAND...
  words=$1
  shift
  as_user "$@" >"$log" 2>&1 || { cat "$log"; fail "$*"; }
  grep -q -- "$words" "$log" || { cat "$log"; fail "$*: '$words' is not in what it says"; }
}

# What apt and dpkg keep for themselves is no file of the package.
files() {
  (cd "$root" && find . -xdev \( -path ./proc -o -path ./dev -o -path ./trial -o -path ./var/cache -o -path ./var/log \
    -o -path ./var/lib/apt -o -path './var/lib/dpkg/*-old' -o -path ./tmp \) -prune -o -print | sort)
}

now() { date +%s%N; }

# ---- what is tried --------------------------------------------------------------------------------------------------

scene=/usr/share/assay/configs/paper/vortex_cpdi.yaml

try_to_run() {
  as_root apt-get install -y "/$name"
  # shellcheck disable=SC2016
  say "installed: $(in_root "$root" dpkg-query -W -f '${Version}, ${Installed-Size} KiB' assay)," \
    "$(grep -c '^Setting up' "$log") packages in all"
  for script in preinst postinst prerm postrm config; do
    [ ! -e "$root/var/lib/dpkg/info/assay.$script" ] || fail "the package runs a script: $script"
  done
  began=$(now)
  expect 'AS EXPECTED; results in results/vortex_cpdi' assay run $scene
  took=$((($(now) - began) / 1000000))
  say "assay run $scene: $took ms"
  [ -f "$root/trial/results/vortex_cpdi/report.html" ] || fail "no report in the current folder"
  expect 'completed' assay tabulate /usr/share/assay/configs/tabulate/table.yaml
  expect '^neo_hookean' assay materials
  expect 'neo_hookean: pass' assay check neo_hookean --quick
  expect '^neo_hookean' assay materials /usr/lib/assay/materials/libneo_hookean.so
}

try_to_remove() {
  as_root apt-get purge -y assay
  as_root apt-get autoremove -y --purge
  files >"$work/after"
  diff "$work/before" "$work/after" >"$log" || { cat "$log"; fail "something is left, or gone"; }
  say "removed: nothing of it is left"
}

# Somebody else's project, by CMake and by pkg-config. A UMAT that calls a routine of Abaqus needs the utilities' library.
try_to_build() {
  # shellcheck disable=SC2086
  as_root apt-get install -y --no-install-recommends "/$name" $tools
  cp -r "$checkout/tests/downstream" "$root/trial/downstream"
  expect 'Build files' cmake -S downstream -B build -G Ninja -D CMAKE_BUILD_TYPE=Release
  expect 'kirchhoff.so' cmake --build build --verbose
  expect '100% tests passed' ctest --test-dir build -LE must_fail
  say "tests/downstream: $(grep '100% tests passed' "$log")"
  # shellcheck disable=SC2016
  expect 'by_hand.so: pass' sh -ec '
    cc -std=c11 -O2 -fPIC -shared $(pkg-config --cflags assay-abi) downstream/kirchhoff.c -o by_hand.so -lm
    assay check ./by_hand.so --parameters lambda=600,mu=400 --quick'
  say "pkg-config assay-abi: $(in_root "$root" pkg-config --cflags assay-abi)"
  # shellcheck disable=SC2016
  expect 'libassay' sh -ec '
    cc -std=c11 -O2 $(pkg-config --cflags assay) downstream/field.c -o field $(pkg-config --libs assay) && ./field'
  # shellcheck disable=SC2016
  expect 'hooke_umat.yaml: pass' sh -ec '
    sed "s/^      RETURN/      CALL SINV(STRESS,S1,S2,NDI,NSHR)\n&/" downstream/hooke_umat.f >hooke_umat.f
    gfortran -O2 -fPIC -shared -I build/abaqus hooke_umat.f -o hooke_umat.so
    cp downstream/hooke_umat.yaml . && assay check hooke_umat.yaml --quick'
  expect 'AS EXPECTED' sh -ec 'assay new-material clay --language fortran && cmake -S clay -B clay/build -G Ninja &&
    cmake --build clay/build && ctest --test-dir clay/build && assay run clay/vortex.yaml'
  as_root apt-get purge -y assay
  left=$(in_root "$root" find / -xdev -name '*assay*' ! -path '/proc/*' ! -path '/trial/*' ! -path '/var/log/*' \
    ! -path "/$name")
  [ -z "$left" ] || fail "left behind: $left"
}

# Neither engine is needed: their lines are shell.
context=$work/context

copy_in() { # FROM TO: FROM may be a pattern
  # shellcheck disable=SC2086
  (cd "$context" && cp $1 "$root$2")
}

start_image() { # a slim image leaves documents and manuals out
  start
  fetch_tools
  mkdir -p "$context/build"
  mv "$root/$name" "$context/build/"
  printf 'path-exclude /usr/share/doc/*\npath-include /usr/share/doc/*/copyright\npath-exclude /usr/share/man/*\n' \
    >"$root/etc/dpkg/dpkg.cfg.d/docker"
}

try_image() { # WHAT
  expect 'AS EXPECTED' assay run $scene
  [ ! -e "$root/assay.deb" ] || fail "$1 leaves the package behind"
  say "$1: its image runs the scene"
}

try_dockerfile() {
  start_image
  sed -e ':more' -e '/\\$/{N;s/\\\n */ /;b more' -e '}' "$checkout/cmake/package/Dockerfile" >"$work/steps"
  while read -r verb rest; do
    case $verb in
      COPY) copy_in "${rest% *}" "${rest##* }" ;;
      RUN) as_root sh -c "$rest" ;;
      CMD) expect 'Verbs\|Usage\|usage' sh -c "$(printf '%s' "$rest" | tr -d '[],"')" ;;
    esac
  done <"$work/steps"
  try_image Dockerfile
}

section() { # of assay.def
  awk -v wanted="%$1" '/^%/ {inside = $1 == wanted; next} inside' "$checkout/cmake/package/assay.def"
}

try_definition() {
  start_image
  section files >"$work/steps"
  while read -r from to; do
    [ -z "$from" ] || copy_in "$from" "$to"
  done <"$work/steps"
  as_root sh -ec "$(section post)"
  expect 'AS EXPECTED' sh -c "$(section runscript)" sh run $scene
  try_image assay.def
}

if [ ! -f "$cache/made" ]; then
  say "making a bare system"
  make_base
fi
start
fetch_tools
files >"$work/before"
sed -i "\|^./$name\$|d" "$work/before"
try_to_run
rm "$root/$name"
try_to_remove
start
fetch_tools
try_to_build
try_dockerfile
try_definition
say "all is well"
