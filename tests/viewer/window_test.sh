#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Opens the viewer's window on a virtual display and uses it as a person would: usage: window_test.sh SINEW-VIEWER
# Exit code 77 = skipped, because a tool is missing.
set -uo pipefail

viewer=$1
for tool in Xvfb xdotool import compare convert; do
  command -v "$tool" > /dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done

export MAGICK_THREAD_LIMIT=1  # threads of ImageMagick wait for each other in a loop: small pictures, busy machines
pictures=$(mktemp -d)
export SINEW_CACHE=$pictures/cache
pid=
server=
finish() {
  [ -z "$pid" ] || kill "$pid" 2> /dev/null
  [ -z "$server" ] || kill "$server" 2> /dev/null
  rm -rf "$pictures"
}
trap finish EXIT

# The server picks a free display itself: two tests at the same time never take the same one. It would begin anew when its last window
# closes, and the next one might find it closed.
Xvfb -displayfd 3 -screen 0 1280x800x24 -nolisten tcp -noreset 3> "$pictures/display" 2> "$pictures/server" &
server=$!
for ((i = 0; i < 1200; i++)); do [ -s "$pictures/display" ] && break; sleep 0.1; done
[ -s "$pictures/display" ] || { echo "FAILED: no virtual display"; cat "$pictures/server"; exit 1; }
DISPLAY=:$(cat "$pictures/display")
export DISPLAY
unset WAYLAND_DISPLAY

fail() {
  echo "FAILED: $*"
  echo "--- what the viewer wrote:"
  cat "$pictures/messages"
  if [ -n "${WINDOW_TEST_KEEP:-}" ]; then cp -r "$pictures" "$WINDOW_TEST_KEEP"; fi
  exit 1
}

passed() { echo "ok: $*"; }

# Tries a command until it succeeds. Only what never happens takes the 120 seconds: machines differ in speed.
wait_until() {
  local what=$1 last=$((SECONDS + 120))
  shift
  until "$@"; do
    kill -0 "$pid" 2> /dev/null || fail "the viewer ended by itself before: $what"
    [ "$SECONDS" -lt "$last" ] || fail "$what"
    sleep 0.1
  done
}
eventually() { wait_until "$@"; passed "$1"; }

shot() { import -silent -window "$window" "$pictures/$1.ppm" 2> /dev/null; }
same() { cmp -s "$pictures/$1.ppm" "$pictures/$2.ppm"; }
press() { xdotool key --clearmodifiers "$@"; }
differs_now() { shot now && ! same now "$1"; }
equals_now() { shot now && same now "$1"; }

find_window() {
  window=$(xdotool search --onlyvisible --name 'sinew$' 2> /dev/null | head -1)
  [ -n "$window" ]
}
colors() { convert "$pictures/now.ppm" -format %k info:; }
has_picture() { shot now && [ "$(colors)" -gt 500 ]; }
size_is() { [ "$(sed -n '2{s/ /x/p;q}' "$pictures/now.ppm")" = "$1" ]; }
# The corner farthest from the origin was drawn to: outside of what is drawn, the display is black.
corner_is_drawn() { shot now && size_is "$1" && [ "$(convert "$pictures/now.ppm" -gravity SouthEast -crop 8x8+2+2 -format '%[fx:minima>0.05]' info:)" = 1 ]; }

# The viewer has handled the keys before this, and drawn after them, however slow it is: events come in order, and each of
# these sizes has a corner that no picture of the other one reaches.
settle() {
  xdotool windowsize "$window" 620 420
  wait_until "a picture of 620x420" corner_is_drawn 620x420
  xdotool windowsize "$window" 640 400
  wait_until "a picture of 640x400" corner_is_drawn 640x400
}
# The pictures of two frames are the same, and become NAME.
still() { settle && shot before && settle && shot "$1" && same before "$1"; }
title_is() { [ "$(xdotool getwindowname "$window")" = "$1 - sinew" ]; }
is_grey() { shot now && [ "$(convert "$pictures/now.ppm" -colorspace HSL -channel G -separate -format '%[fx:mean<0.02]' info:)" = 1 ]; }

: > "$pictures/messages"
VK_DRIVER_FILES=/nowhere.json VK_ICD_FILENAMES=/nowhere.json "$viewer" 2> "$pictures/messages"
[ $? = 3 ] && grep -q 'no Vulkan driver for this display.*mesa-vulkan-drivers' "$pictures/messages" || fail "no driver, and no word of it"
passed "without a driver it says which package has one"

"$viewer" --validate --size 640x400 --scene 0 2> "$pictures/messages" &
pid=$!
eventually "the window opens" find_window
xdotool windowfocus "$window"
eventually "it shows a picture that is not blank" has_picture
shot first
eventually "the picture moves" differs_now first

press space
eventually "space holds the picture" still paused
press h
eventually "h hides the panel" differs_now paused
eventually "nothing moves without the panel" still bare
press h
eventually "h brings the very same picture back" equals_now paused
press h
eventually "and hides it again" equals_now bare

press Right
eventually "right steps to another pose" differs_now bare
eventually "which stands still" still stepped
press Right
eventually "right steps on" differs_now stepped
press Left
eventually "left steps back to the very same picture" equals_now stepped

press s
eventually "s shows the skeleton" differs_now stepped
press s
eventually "s hides it" equals_now stepped
press a
eventually "a turns ambient occlusion off" differs_now stepped
press a
eventually "a turns it on" equals_now stepped
press o
eventually "o shows ambient occlusion only, in grey" is_grey
press o
eventually "o goes back" equals_now stepped

press h
eventually "the panel comes back" differs_now stepped
eventually "and stays as it is" still panel
press e
eventually "e shows the live plan" differs_now panel
press e
eventually "e hides it" equals_now panel
press h
eventually "h hides the panel again" equals_now stepped

xdotool mousemove --window "$window" 320 200 mousedown 1
sleep 0.3
xdotool mousemove --window "$window" 400 200
sleep 0.3
xdotool mouseup 1
eventually "dragging turns the camera" differs_now stepped
eventually "and it stays there" still turned
xdotool click 4
eventually "the wheel goes nearer" differs_now turned
press f
eventually "f frames everything" differs_now turned

xdotool windowsize "$window" 900 600
eventually "a larger window is filled" corner_is_drawn 900x600
xdotool windowsize "$window" 320 260
eventually "a smaller window is filled" corner_is_drawn 320x260
xdotool windowunmap "$window"
sleep 0.5
xdotool windowmap "$window"
xdotool windowsize "$window" 640 400
eventually "a window that was hidden is filled again" corner_is_drawn 640x400
xdotool windowfocus "$window"
shot before_tab
for scene in "twisted arms" "morphed face" "flag in wind"; do
  press Tab
  eventually "tab shows the next scene: $scene" title_is "$scene"
  eventually "and its picture" differs_now before_tab
  shot before_tab
done
press d n p l Up Down v space

sleep 0.3
closes() {  # expected exit code
  press q
  local last=$((SECONDS + 120))
  while kill -0 "$pid" 2> /dev/null; do [ "$SECONDS" -lt "$last" ] || fail "q closes the window"; sleep 0.1; done
  wait "$pid"
  code=$?
  pid=
  [ "$code" = "$1" ] || fail "the exit code after q is $1, was $code"
  passed "q closes the window with exit code $1"
}
quit() {
  closes 0
  [ ! -s "$pictures/messages" ] || fail "the viewer and Vulkan's validation layer have nothing to say"
  passed "validation was silent"
}
quit

"$viewer" --validate --size 640x400 --scene 3 2> "$pictures/messages" &
pid=$!
eventually "a window with a geometry cache opens" find_window
xdotool windowfocus "$window"
eventually "it shows a picture" has_picture
press h
shot first
eventually "the flag flies" differs_now first
press space
eventually "space holds it" still paused
press Right
eventually "right steps to another frame of the cache" differs_now paused
eventually "which stands still" still stepped
press Right Right
eventually "right steps on" differs_now stepped
press Left Left
eventually "left goes back to the very same picture" equals_now stepped
press l l space
eventually "the flag flies on" differs_now stepped
at_the_end() { still end && sleep 1 && equals_now end && ! same end stepped; }
eventually "played once, it stops at its end" at_the_end
press Right Right
eventually "from there the next frame is the second one" differs_now end
eventually "which stands still, too" still second
press Left Left
eventually "and back over the seam, where frames are read again, is the very same picture" equals_now end
quit

# A file that changes while it is shown. Each state is written beside and moved over the file at once, as programs save.
triangle='"scene":0,"scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0},{"camera":0,"translation":[0.4,0.8,2.5]}],
"cameras":[{"type":"perspective","perspective":{"yfov":0.9,"znear":0.1}}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],"bufferViews":[{"buffer":0,"byteLength":36}],
"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]'
save() {
  printf '%s' "$1" > "$pictures/new"
  mv "$pictures/new" "$pictures/face.gltf"
}
save_color() {
  save '{"asset":{"version":"2.0"},'"$triangle"',"materials":[{"doubleSided":true,"pbrMetallicRoughness":{"baseColorFactor":['"$1"',1]}}]}'
}
says() { [ "$(grep -c "$1" "$pictures/messages")" = "$2" ]; }
save_color 0.8,0.1,0.1
: > "$pictures/messages"
"$viewer" --validate --watch --camera 0 --size 640x400 "$pictures/face.gltf" 2> "$pictures/messages" &
pid=$!
eventually "a window that watches its file opens" find_window
xdotool windowfocus "$window"
eventually "it shows a picture" has_picture
press h
eventually "which stands still" still red
save_color 0.1,0.1,0.8
eventually "a changed file is shown" differs_now red
eventually "and stands still" still blue
save '{"asset":{"version"'
eventually "a broken file is named" says 'face.gltf.*error.*shown as before' 1
sleep 1
says 'shown as before' 1 || fail "a broken file is named once"
passed "once"
eventually "the picture stays" equals_now blue
save_color 0.8,0.1,0.1
eventually "a file that is whole again is shown as before" equals_now red
eventually "and that is said" says 'face.gltf: read again' 2
xdotool mousemove --window "$window" 320 200 mousedown 1
sleep 0.3
xdotool mousemove --window "$window" 400 200
sleep 0.3
xdotool mouseup 1
eventually "dragging turns on from the camera of the file" differs_now red
eventually "and it stays there" still turned
save_color 0.1,0.1,0.8
eventually "a changed file is shown from there" differs_now turned
save_color 0.8,0.1,0.1
eventually "and changed back it is the very same picture" equals_now turned
grep -v 'shown as before$\|: read again$' "$pictures/messages" && fail "the validation layer has nothing to say"
: > "$pictures/messages"
quit

# A cache that breaks while it plays: a byte of its last frame. The window says so once, and goes on.
cp "$(dirname "$0")/../golden/cloth.sgeo" "$pictures/broken.sgeo"
printf '\377' | dd of="$pictures/broken.sgeo" bs=1 seek=$(($(stat -c %s "$pictures/broken.sgeo") - 40)) conv=notrunc 2> /dev/null
"$viewer" --size 320x240 "$pictures/broken.sgeo" 2> "$pictures/messages" &
pid=$!
eventually "a window with a broken cache opens" find_window
xdotool windowfocus "$window"
broken='broken.sgeo: cache-checksum: a frame is not as it was written'
eventually "the broken frame is named" says "$broken" 1
sleep 1
says "$broken" 1 || fail "a broken frame is named once"
passed "a broken frame is named once"
closes 1

timeout 120 "$viewer" --exit-after 1 --size 64x64 --ao rays "$pictures/face.gltf" 2> "$pictures/messages"
[ $? = 0 ] && says 'face.gltf: ambient visibility of 1 pose' 1 || fail "rays are cast for the window"
passed "rays are cast for the window"

timeout 120 "$viewer" --exit-after 0.5 --size 320x240 2> "$pictures/messages"
code=$?
[ "$code" = 0 ] || fail "--exit-after closes with exit code 0, was $code"
passed "--exit-after closes the window"

env -u DISPLAY -u WAYLAND_DISPLAY "$viewer" 2> "$pictures/messages"
code=$?
[ "$code" = 3 ] && grep -q -- '--headless' "$pictures/messages" || fail "without a display: exit code 3 and what to do instead, was $code"
passed "without a display it says what to do instead"
