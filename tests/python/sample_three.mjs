// SPDX-License-Identifier: MIT
// Prints nanoseconds a joint of three.js sampling chain.gltf of a folder at the times of times.json.
//   node sample_three.mjs FOLDER REPEATS
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

const three = await import(join(process.env.SINEW_THREE, 'build/three.module.js'));
const [folder, repeats] = process.argv.slice(2);
const gltf = JSON.parse(readFileSync(join(folder, 'chain.gltf'), 'utf8'));
const at = JSON.parse(readFileSync(join(folder, 'times.json'), 'utf8'));
const bytes = Buffer.from(gltf.buffers[0].uri.split(',')[1], 'base64');
const floats = (accessor) => {
  const { bufferView, count, type } = gltf.accessors[accessor];
  const begin = gltf.bufferViews[bufferView].byteOffset ?? 0;
  return new Float32Array(bytes.buffer.slice(bytes.byteOffset + begin, bytes.byteOffset + begin + count * (type === 'VEC4' ? 16 : 4)));
};

const joints = gltf.nodes.map((node) => Object.assign(new three.Object3D(), { name: node.name.replace(' ', '_') }));
joints.forEach((joint, j) => j && joints[j - 1].add(joint));
const animation = gltf.animations[0];
const tracks = animation.channels.map(({ sampler, target }) => {
  const { input, output } = animation.samplers[sampler];
  return new three.QuaternionKeyframeTrack(`${joints[target.node].name}.quaternion`, floats(input), floats(output));
});
const mixer = new three.AnimationMixer(joints[0]);
const action = mixer.clipAction(new three.AnimationClip('turn', -1, tracks));
action.setLoop(three.LoopOnce);
action.clampWhenFinished = true;
action.play();

const seconds = [];
for (let i = 0; i < Number(repeats); ++i) {
  const begin = process.hrtime.bigint();
  for (const time of at) mixer.setTime(time);
  seconds.push(Number(process.hrtime.bigint() - begin));
}
seconds.sort((a, b) => a - b);
console.log(seconds[seconds.length >> 1] / at.length / joints.length);
