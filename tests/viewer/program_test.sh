#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs the viewer as a program without a display: exit codes, messages and the pictures that it writes.
# usage: program_test.sh SINEW-VIEWER SINEW-SHOWCASE;   exit code 77 = skipped, because a tool is missing
set -uo pipefail

viewer=$1 showcase=$2
for tool in convert identify; do
  command -v "$tool" > /dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done
export MAGICK_THREAD_LIMIT=1
unset DISPLAY WAYLAND_DISPLAY
readme=$(cd "$(dirname "$0")/../../viewer" && pwd)/README.md
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
export SINEW_CACHE=$folder/cache
failures=0

complain() {
  echo "FAILED: $*"
  sed 's/^/    /' err
  failures=$((failures + 1))
}

# ends CODE TEXT ARGUMENTS...: the exit code, and what standard error must contain ("" = nothing at all)
ends() {
  local code=$1 text=$2 got
  shift 2
  "$viewer" "$@" > out 2> err
  got=$?
  if [ "$got" != "$code" ]; then complain "$* ends with $got, not $code"
  elif [ -z "$text" ] && [ -s err ]; then complain "$* complains"
  elif [ -n "$text" ] && ! grep -qiF -- "$text" err; then complain "$* does not say '$text'"
  else echo "ok: $* -> $code $text"; fi
}

# holds WHAT EXPRESSION PICTURE: an ImageMagick expression that must be 1
holds() {
  if [ "$(convert "$3" -format "%[fx:$2]" info: 2>&1)" = 1 ]; then echo "ok: $1"; else complain "$1"; fi
}

printf 'glTF\2\0\0\0' > short.glb
printf '{"asset":{"version":"2.0"},' > broken.gltf
printf '{"asset":{"version":"2.0"}}' > empty.gltf
printf '{"asset":{"version":"2.0"},"nodes":[{"children":[1]},{"translation":[0,1,0]}],"scenes":[{"nodes":[0]}],"scene":0}' > bones.gltf

ends 0 '' --help
grep -q -- '--headless' out || complain "--help is on standard output"
for option in $(grep -oE -- '--[a-z][a-z-]+' out | sort -u | grep -vE '^--(help|version)$'); do
  grep -qF -- "$option" "$readme" || complain "viewer/README.md does not name $option"
done
ends 0 '' --version
ends 2 --bogus --bogus
ends 2 'built-in scenes' --scene 99 --headless a.png
ends 2 'no such clip' --clip Fly --headless a.png
ends 1 missing.glb missing.glb --headless a.png
ends 1 short.glb short.glb --headless a.png
ends 1 broken.gltf broken.gltf --headless a.png
ends 3 a.png --headless no/such/folder/a.png --size 32x32
touch file
ends 3 file --headless file/ --frames 0:1 --size 32x32
ends 3 --headless
ends 2 'excludes --watch' --watch bones.gltf --headless a.png
ends 2 'FILE' --watch
ends 3 'display' --watch bones.gltf

VK_LAYER_PATH=/nowhere ends 3 'the validation layer is not installed' bones.gltf --validate --headless a.png
ends 2 'no such camera' bones.gltf --camera 0 --headless a.png
ends 2 'no such variant' bones.gltf --variant red --headless a.png
printf '{"asset":{"version":"2.0"},"nodes":[{"translation":[0,1,0]},{"camera":0,"translation":[0,0,5]},{"camera":1,"translation":[0,0,5]}],' > cameras.gltf
printf '"cameras":[{"type":"orthographic","orthographic":{"xmag":2,"ymag":2,"znear":0.1,"zfar":20}},' >> cameras.gltf
printf '{"name":"wide","type":"perspective","perspective":{"yfov":1,"znear":0.1}}]}' >> cameras.gltf
ends 0 '' cameras.gltf --camera 0 --headless a.png --size 64x64 --validate
ends 0 '' cameras.gltf --camera wide --headless a.png --size 64x64 --validate
ends 2 'excludes' cameras.gltf --camera wide --fov 20 --headless a.png
light='{"extensions":{"KHR_lights_punctual":{"light":0}}}'
printf '{"asset":{"version":"2.0"},"extensionsUsed":["KHR_lights_punctual"],"nodes":[%s%s],' "$(printf "$light,%.0s" {1..16})" "$light" > lights.gltf
printf '"extensions":{"KHR_lights_punctual":{"lights":[{"type":"point"}]}}}' >> lights.gltf
ends 0 '17 lights; the viewer uses the first 16' lights.gltf --headless a.png --size 64x64

used='"extensionsUsed":["KHR_materials_dispersion","KHR_materials_unlit","KHR_materials_diffuse_transmission","KHR_xmp"]'
printf '{"asset":{"version":"2.0"},%s}' "$used" > looks.gltf
ends 0 'warning: not shown: KHR_materials_dispersion, KHR_materials_diffuse_transmission' looks.gltf --headless a.png --size 64x64

ends 1 'no/sky.hdr: there is no such file' --environment no/sky.hdr --headless a.png
ends 1 'broken.gltf: neither Radiance' --environment broken.gltf --headless a.png
ends 0 '' --environment none --headless dark.png --size 320x180 --time 1 --validate
ends 0 '' --environment plain --backdrop sharp --tone aces --headless plain.png --size 320x180 --time 1 --validate
cmp -s dark.png plain.png && complain "--environment changes nothing"
ends 0 '' --exposure -2 --headless exposed.png --size 320x180 --time 1
ends 0 '' --exposure auto --headless followed.png --size 320x180 --time 1 --validate --plan
grep -q 'exposure .* on .*log average' out || complain "--plan does not tell the exposure"
ends 0 '' --exposure auto --headless wide.png --size 4000x1 --time 1 --validate
ends 0 '' --exposure auto --headless dot.png --size 1x1 --time 1 --validate
ends 0 '' --shading gooch --headless gooch.png --size 320x180 --time 1 --validate --plan
grep -q 'outline .* on .*silhouettes' out || complain "--plan does not tell the outlines"
ends 0 '' --shading gooch --ground grid --smoothing off --headless lines.png --size 320x180 --time 1 --validate
ends 0 '' --shading gooch --backdrop blurred --transparent --headless clear.png --size 320x180 --time 1 --validate
ends 0 '' --shading gooch --show normals --headless shown.png --size 64x64 --time 1 --validate
ends 0 '' --shading gooch --headless wide.png --size 4000x1 --time 1 --validate
ends 0 '' --shading gooch --headless dot.png --size 1x1 --time 1 --validate
ends 0 '' --environment-turn 120 --headless turned.png --size 320x180 --time 1

ends 0 '' --headless a.png --size 320x180 --time 1 --validate
cmp -s a.png turned.png && complain "--environment-turn changes nothing"
cmp -s a.png followed.png && complain "--exposure auto changes nothing"
cmp -s a.png gooch.png && complain "--shading changes nothing"
cmp -s a.png exposed.png && complain "--exposure changes nothing"
ends 0 '' --headless b.png --size 320x180 --time 1
if cmp -s a.png b.png; then echo "ok: the same picture twice is the same bytes"; else complain "the same picture twice differs"; fi
[ -s cache/studio.light ] || complain "prepared light is not kept: $(ls cache)"
for change in ': > $kept' 'printf x >> $kept' 'rm -r cache && touch cache'; do
  for kept in cache/*; do eval "$change"; done
  ends 0 '' --headless b.png --size 320x180 --time 1 --validate
  if cmp -s a.png b.png; then echo "ok: the same picture after '$change'"; else complain "'$change' of kept files changes the picture"; fi
done
export SINEW_CACHE=none
# Ambient visibility at vertices: baked at load, for key poses, or as the file has it.
size='--size 320x180'
ends 2 'rays are cast with --ao rays only' --ao gtao --key-poses 3 --headless c.png
ends 2 'not a number from 2 to 64' --ao rays --key-poses 1 --headless c.png
printf '%s' '{"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"_AMBIENT_ACCESS":1}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
{"bufferView":0,"componentType":5126,"count":3,"type":"SCALAR"}],"bufferViews":[{"buffer":0,"byteLength":36}],
"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]}' > dark.gltf
if "$viewer" dark.gltf --ao rays --headless c.png 2>&1 | grep -q 'without Embree'; then
  echo "left out: ambient visibility by rays, in a build without Embree"
else
  ends 0 '' dark.gltf --ao rays --show ao --headless c.png $size --ground none --validate
  holds "a file's own ambient visibility is shown" 'minima==0&&maxima==1' c.png
  ends 0 'ambient visibility of 3 key poses, 256 rays a vertex, baked in ' --scene 1 --ao rays --key-poses 3 --headless d.png $size --time 1 --validate
  ends 0 'ambient visibility of 1 pose, 256 rays a vertex, baked in ' --scene 1 --ao rays --headless c.png $size --time 1 --validate --plan
  grep -q 'ssao .* off  *0 .*ambient visibility comes with the vertices' out || complain "--plan does not say why there is no ssao"
  cmp -s c.png d.png && complain "--key-poses changes nothing"
  ends 0 '' --scene 1 --no-ao --headless d.png $size --time 1
  cmp -s c.png d.png && complain "--ao rays changes nothing"
fi
holds "the picture has the size that was asked for" 'w==320&&h==180' a.png
holds "and shows something" 'standard_deviation>0.05' a.png
ends 0 '' --headless c.png --size 320x180 --time 3
cmp -s a.png c.png && complain "another time shows the same pose"
ends 0 '' --headless none.png --size 320x180 --clip none
cmp -s a.png none.png && complain "the rest pose looks like the clip"
ends 0 '' --headless ao.png --size 320x180 --time 1 --show ao
[ "$(convert ao.png -colorspace HSL -channel G -separate -format '%[fx:maxima<0.01]' info:)" = 1 ] || complain "--show ao is not grey"
ends 0 '' --headless flat.png --size 320x180 --time 1 --no-ao
cmp -s a.png flat.png && complain "--no-ao changes nothing"
ends 0 '' --scene 3 --headless clear.png --size 320x180 --time 1 --transparent
holds "--transparent leaves the background clear" 'minima.a==0&&maxima.a==1' clear.png
ends 0 '' --headless sky.png --size 64x64 --transparent --eye 0,50,0 --target 0,60,0
holds "a camera that looks away sees nothing" 'maxima.a==0' sky.png
# A file with several scenes shows one of them.
printf '%s' '{"asset":{"version":"2.0"},"scene":1,"scenes":[{"nodes":[0]},{"nodes":[1]}],"nodes":[{"mesh":0},{"mesh":0,"scale":[1,3,1]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",
"min":[0,0,0],"max":[1,1,0]}],"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,
"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]}' > scenes.gltf
ends 0 '2 scenes; scene 1 is shown' scenes.gltf --headless default.png --size 64x64
ends 0 '' scenes.gltf --scene 1 --headless second.png --size 64x64
ends 0 '' scenes.gltf --scene 0 --headless first.png --size 64x64
cmp -s default.png second.png || complain "the file's default scene is shown"
! cmp -s first.png second.png || complain "--scene shows another scene of a file"
ends 2 'scenes 0 to 1' scenes.gltf --scene 2 --headless a.png
ends 2 'has no scenes' empty.gltf --scene 0 --headless a.png
ends 0 '' --scene 1 --headless lbs.png --size 320x180 --time 3 --skinning linear

ends 0 '' --headless planned.png --size 320x180 --time 1 --plan
if cmp -s a.png planned.png; then echo "ok: looking at the plan changes no picture"; else complain "--plan changes the picture"; fi
for row in 'sample  .* on .* us ' 'skin_linear .* off ' 'upload ' 'ssao .* on ' 'transparent .* off '; do
  if grep -q -- "$row" out; then echo "ok: --plan tells '$row'"; else complain "--plan does not tell '$row': $(cat out)"; fi
done
ends 0 '' --headless planned.png --size 320x180 --time 1 --no-ao --plan
grep -q 'ssao .* off .* switched off' out || complain "--plan does not say why there is no ssao"
ends 2 'requires' --plan
ends 0 '' --headless frames/ --size 64x36 --frames 3:6 --fps 2 --scene 2
if [ "$(ls frames)" = "$(printf '%05d.png\n' 3 4 5 6)" ]; then echo "ok: frames 3 to 6 are numbered"; else complain "frames: $(ls frames)"; fi
ends 0 '' --headless one.png --size 64x36 --time 1.5 --scene 2
if cmp -s one.png frames/00003.png; then echo "ok: frame 3 at 2 a second is second 1.5"; else complain "frame 3 is not second 1.5"; fi

ends 0 '' empty.gltf --headless nothing.png --size 64x64
ends 0 '' bones.gltf --headless bones.png --size 64x64 --transparent
holds "a file of bones shows its skeleton" 'maxima.a>0.9' bones.png
ends 0 '' --headless lines.png --size 320x180 --time 1 --skeleton
cmp -s a.png lines.png && complain "--skeleton draws nothing"

"$showcase" scenes > out 2> err || complain "sinew-showcase scenes"
flag=scenes/flag-in-wind
size='--size 160x90'
ends 0 '' $flag.sgeo --headless alone.png $size --time 1.5 --validate
holds "a geometry cache alone is shown" 'standard_deviation>0.05' alone.png
ends 0 '' $flag.glb --headless flat.png $size
ends 0 '' $flag.glb --cache $flag.sgeo --headless moved.png $size --time 1.5 --validate
cmp -s flat.png moved.png && complain "--cache changes nothing"
ends 0 '' $flag.glb --cache $flag.sgeo --cache-weight 0 --headless w0.png $size --time 1.5 --eye 2.7,1.9,6.8 --target 1,2,0
ends 0 '' $flag.glb --headless posed.png $size --eye 2.7,1.9,6.8 --target 1,2,0
if cmp -s w0.png posed.png; then echo "ok: --cache-weight 0 shows the pose"; else complain "--cache-weight 0 is not the pose"; fi
ends 0 '' $flag.glb --cache $flag.sgeo --headless played/ $size --frames 0:9 --fps 2 --eye 2.7,1.9,6.8 --target 1,2,0
ends 0 '' $flag.glb --cache $flag.sgeo --headless one.png $size --time 1.5 --eye 2.7,1.9,6.8 --target 1,2,0
if cmp -s one.png played/00003.png; then echo "ok: a seek shows what playing shows"; else complain "second 1.5 depends on what was shown before"; fi
if cmp -s played/00001.png played/00009.png; then echo "ok: four seconds later it repeats"; else complain "the flag does not repeat"; fi
ends 0 '' --scene 3 --headless own.png $size --time 1.5 --plan
for row in 'geometry_cache  *on ' 'cache window  *on .*frames decoded, 2501 vertices'; do
  if grep -q -- "$row" out; then echo "ok: --plan tells '$row'"; else complain "--plan does not tell '$row': $(cat out)"; fi
done
ends 1 'missing.sgeo: No such file' missing.sgeo --headless a.png
ends 1 'missing.sgeo: No such file' $flag.glb --cache missing.sgeo --headless a.png
ends 2 'a geometry cache itself' $flag.sgeo --cache $flag.sgeo --headless a.png
ends 1 'no mesh of the scene fits' scenes/skull-flight.glb --cache $flag.sgeo --headless a.png
head -c 300000 $flag.sgeo > cut.sgeo
ends 1 'cache-size' cut.sgeo --headless a.png
{ head -c 8 $flag.sgeo; printf '\177'; tail -c +10 $flag.sgeo; } > newer.sgeo
ends 1 'cache-version' newer.sgeo --headless a.png
{ head -c 500000 $flag.sgeo; printf '\125\125\125\125'; tail -c +500005 $flag.sgeo; } > damaged.sgeo
rm -f a.png
ends 1 "cache-checksum" damaged.sgeo --headless alone/ --frames 0:119 --size 16x16
ends 1 'cache-checksum' $flag.glb --cache damaged.sgeo --headless damaged/ --frames 0:119 --size 16x16
[ "$(ls damaged | wc -l)" -lt 120 ] || complain "pictures without the cache were written"

[ "$failures" = 0 ]
