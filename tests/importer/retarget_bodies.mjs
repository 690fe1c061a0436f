// SPDX-License-Identifier: MIT
// Bodies of random rest rotations, a clip that moves all of their joints, as glTF files, and what sinew makes of them: for tests of
// `sinew retarget` beside other programs.
import { readFileSync, writeFileSync } from 'node:fs';

export const keys = 13, duration = 1.2;
export const times = Array.from({ length: keys }, (_, k) => k * duration / (keys - 1));

// in  bones  [parent, place of the joint in the world of the source] each
export function bodies({ Quaternion, Vector3 }, bones) {
  let state = 7;
  const random = () => (state = (state * 16807) % 2147483647) / 2147483647 * 2 - 1;
  const rotation = reach => new Quaternion().setFromAxisAngle(new Vector3(random(), random(), random()).normalize(), reach * random());

  /// Rest rotations in the world, and the local transforms that follow from them.
  // in  other  {joint: place} of those that rest elsewhere
  function body(scale, other = {}) {
    const place_of = j => other[j] ?? bones[j][1];
    const world = bones.map(() => rotation(3));
    return bones.map(([parent], j) => {
      const above = parent < 0 ? new Quaternion() : world[parent].clone().invert();
      const from = parent < 0 ? [0, 0, 0] : place_of(parent);
      return { world: world[j], rotation: above.clone().multiply(world[j]),
        place: new Vector3(...place_of(j).map((x, i) => (x - from[i]) * scale)).applyQuaternion(above) };
    });
  }

  /// A clip: rotations of all joints about where they rest, and the path of the first.
  function motion(joints) {
    const turns = joints.map(joint => times.map(() => joint.rotation.clone().multiply(rotation(0.9))));
    return { turns, path: times.map(t => [0.3 * t, 1 + 0.1 * Math.sin(5 * t), t]) };
  }

  // in  moves  a clip, or nothing;   more  of the document
  function write(file, names, joints, moves, more = {}) {
    const json = { asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [0] }], nodes: joints.map((joint, j) => {
      const children = bones.flatMap(([parent], c) => parent === j ? [c] : []);
      return { name: names[j], translation: joint.place.toArray(), rotation: joint.rotation.toArray(), ...(children.length && { children }) };
    }), ...more };
    if (moves) {
      const numbers = [...times, ...moves.path.flat(), ...moves.turns.flat().flatMap(q => q.toArray())];
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
  return { body, motion, write };
}

/// Keys that sinew wrote: {node: {path: [times, values]}}.
export function written(file) {
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
