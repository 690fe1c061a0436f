#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Counts the instructions of our kernels with callgrind, on each target that it knows: those up to AVX2.

    instructions.py --write SINEW_BENCH    counts, and writes instructions.md of this folder
    instructions.py --check SINEW_BENCH    counts, and fails when a case takes over 3 % more than the table says, or is not in it;
                                           exits with 77 where another compiler made the program than counted for the table

Only cases that are generated in code are counted, so that the table is the same with and without a corpus.
"""
import glob
import os
import pathlib
import subprocess
import sys
import tempfile

TABLE = pathlib.Path(__file__).resolve().parent / "instructions.md"
ALLOWED = 1.03
HEAD = """# Instructions

Per joint, vertex or triangle (`frame` and `pose`: per frame), counted by callgrind, which knows no AVX-512.
`./run bench --instructions` writes this file. A test counts again and fails where a count has grown by more than 3 %.

Compiler: """


def run(*command, **more):
    return subprocess.run(command, check=True, capture_output=True, text=True, **more).stdout


def count(program):
    """{case: {target: instructions per item}}, both in the order in which they ran."""
    counts = {}
    with tempfile.TemporaryDirectory() as folder:
        no_corpus = {**os.environ, "SINEW_CORPUS": os.path.join(folder, "none")}
        run("valgrind", "--tool=callgrind", "--instr-atstart=no", f"--callgrind-out-file={folder}/counts", program, "--instructions",
            env=no_corpus)
        for path in sorted(glob.glob(f"{folder}/counts.*"), key=lambda name: int(name.rsplit(".", 1)[1])):
            label = total = None
            for line in open(path, encoding="utf-8", errors="replace"):
                if line.startswith("desc: Trigger: Client Request: "):
                    label = line.split(": ", 3)[3].split()
                if line.startswith(("summary: ", "totals: ")):
                    total = int(line.split()[1])
            if label and total:
                target, case, items = label
                counts.setdefault(case, {})[target] = total / int(items)
    return counts


def targets_of(counts):
    return list(next(iter(counts.values())))


def table(counts, compiler):
    targets = targets_of(counts)
    lines = [HEAD + compiler, "", "| case | " + " | ".join(targets) + " |", "|---|" + "---|" * len(targets)]
    for case, by_target in sorted(counts.items()):
        lines.append(f"| {case} | " + " | ".join(f"{by_target[target]:.2f}" for target in targets) + " |")
    return "\n".join(lines) + "\n"


def read_table():
    """The same counts as they stand in the file, and the compiler."""
    text = TABLE.read_text()
    compiler = text.split("Compiler: ", 1)[1].split("\n", 1)[0]
    rows = [[cell.strip() for cell in line.strip("| ").split("|")] for line in text.splitlines() if line.startswith("|")]
    targets = rows[0][1:]
    return {row[0]: dict(zip(targets, map(float, row[1:]))) for row in rows[2:]}, compiler


def check(program, compiler):
    stored, of_compiler = read_table()
    if compiler != of_compiler:
        print(f"the table is of {of_compiler}, this program of {compiler}: not compared")
        sys.exit(77)
    counts = count(program)
    wrong = [f"{case}: not in the table" for case in counts.keys() - stored.keys()]
    wrong += [f"{case}: in the table, and not counted" for case in stored.keys() - counts.keys()]
    smaller = 0
    for case in counts.keys() & stored.keys():
        for target, now in counts[case].items():
            before = stored[case].get(target)
            if before is None:
                continue
            smaller += now * ALLOWED < before
            if now > ALLOWED * before:
                wrong.append(f"{case}, {target}: {now:.2f} instructions, {100 * (now / before - 1):.1f} % more than {before:.2f}")
    if wrong:
        sys.exit("\n".join(sorted(wrong)) + "\nwhere that is meant, `./run bench --instructions` writes the table anew")
    print(f"{len(counts)} cases on {', '.join(targets_of(counts))}; {smaller} counts are over 3 % smaller than in the table")


def main():
    if len(sys.argv) != 3 or sys.argv[1] not in ("--write", "--check"):
        sys.exit(__doc__)
    program = sys.argv[2]
    compiler = run(program, "--compiler").strip()
    if sys.argv[1] == "--check":
        check(program, compiler)
    else:
        TABLE.write_text(table(count(program), compiler))


if __name__ == "__main__":
    main()
