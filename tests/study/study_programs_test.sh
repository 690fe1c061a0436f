#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs the programs that measure passes: their tables and JSON, what they refuse, and what they say without a device.
# usage: study_programs_test.sh FRAME-STUDY SHADING-STUDY OCCLUSION-STUDY SINEW-SHOWCASE
set -uo pipefail

frame=$1 shading=$2 occlusion=$3 showcase=$4
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
failures=0

# ends CODE STREAM TEXT PROGRAM ARGUMENTS...: the exit code, and a line that STREAM (out or err) must have (a regular expression)
ends() {
  local code=$1 stream=$2 text=$3 got
  shift 3
  "$@" > out 2> err
  got=$?
  if [ "$got" = "$code" ] && grep -qE -- "$text" "$stream"; then
    echo "ok: ${*##*/} -> $code, $text"
  else
    echo "FAILED: ${*##*/} ends with $got, not $code, or does not say '$text'"
    sed 's/^/    /' out err
    failures=$((failures + 1))
  fi
}

"$showcase" scenes > /dev/null || exit 1
small=(--width 32 --height 18 --repetitions 1)
number='[0-9]+\.[0-9]'

ends 0 out "^.+, 32 x 18$" "$frame" "${small[@]}" scenes/twisted-arms.glb
for row in "\| 19 \| $number \| $number \| ${number}[0-9] \|" "\| 115 \| $number \| $number \| ${number}[0-9] \|" \
  "\| twisted-arms.glb \| [1-9][0-9]* \| [1-9][0-9]+ \| $number \| $number \| ${number}[0-9] \|" \
  "\| doll of 19 parts \| 19 \| 43776 \| $number \| $number \| ${number}[0-9] \|" \
  "\| ball \| 1 \| 100352 \| $number \| $number \| ${number}[0-9] \|"; do
  grep -qE "^$row$" out || { echo "FAILED: no row $row"; cat out; failures=$((failures + 1)); }
done
ends 1 err "sinew-frame-study: .*missing.glb" "$frame" "${small[@]}" missing.glb
ends 0 out "^\| trilinear \| $number" "$shading" "${small[@]}"
ends 0 out "^\| quaternion \| $number" "$shading" "${small[@]}"
ends 0 out '"filters"' "$shading" --quick --json
ends 1 err "sinew-occlusion-study: .*missing.glb" "$occlusion" --quick missing.glb
ends 2 err "sinew-occlusion-study: .*nowhere" "$occlusion" --quick --clip nowhere scenes/twisted-arms.glb
ends 0 out '"exhaustive_horizons"' "$occlusion" --quick --clip none scenes/twisted-arms.glb

# Without a driver there is nothing to measure: an error for a person, a reason for a program.
export VK_DRIVER_FILES=/nowhere.json VK_ICD_FILENAMES=/nowhere.json
ends 3 err "sinew-frame-study: there is no Vulkan device" "$frame" "${small[@]}"
ends 3 err "sinew-shading-study: there is no Vulkan device" "$shading" "${small[@]}"
ends 0 out '"left_out": ?"there is no Vulkan device' "$shading" --json
ends 0 out '"left_out": ?"there is no Vulkan device' "$occlusion" --quick
[ "$failures" = 0 ]
