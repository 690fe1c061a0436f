#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the tool on the project's own models, and holds what it writes to hashes that Linux recorded (tool_outputs.txt).

    tool_outputs.py --models FOLDER [--without draco,images,cost] [--record] -- COMMAND...

COMMAND starts `sinew`, under an emulator perhaps. --without names what this build left out, which the tool must say."""
import argparse
import hashlib
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
RECORD = HERE / 'tool_outputs.txt'
MODELS = ['clips-of-all-kinds.gltf', 'hierarchy-matrices-shear-and-mirrors.gltf', 'interpolation-cubicspline.glb', 'morph-cubicspline.glb',
          'random-3.glb', 'skin-eight-influences.glb', 'skin-morphed.glb', 'sparse.glb']
ENVIRONMENT = {**os.environ, 'LC_ALL': 'C.UTF-8', 'SINEW_CACHE': 'none'}  # by the locale wine names files
UNICODE = 'Fußgänger 走.glb'  # no code page of one byte holds it


class Runs:
    def __init__(self, command, folder):
        self.command, self.folder, self.faults, self.hashes = command, folder, [], {}

    def run(self, *words, status=0, text=None):
        """Stdout, after the status was checked and the text searched for in all that was printed."""
        done = subprocess.run([*self.command, *words], cwd=self.folder, env=ENVIRONMENT, capture_output=True, timeout=120)
        messages = done.stderr.decode('utf-8', 'replace')
        if done.returncode != status:
            self.faults.append(f'sinew {" ".join(words)}: status {done.returncode}, not {status}: {messages[:500]}')
        said = done.stdout.decode('utf-8', 'replace') + messages
        if text is not None and text not in said:
            self.faults.append(f'sinew {" ".join(words)}: says {said[:500]!r}, without {text!r}')
        return done.stdout

    def hold(self, name, content):
        self.hashes[name] = hashlib.sha256(content).hexdigest()[:32], content

    def compare(self, recorded):
        for name, (digest, content) in self.hashes.items():
            if recorded.get(name) != digest:
                self.faults.append(f'{name}: {digest}, not {recorded.get(name)}: {content[:1500]!r}')
        for name in recorded.keys() - self.hashes.keys():
            self.faults.append(f'{name}: recorded, but not run')


def poses_and_files(runs, models):
    for model in MODELS:
        shutil.copy(models / 'models' / model, runs.folder)
        runs.hold(f'the file {model}', (runs.folder / model).read_bytes())
        runs.hold(f'sample {model}', runs.run('sample', model))
        runs.hold(f'info --json {model}', runs.run('info', '--json', model))
        runs.hold(f'plan {model}', runs.run('plan', model))
        runs.run('convert', model, 'out.glb')
        runs.hold(f'convert {model}', (runs.folder / 'out.glb').read_bytes())
        runs.run('compile', model, '-o', 'out.sinew')
        runs.run('check', 'out.sinew')
        poses = models / 'poses' / (pathlib.Path(model).stem + '.json')
        if poses.exists():
            shutil.copy(poses, runs.folder / 'poses.json')
            runs.run('verify', model, 'poses.json')
        (runs.folder / 'out.glb').unlink()
    runs.hold('check of all models', runs.run('check', *MODELS))


def broken_files(runs, without):
    files = sorted(HERE.parent.joinpath('importer/broken').glob('*.gltf'))
    # Draco and images belong to what a build may leave out.
    names = [f.name for f in files if b'draco' not in f.read_bytes() and b'"images"' not in f.read_bytes()]
    for name in names:
        shutil.copy(HERE.parent / 'importer/broken' / name, runs.folder)
    runs.hold('check of broken files', runs.run('check', '--json', *names, status=1))
    shutil.copy(HERE.parent / 'importer/broken/draco-count.gltf', runs.folder)
    if 'draco' in without:
        runs.run('info', 'draco-count.gltf', status=1, text='this build of sinew reads no Draco: it was made without the option SINEW_DRACO')
    if 'images' in without:
        (runs.folder / 'photo.gltf').write_text('{"asset": {"version": "2.0"}, "images": [{"uri": "data:image/jpeg;base64,/9j/4AAQSkZJRg=="}]}')
        runs.run('info', 'photo.gltf', text='image/jpeg, which this build of sinew cannot read: it was made without the option SINEW_IMAGE_CODECS')
    if 'cost' in without:
        runs.run('cost', 'sparse.glb', '-o', 'costs', status=3, text='this build of sinew has no `cost`: it was made without the option')


def names_streams_and_places(runs):
    model = 'skin-morphed.glb'
    shutil.copy(runs.folder / model, runs.folder / UNICODE)
    plain = runs.run('sample', model)
    named = runs.run('sample', UNICODE)
    if named.replace(UNICODE.encode(), model.encode()) != plain:
        runs.faults.append(f'a name in Unicode changes the poses: {named[:300]!r}')
    runs.run('sample', UNICODE, '-o', 'Gänge.json')
    if (runs.folder / 'Gänge.json').read_bytes() != named:
        runs.faults.append('the file that is written is not the output')
    runs.run('sample', UNICODE, '-o', 'Gänge.json.gz')
    runs.run('verify', UNICODE, 'Gänge.json.gz')
    runs.run('sample', UNICODE, '-o', 'arrays.npz', '--fps', '10')
    runs.run('sample', UNICODE, '-o', 'arrays.npy', '--fps', '10')
    runs.hold('sample --format npy', (runs.folder / 'arrays.npy').read_bytes())
    runs.run('convert', UNICODE, '走.glb')
    runs.run('convert', UNICODE, '走.glb')  # in place of the first
    runs.run('check', '走.glb')
    runs.run('convert', UNICODE, UNICODE, status=2)
    runs.run('check', 'there is none.glb', status=1)
    (runs.folder / 'many').mkdir()
    shutil.copy(runs.folder / model, runs.folder / 'many/b.glb')
    shutil.copy(runs.folder / UNICODE, runs.folder / 'many')
    many = runs.run('check', '--jobs', '3', 'many')
    if b'2 files: 2 done, 0 failed' not in many:
        runs.faults.append(f'sinew check many: {many!r}')
    left = [p.name for p in runs.folder.rglob('*.tmp')]
    if left:
        runs.faults.append(f'temporary files are left: {left}')
    with open(runs.folder / model, 'rb') as file:
        done = subprocess.run([*runs.command, 'sample', '-'], cwd=runs.folder, env=ENVIRONMENT, stdin=file, capture_output=True, timeout=120)
    if done.stdout.replace(b'"model": "-"', f'"model": "{model}"'.encode()) != plain:
        runs.faults.append(f'the standard input gives other poses: {done.stdout[:300]!r} {done.stderr[:300]!r}')


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--models', type=pathlib.Path, required=True)
    parser.add_argument('--without', default='')
    parser.add_argument('--record', action='store_true')
    parser.add_argument('command', nargs='+')
    given = parser.parse_args()
    os.environ['SINEW_CACHE'] = 'none'
    with tempfile.TemporaryDirectory(prefix='sinew-outputs-') as folder:
        runs = Runs(given.command, pathlib.Path(folder))
        poses_and_files(runs, given.models)
        broken_files(runs, given.without.split(','))
        names_streams_and_places(runs)
    if given.record:
        RECORD.write_text(''.join(f'{digest} {name}\n' for name, (digest, _) in runs.hashes.items()))
    else:
        lines = [line.split(' ', 1) for line in RECORD.read_text().splitlines()]
        runs.compare({name: digest for digest, name in lines})
    for fault in runs.faults:
        print(fault, file=sys.stderr)
    print(f'{len(runs.hashes)} outputs, {len(runs.faults)} faults')
    return 1 if runs.faults else 0


if __name__ == '__main__':
    sys.exit(main())
