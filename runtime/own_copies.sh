#!/bin/sh
# SPDX-License-Identifier: MIT
# own_copies.sh AR LD OBJCOPY NM OPERATION ARCHIVE OBJECT...
# Adds objects to an archive so that they call their own copies of inline functions. An inline function is a weak symbol in
# every object that uses it, and the linker keeps the first copy that it meets. That may be an engine's, compiled with other flags.
# Here the COMDAT groups of each object are dissolved, and its weak symbols become local.
#   exceptions, RTTI   libstdc++ compares types by name, so copies of type information are equal
#   static variables   those of inline functions exist once an object; the library keeps none that are written (a test reads this)
set -eu
ar=$1 ld=$2 objcopy=$3 nm=$4 operation=$5 archive=$6
shift 6
scratch=$(mktemp -d "$archive.XXXXXX")
trap 'rm -rf "$scratch"' EXIT
count=$#
while [ "$count" -gt 0 ]; do
  own=$scratch/$count/${1##*/}  # members of the archive keep their names
  mkdir "$scratch/$count"
  "$ld" -r --force-group-allocation -o "$own" "$1"
  "$nm" -P --defined-only "$own" | sed -n 's/ [WVu] .*//p' > "$scratch/weak"
  if [ -s "$scratch/weak" ]; then
    "$objcopy" --weaken-symbols="$scratch/weak" "$own"  # objcopy makes no unique symbol (GNU) local unless it is weak before
    "$objcopy" --localize-symbols="$scratch/weak" "$own"
  fi
  shift
  set -- "$@" "$own"
  count=$((count - 1))
done
"$ar" "$operation" "$archive" "$@"
