#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Samples the project's own models, and every model of the corpus where there is one, with the sinew program and compares with the
reference poses, by the compare_poses.py of each. Models that need an unsupported extension are named and skipped.

usage: compare_with_corpus.py SINEW GENERATED CORPUS SCRATCH     (the environment variable SINEW_CORPUS wins over CORPUS)
Exit status: 0 all within tolerance, 1 something is not.
"""
import gzip, json, os, pathlib, subprocess, sys

REFUSED_BY_NAME = 'extension-required'   # the rule that sinew names on stderr


def reference_of(poses, stem):
    for ending in ('.json', '.json.gz'):
        if (poses / (stem + ending)).exists():
            return poses / (stem + ending)
    return None


def load(path):
    with (gzip.open if path.suffix == '.gz' else open)(path, 'rt', encoding='utf-8') as file:
        return json.load(file)


def kinds_in(reference):
    """Vertex arrays that the reference has and a candidate must have as well."""
    wanted = ('normals', 'dqs', 'dqsNormals', 'tangents')
    found = {kind for clip in reference['clips'] for sample in clip['samples'] for p in sample['skinned'] for kind in p}
    return [kind for kind in wanted if kind in found]


def sample(sinew, model, reference, scratch):
    """One run per clip, at the reference's times; answers the merged candidate, or the message of a refusal."""
    merged = None
    for clip in reference['clips']:
        times = ','.join(repr(s['time']) for s in clip['samples'])
        out = scratch / 'clip.json'
        name = 'none' if clip['clip'] is None else str(clip['clip'])
        run = subprocess.run([sinew, 'sample', str(model), '--clip', name, '--times=' + times, '--vertices', 'all', '-o', str(out)],
                             capture_output=True, text=True, timeout=300)
        if run.returncode != 0:
            return None, '%d: %s' % (run.returncode, run.stderr.strip())
        part = load(out)
        if merged is None:
            merged = part
        else:
            merged['clips'] += part['clips']
    return merged, ''


def compare(sinew, models, poses, comparer, scratch):
    """Counts of models: within tolerance, skipped, failed."""
    failed = skipped = passed = 0
    for model in sorted(p for p in models.rglob('*') if p.suffix in ('.gltf', '.glb')):
        reference_file = reference_of(poses, model.stem)
        if reference_file is None:
            continue
        reference = load(reference_file)
        candidate, message = sample(sinew, model, reference, scratch)
        if candidate is None and REFUSED_BY_NAME in message:
            print('%s\n  skipped: %s' % (model.stem, message))
            skipped += 1
            continue
        if candidate is None:
            print('%s\n  FAIL: %s' % (model.stem, message))
            failed += 1
            continue
        candidate_file = scratch / (model.stem + '.json')
        candidate_file.write_text(json.dumps(candidate))
        command = [sys.executable, str(comparer), '--require', ','.join(kinds_in(reference)), str(reference_file), str(candidate_file)]
        result = subprocess.run(command, capture_output=True, text=True)
        if result.returncode == 0:
            passed += 1
        else:
            print('%s\n%s%s' % (model.stem, result.stdout, result.stderr), end='')
            failed += 1
    return passed, skipped, failed


def main():
    sinew, generated, scratch = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[4])
    corpus = pathlib.Path(os.environ.get('SINEW_CORPUS') or sys.argv[3])
    own_comparer = pathlib.Path(__file__).parent.parent / 'generated' / 'compare_poses.py'
    scratch.mkdir(parents=True, exist_ok=True)
    good = True
    for folder, comparer in ((generated, own_comparer), (corpus, corpus / 'poses' / 'compare_poses.py')):
        if folder is corpus and not ((corpus / 'models').is_dir() and comparer.exists()):
            continue
        passed, skipped, failed = compare(sinew, folder / 'models', folder / 'poses', comparer, scratch)
        print('%s: %d models within tolerance, %d skipped, %d failed' % (folder, passed, skipped, failed))
        good = good and passed > 0 and failed == 0
    return 0 if good else 1


if __name__ == '__main__':
    sys.exit(main())
