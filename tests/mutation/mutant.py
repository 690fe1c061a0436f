# SPDX-License-Identifier: MIT
"""One mutant, and how mutants are set into a text."""
import dataclasses
import hashlib


@dataclasses.dataclass
class Mutant:
    file: str
    line: int
    start: int  # bytes [start, end) of the file
    end: int
    kind: str
    function: str
    original: str
    mutated: str  # what stands there when the mutant is set alone
    before: str  # what stands before and after the original text when a number chooses; empty = it cannot be chosen so
    after: str
    shown: str
    key: str = ''

    def __str__(self):
        return f'{self.file}:{self.line}: {self.kind} in {self.function}: {self.original}  ->  {self.shown}'


def give_keys(mutants):
    """A key stays as it is when other functions of the file change: it is made of the function, the code and what is made of it,
    and counted among those that are the same."""
    seen = {}
    for mutant in sorted(mutants, key=lambda m: (m.file, m.start, m.end)):
        text = '\n'.join((mutant.file, mutant.function, mutant.kind, mutant.original, mutant.mutated))
        seen[text] = seen.get(text, 0) + 1
        mutant.key = hashlib.sha256(f'{text}\n{seen[text]}'.encode()).hexdigest()[:12]


def in_sample_order(mutants, seed):
    """Any first part of this order is an even sample of the whole, and edits elsewhere do not change it."""
    return sorted(mutants, key=lambda m: hashlib.sha256(f'{seed} {m.key}'.encode()).digest())


def drawn(files, seed, count):
    """Some files, each as likely as any other."""
    return sorted(sorted(files, key=lambda f: hashlib.sha256(f'{seed} {f}'.encode()).digest())[:count])


def in_clusters(mutants, seed, count, each):
    """Compiling takes longer than running: an even sample from fewer files. `count` places lie evenly along the list of all
    mutants by file, and each brings `each` mutants of its file, so every mutant is as likely as any other and every folder is met."""
    files = {}
    for mutant in sorted(mutants, key=lambda m: m.file):
        files.setdefault(mutant.file, []).append(mutant)
    line = [file for file, some in files.items() for _ in some]
    step = len(line) / count
    start = int(hashlib.sha256(str(seed).encode()).hexdigest(), 16) % 1000 / 1000 * step
    hits = [line[int(start + i * step)] for i in range(count)]
    chosen = [m for file in files for m in in_sample_order(files[file], seed)[:each * hits.count(file)]]
    return in_sample_order(chosen, seed)


def set_switched(text, numbered):
    """All mutants of `numbered` (pairs of number and mutant) at once, each behind its number. Lines stay where they are."""
    events = []
    for number, m in numbered:
        order = (m.kind != 'statement', number)  # a statement is left out from outside its expressions
        events.append((m.start, 1, -m.end, order, m.before.format(n=number)))
        events.append((m.end, 0, -m.start, (-order[0], -order[1]), m.after))
    out, last = [], 0
    for place, _, _, _, inserted in sorted(events):
        out += [text[last:place], inserted.encode()]
        last = place
    return b''.join(out) + text[last:]


def set_alone(text, mutant):
    """One mutant in place of the original. Lines stay where they are."""
    lines = text[mutant.start:mutant.end].count(b'\n')
    mutated = mutant.mutated if mutant.kind == 'statement' else f'({mutant.mutated})'
    return text[:mutant.start] + mutated.encode() + b'\n' * lines + text[mutant.end:]
