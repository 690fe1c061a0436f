// SPDX-License-Identifier: MIT
// `sinew retarget` beside SkeletonUtils.retargetClip of three.js: retarget_three_test.mjs SINEW FOLDER
//
// three.js gives each bone the rotation that the other one has in the world. That is right where both rest with the same
// axes. With other axes it needs an offset for each bone, from the rest poses: then it is the same equation as
// `--keep-rest`, and both have to agree. Without offsets it is wrong, and the last check says by how much.
// Its frames lie duration / (n - 1) apart for n frames of 1 / fps, so clips are compared at the times that it writes.
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

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
const lowered = { 'mixamorig:LeftForeArm': [0.4, 1.15, 0], 'mixamorig:LeftHand': [0.6, 0.9, 0] };  // the target rests with its arm down
const size = 1.5;  // of the target, in all lengths: the ratio of heights
const keys = 13, duration = 1.2;

let state = 7;
const random = () => (state = (state * 16807) % 2147483647) / 2147483647 * 2 - 1;
const rotation = reach => new Quaternion().setFromAxisAngle(new Vector3(random(), random(), random()).normalize(), reach * random());

/// Rest rotations in the world, and the local transforms that follow from them.
function body(scale, other = {}) {
  const place_of = j => other[bones[j][0]] ?? bones[j][3];
  const world = bones.map(() => rotation(3));
  return bones.map(([, , parent], j) => {
    const above = parent < 0 ? new Quaternion() : world[parent].clone().invert();
    const from = parent < 0 ? [0, 0, 0] : place_of(parent);
    return { world: world[j], rotation: above.clone().multiply(world[j]),
      place: new Vector3(...place_of(j).map((x, i) => (x - from[i]) * scale)).applyQuaternion(above) };
  });
}

const source = body(1), target = body(size, lowered);
const times = Array.from({ length: keys }, (_, k) => k * duration / (keys - 1));
const turns = source.map(joint => times.map(() => joint.rotation.clone().multiply(rotation(0.9))));
const path = times.map(t => [0.3 * t, 1 + 0.1 * Math.sin(5 * t), t]);

function write(file, names, joints, moves) {
  const numbers = moves ? [...times, ...path.flat(), ...turns.flat().flatMap(q => q.toArray())] : [];
  const json = { asset: { version: '2.0' }, scenes: [{ nodes: [0] }], nodes: joints.map((joint, j) => {
    const children = bones.flatMap(([, , parent], c) => parent === j ? [c] : []);
    return { name: names[j], translation: joint.place.toArray(), rotation: joint.rotation.toArray(), ...(children.length && { children }) };
  }) };
  if (moves) {
    const accessor = (first, count, type, more) => ({ bufferView: 0, byteOffset: 4 * first, componentType: 5126, count, type, ...more });
    json.buffers = [{ byteLength: 4 * numbers.length, uri: 'data:application/octet-stream;base64,' + Buffer.from(new Float32Array(numbers).buffer).toString('base64') }];
    json.bufferViews = [{ buffer: 0, byteLength: 4 * numbers.length }];
    json.accessors = [accessor(0, keys, 'SCALAR', { min: [0], max: [Math.fround(duration)] }), accessor(keys, keys, 'VEC3'),
      ...bones.map((_, j) => accessor(4 * keys + 4 * keys * j, keys, 'VEC4'))];
    json.animations = [{ samplers: json.accessors.slice(1).map((_, i) => ({ input: 0, output: i + 1 })),
      channels: [{ sampler: 0, target: { node: 0, path: 'translation' } }, ...bones.map((_, j) => ({ sampler: j + 1, target: { node: j, path: 'rotation' } }))] }];
  }
  writeFileSync(file, JSON.stringify(json));
}

/// Keys that sinew wrote: {node: {path: [times, values]}}.
function written(file) {
  const glb = readFileSync(file), length = glb.readUInt32LE(12), json = JSON.parse(glb.subarray(20, 20 + length));
  const floats = index => {
    const accessor = json.accessors[index], view = json.bufferViews[accessor.bufferView];
    const begin = 28 + length + (view.byteOffset ?? 0) + (accessor.byteOffset ?? 0);
    const count = accessor.count * { SCALAR: 1, VEC3: 3, VEC4: 4 }[accessor.type];
    return Array.from({ length: count }, (_, i) => glb.readFloatLE(begin + 4 * i));
  };
  const found = {};
  for (const { sampler, target: { node, path: what } } of json.animations[0].channels) {
    const { input, output } = json.animations[0].samplers[sampler];
    (found[json.nodes[node].name] ??= {})[what] = [floats(input), floats(output)];
  }
  return found;
}

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
write(clips, bones.map(b => b[0]), source, true);
write(character, ours, target, false);
execFileSync(sinew, ['retarget', clips, '--onto', character, '-o', out, '--keep-rest']);
const offsets = Object.fromEntries(ours.map((name, j) =>
  [name, new Matrix4().makeRotationFromQuaternion(source[j].world.clone().invert().multiply(target[j].world))]));
const found = written(out), [angle, distance] = differences(by_three(offsets), found), [without] = differences(by_three(undefined), found);
console.log(`with offsets: ${angle.toExponential(1)} rad, hips ${distance.toExponential(1)} m; without: ${without.toFixed(2)} rad`);
if (!(angle < 1e-5 && distance < 1e-5)) process.exit(1);
if (!(without > 0.5)) process.exit(1);
