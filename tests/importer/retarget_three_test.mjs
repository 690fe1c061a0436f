// SPDX-License-Identifier: MIT
// `sinew retarget` beside SkeletonUtils.retargetClip of three.js: retarget_three_test.mjs SINEW FOLDER
//
// three.js gives each bone the rotation that the other one has in the world. That is right where both rest with the same
// axes. With other axes it needs an offset for each bone, from the rest poses: then it is the same equation as
// `--keep-rest`, and both have to agree. Without offsets it is wrong, and the last check says by how much.
// Its frames lie duration / (n - 1) apart for n frames of 1 / fps, so clips are compared at the times that it writes.
import { execFileSync } from 'node:child_process';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

import { bodies, duration, times, written } from './retarget_bodies.mjs';

const [sinew, folder] = process.argv.slice(2);
const three = process.env.SINEW_THREE ?? join(process.env.NODE_PATH ?? 'node_modules', 'three');
const load = file => import(pathToFileURL(join(three, file)).href);
let THREE, utils;
try {
  THREE = await load('build/three.module.js');
  utils = await load('examples/jsm/utils/SkeletonUtils.js');
} catch {
  console.log('no three.js: install the npm package three and name its folder in SINEW_THREE');
  process.exit(77);
}
const { Quaternion, Vector3, Matrix4 } = THREE;

// Bones: name on the source, name on the target, parent, place of the joint in the world of the source.
const bones = [['mixamorig:Hips', 'pelvis', -1, [0, 1, 0]], ['mixamorig:Spine', 'spine_01', 0, [0, 1.2, 0]],
  ['mixamorig:LeftUpLeg', 'thigh_l', 0, [0.1, 0.9, 0]], ['mixamorig:Neck', 'neck_01', 1, [0, 1.5, 0]],
  ['mixamorig:LeftArm', 'upperarm_l', 1, [0.2, 1.4, 0]], ['mixamorig:LeftLeg', 'calf_l', 2, [0.1, 0.5, 0]],
  ['mixamorig:LeftForeArm', 'lowerarm_l', 4, [0.5, 1.4, 0]], ['mixamorig:LeftFoot', 'foot_l', 5, [0.1, 0, 0]],
  ['mixamorig:LeftHand', 'hand_l', 6, [0.8, 1.4, 0]]];
const lowered = { 6: [0.4, 1.15, 0], 8: [0.6, 0.9, 0] };  // the target rests with its arm down
const size = 1.5;  // of the target, in all lengths: the ratio of heights

const { body, motion, write } = bodies(THREE, bones.map(([, , parent, place]) => [parent, place]));
const source = body(1), target = body(size, lowered), { turns, path } = motion(source);

function mesh(names, joints) {
  const made = joints.map((joint, j) => {
    const bone = new THREE.Bone();
    bone.name = names[j];
    bone.position.copy(joint.place);
    bone.quaternion.copy(joint.rotation);
    return bone;
  });
  bones.forEach(([, , parent], j) => parent >= 0 && made[parent].add(made[j]));
  const skinned = new THREE.SkinnedMesh(new THREE.BufferGeometry(), new THREE.MeshBasicMaterial());
  skinned.add(made[0]);
  skinned.updateMatrixWorld(true);
  skinned.bind(new THREE.Skeleton(made));
  return skinned;
}

const names = bones.map(b => b[0].replace('mixamorig:', '')), ours = bones.map(b => b[1]);  // tracks of three.js have no colons
function by_three(localOffsets) {
  const tracks = bones.map((_, j) => new THREE.QuaternionKeyframeTrack(`${names[j]}.quaternion`, times, turns[j].flatMap(q => q.toArray())));
  tracks.push(new THREE.VectorKeyframeTrack('Hips.position', times, path.flat()));
  return utils.retargetClip(mesh(ours, target), mesh(names, source), new THREE.AnimationClip('move', duration, tracks),
    { names: Object.fromEntries(ours.map((name, j) => [name, names[j]])), hip: 'Hips', scale: size, fps: 30, localOffsets });
}

/// The largest angle between rotations of both, and distance of the hips, at the times of three.js but the last, of which it
/// says itself that it lies before its time.
function differences(clip, found) {
  let angle = 0, distance = 0;
  for (const track of clip.tracks) {
    const name = track.name.match(/\[(\w+)\]|^(\w+)\./).slice(1).find(Boolean), moves = track.name.endsWith('.position');
    const [key_times, values] = found[name][moves ? 'translation' : 'rotation'];
    const curve = moves ? new THREE.VectorKeyframeTrack('a.position', key_times, values) : new THREE.QuaternionKeyframeTrack('a.quaternion', key_times, values);
    const at = curve.createInterpolant(new (moves ? Float32Array : Float64Array)(moves ? 3 : 4)), width = moves ? 3 : 4;
    track.times.slice(0, -1).forEach((time, i) => {
      const expected = track.values.slice(width * i, width * (i + 1)), mine = Array.from(at.evaluate(time));
      if (moves) distance = Math.max(distance, new Vector3(...expected).distanceTo(new Vector3(...mine)));
      else angle = Math.max(angle, new Quaternion(...expected).normalize().angleTo(new Quaternion(...mine).normalize()));
    });
  }
  return [angle, distance];
}

mkdirSync(folder, { recursive: true });
const [clips, character, out] = ['clips.gltf', 'character.gltf', 'out.glb'].map(name => join(folder, name));
write(clips, bones.map(b => b[0]), source, { turns, path });
write(character, ours, target);
execFileSync(sinew, ['retarget', clips, '--onto', character, '-o', out, '--keep-rest']);
const offsets = Object.fromEntries(ours.map((name, j) =>
  [name, new Matrix4().makeRotationFromQuaternion(source[j].world.clone().invert().multiply(target[j].world))]));
const found = written(out), [angle, distance] = differences(by_three(offsets), found), [without] = differences(by_three(undefined), found);
console.log(`with offsets: ${angle.toExponential(1)} rad, hips ${distance.toExponential(1)} m; without: ${without.toFixed(2)} rad`);
if (!(angle < 1e-5 && distance < 1e-5)) process.exit(1);
if (!(without > 0.5)) process.exit(1);
