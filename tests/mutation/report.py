# SPDX-License-Identifier: MIT
"""Progress, the lists of known survivors and equivalent mutants, and the table by folder."""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
FELL, STOOD = ('killed',), ('survived', 'unreached')


def note(text):
    clear = '\r\033[K' if sys.stderr.isatty() else ''
    print(clear + text, file=sys.stderr, flush=True)


def progress(text):
    if sys.stderr.isatty():
        print('\r\033[K' + text[:150], end='', file=sys.stderr, flush=True)


def state_of(results, done, count):
    fell = sum(r['verdict'] in FELL for r in results.values())
    stood = sum(r['verdict'] in STOOD for r in results.values())
    return f'{done} of {count}: {fell} killed, {stood} survive, in all'


def listed(path):
    """Keys of a list: the first word of each line that is no comment."""
    if not os.path.exists(path):
        return set()
    with open(path, encoding='utf-8') as file:
        return {line.split()[0] for line in file if line.strip() and not line.startswith('#')}


def listed_files():
    """Files of the known survivors: the second word of each line."""
    with open(f'{HERE}/survivors.txt', encoding='utf-8') as file:
        return {line.split()[1].rstrip(':') for line in file if line.strip() and not line.startswith('#')}


def folder_of(file):
    return '/'.join(os.path.dirname(file).split('/')[:2]) or file


def table(mutants, results, equivalent):
    rows = {}
    for m in mutants:
        if m.key not in results and m.key not in equivalent:
            continue
        for name in (folder_of(m.file), m.file.split('/')[0] + ' (all)', 'all'):
            row = rows.setdefault(name, {'killed': 0, 'survived': 0, 'unreached': 0, 'stillborn': 0, 'equivalent': 0, 'seconds': 0.0})
            if m.key in equivalent:
                row['equivalent'] += 1
            else:
                row[results[m.key]['verdict']] += 1
                row['seconds'] += results[m.key]['seconds']
    lines = ['| folder | mutants | killed | survived | no test runs them | equivalent | score | seconds |', '|---|---|---|---|---|---|---|---|']
    for name, row in sorted(rows.items(), key=lambda item: (item[0] == 'all', item[0])):
        count = row['killed'] + row['survived'] + row['unreached']
        score = f'{100 * row["killed"] / count:.1f} %' if count else ''
        lines.append(f'| {name} | {count} | {row["killed"]} | {row["survived"]} | {row["unreached"]} | {row["equivalent"]} | {score} | {row["seconds"]:.0f} |')
    return '\n'.join(lines)


def finish(mutants, results, equivalent, options):
    stood = [m for m in mutants if results.get(m.key, {}).get('verdict') in STOOD and m.key not in equivalent]
    for m in sorted(stood, key=lambda m: (m.file, m.line)):
        print(f'{results[m.key]["verdict"]}: {m.key} {m}')
    print(table(mutants, results, equivalent))
    known = listed(f'{HERE}/survivors.txt')
    new = [m for m in stood if m.key not in known]
    if options.check and new:
        note(f'{len(new)} survive that survivors.txt does not list')
        return 1
    return 0
