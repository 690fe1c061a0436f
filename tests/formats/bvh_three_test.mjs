// SPDX-License-Identifier: MIT
// `sinew import` beside BVHLoader of three.js: bvh_three_test.mjs SINEW FOLDER
//
// three.js adds position channels to OFFSET, so the import does so too. Its loader leaves out joints' names for end sites
// ("ENDSITE") and takes the order of joints from the file, as the import does: joints are compared by their order.
import { execFileSync } from 'node:child_process';
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const [sinew, folder] = process.argv.slice(2);
const three = process.env.SINEW_THREE ?? join(process.env.NODE_PATH ?? 'node_modules', 'three');
const load = file => import(pathToFileURL(join(three, file)).href);
let THREE, BVHLoader;
try {
  THREE = await load('build/three.module.js');
  ({ BVHLoader } = await load('examples/jsm/loaders/BVHLoader.js'));
} catch {
  console.log('no three.js: install the npm package three and name its folder in SINEW_THREE');
  process.exit(77);
}

let state = 12345;
const random = (low, high) => low + (high - low) * ((state = (state * 1103515245 + 12345) % 2147483648) / 2147483648);
const fixed = value => value.toFixed(4);
let channels = 0, joints = 0;
function joint(keyword, depth) {
  const names = ['Xrotation', 'Yrotation', 'Zrotation'].map(n => [random(0, 1), n]).sort().map(([, n]) => n);
  const own = depth % 2 ? names : ['Xposition', 'Yposition', 'Zposition', ...names];
  channels += own.length;
  ++joints;
  const offset = [0, 1, 2].map(() => fixed(random(-20, 20))).join(' ');
  const below = depth < 4 ? joint('JOINT', depth + 1) + (depth % 2 ? joint('JOINT', depth + 2) : '')
                          : (++joints, 'End Site\n{\nOFFSET 0 -5 1\n}\n');
  return `${keyword} joint${joints}_${depth}\n{\nOFFSET ${offset}\nCHANNELS ${own.length} ${own.join(' ')}\n${below}}\n`;
}
const frames = 9, step = 0.04;
let text = 'HIERARCHY\n' + joint('ROOT', 0);
text += `MOTION\nFrames: ${frames}\nFrame Time: ${step}\n`;
for (let f = 0; f < frames; ++f) text += Array.from({ length: channels }, () => fixed(random(-170, 170))).join(' ') + '\n';

mkdirSync(folder, { recursive: true });
const bvh = join(folder, 'random.bvh'), glb = join(folder, 'random.glb'), poses = join(folder, 'random.json');
writeFileSync(bvh, text);
execFileSync(sinew, ['import', bvh, glb, '--unit', 'm', '--positions', 'add'], { stdio: 'pipe' });
execFileSync(sinew, ['sample', glb, '--clip', '0', '--fps', String(1 / step), '-o', poses], { stdio: 'pipe' });
const { readFileSync } = await import('node:fs');
const samples = JSON.parse(readFileSync(poses)).clips.find(c => c.index === 0).samples;

const { skeleton, clip } = new BVHLoader().parse(text);
const mixer = new THREE.AnimationMixer(skeleton.bones[0]);
mixer.clipAction(clip).play();
let worst = 0, size = 0;
for (const sample of samples) {
  const frame = Math.round(sample.time / step);
  if (Math.abs(sample.time - frame * step) > 1e-6 || frame === frames - 1) continue;  // its loop begins anew at the last
  mixer.setTime(frame * step);
  skeleton.bones[0].updateMatrixWorld(true);
  sample.nodes.sort((a, b) => a.node - b.node).forEach(({ world }, j) => {
    const theirs = new THREE.Vector3().setFromMatrixPosition(skeleton.bones[j].matrixWorld);
    size = Math.max(size, theirs.length());
    worst = Math.max(worst, theirs.distanceTo(new THREE.Vector3(world[12], world[13], world[14])));
  });
}
console.log(`${joints} joints, ${samples.length} samples: at most ${worst} of ${size} apart`);
if (joints !== skeleton.bones.length || samples.length < frames || !(worst <= 1e-5 * size)) process.exit(1);
