// SPDX-License-Identifier: MIT
// `sinew retarget` of a VRM animation onto a VRM model beside @pixiv/three-vrm-animation: retarget_vrm_test.mjs SINEW FOLDER
//
// Both take bones of a human body by what the files say. three-vrm plays normalised bones, whose axes are those of the world, and
// then turns the model's own: the equation of `--keep-rest`.
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { pathToFileURL } from 'node:url';

import { bodies, times, written } from './retarget_bodies.mjs';

const [sinew, folder] = process.argv.slice(2);
const modules = process.env.SINEW_THREE ? dirname(process.env.SINEW_THREE) : process.env.NODE_PATH ?? 'node_modules';
const load = file => import(pathToFileURL(join(modules, file)).href);
let THREE, loaders, vrms, animations;
try {
  THREE = await load('three/build/three.module.js');
  loaders = await load('three/examples/jsm/loaders/GLTFLoader.js');
  vrms = await load('@pixiv/three-vrm/lib/three-vrm.module.js');
  animations = await load('@pixiv/three-vrm-animation/lib/three-vrm-animation.module.js');
} catch {
  console.log('no three-vrm: install the npm packages three, @pixiv/three-vrm and @pixiv/three-vrm-animation beside each other and name '
    + 'the folder of three in SINEW_THREE');
  process.exit(77);
}

// Bones that every VRM model has: parent, place of the joint in the world of the animation.
const bones = { hips: [-1, [0, 1, 0]], spine: [0, [0, 1.2, 0]], head: [1, [0, 1.6, 0]],
  leftUpperArm: [1, [0.2, 1.4, 0]], leftLowerArm: [3, [0.5, 1.4, 0]], leftHand: [4, [0.8, 1.4, 0]],
  rightUpperArm: [1, [-0.2, 1.4, 0]], rightLowerArm: [6, [-0.5, 1.4, 0]], rightHand: [7, [-0.8, 1.4, 0]],
  leftUpperLeg: [0, [0.1, 0.9, 0]], leftLowerLeg: [9, [0.1, 0.5, 0]], leftFoot: [10, [0.1, 0.1, 0]],
  rightUpperLeg: [0, [-0.1, 0.9, 0]], rightLowerLeg: [12, [-0.1, 0.5, 0]], rightFoot: [13, [-0.1, 0.1, 0]] };
const names = Object.keys(bones), size = 1.5;
const humanoid = { humanBones: Object.fromEntries(names.map((name, node) => [name, { node }])) };
const extended = (name, more) => ({ extensionsUsed: [name], extensions: { [name]: { specVersion: '1.0', humanoid, ...more } } });

const { body, motion, write } = bodies(THREE, Object.values(bones));
const source = body(1), target = body(size);
mkdirSync(folder, { recursive: true });
const [clips, character, out] = ['clips.gltf', 'character.gltf', 'out.glb'].map(name => join(folder, name));
write(clips, names.map((_, j) => `bone ${j}`), source, motion(source), extended('VRMC_vrm_animation'));
write(character, names.map((_, j) => `joint${j}`), target, undefined,
  extended('VRMC_vrm', { meta: { name: 'body', authors: ['tests'], licenseUrl: 'https://vrm.dev/licenses/1.0/' } }));
execFileSync(sinew, ['retarget', clips, '--onto', character, '-o', out, '--keep-rest']);

globalThis.ProgressEvent ??= Event;  // browsers have it
const loader = new loaders.GLTFLoader();
loader.register(parser => new vrms.VRMLoaderPlugin(parser));
loader.register(parser => new animations.VRMAnimationLoaderPlugin(parser));
const parsed = async file => (await loader.parseAsync(readFileSync(file, 'utf8'), '')).userData;
const [animation] = (await parsed(clips)).vrmAnimations, { vrm } = await parsed(character);
const mixer = new THREE.AnimationMixer(vrm.scene);
mixer.clipAction(animations.createVRMAnimationClip(animation, vrm)).setLoop(THREE.LoopOnce).play();

/// Of unit quaternions; where it is small the arc cosine of their product is rounding alone.
function angle_between(a, b) {
  const chord = sign => Math.hypot(...a.toArray().map((x, i) => x - sign * b.toArray()[i]));
  return 4 * Math.asin(Math.min(chord(1), chord(-1)) / 2);
}

const found = written(out);
let angle = 0, distance = 0, moved = 0;
for (const [key, time] of times.entries()) {
  mixer.setTime(Math.min(time, animation.duration * (1 - 1e-12)));  // at its end it would begin again
  vrm.humanoid.update();
  for (const [j, name] of names.entries()) {
    const bone = vrm.humanoid.getRawBoneNode(name), values = found[`joint${j}`].rotation[1];
    angle = Math.max(angle, angle_between(bone.quaternion, new THREE.Quaternion(...values.slice(4 * key, 4 * key + 4)).normalize()));
    moved = Math.max(moved, angle_between(bone.quaternion, target[j].rotation));
  }
  const place = found.joint0.translation[1].slice(3 * key, 3 * key + 3);
  distance = Math.max(distance, vrm.humanoid.getRawBoneNode('hips').position.distanceTo(new THREE.Vector3(...place)));
}
console.log(`${angle.toExponential(1)} rad of ${moved.toFixed(2)}, hips ${distance.toExponential(1)} m`);
if (!(angle < 1e-5 && distance < 1e-5 && moved > 0.5)) process.exit(1);
