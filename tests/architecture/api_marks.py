#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""api_marks.py [--write]: SINEW_API stands before what the runtime's public headers declare and its sources define, or shared
libraries do not show it: functions, and classes with such members. Names what is not marked; --write marks it."""
import pathlib, re, sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Headers that are not public, of functions that one library calls in another.
BETWEEN_LIBRARIES = ['runtime/animation/joint_tracks.h', 'runtime/base/checksum.h', 'runtime/paging/join_clips.h',
                     'runtime/plan/refusal.h']

SKIP = re.compile(r'(\[\[nodiscard\]\] )?(template|inline|constexpr|consteval|using|namespace|extern|static|typedef|friend|enum|union|SINEW_API|#|public:|private:|protected:)')

def blank(text):
    """Comments, strings and preprocessor lines as spaces: places stay."""
    out = re.sub(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', lambda m: ' ' * len(m.group()) if '\n' not in m.group() else re.sub(r'[^\n]', ' ', m.group()), text, flags=re.S)
    return re.sub(r'^[ \t]*#(?:[^\n]*\\\n)*[^\n]*', lambda m: re.sub(r'[^\n]', ' ', m.group()), out, flags=re.M)

def statements(text, begin, end):
    """(start, stop, body) of each statement between two places; body is (open, close) where it has braces, else None."""
    at = begin
    while at < end:
        while at < end and text[at] in ' \n\t;': at += 1
        if at >= end: return
        start, depth = at, 0
        while at < end:
            ch = text[at]
            if ch == '(' : depth += 1
            elif ch == ')': depth -= 1
            elif ch == ';' and depth == 0:
                yield start, at, None
                break
            elif ch == ':' and depth == 0 and re.fullmatch(r'\s*(public|private|protected)\s*', text[start:at]):
                start = at + 1
                while start < end and text[start] in ' \n\t': start += 1
            elif ch == '{' and depth == 0:
                close, level = at, 0
                while True:
                    level += (text[close] == '{') - (text[close] == '}')
                    if level == 0: break
                    close += 1
                head = text[start:at]
                if '=' in head.split('(')[0] or re.search(r'\w\s*$', head) and '(' not in head and not re.match(r'(class|struct|enum|union|namespace|template|extern)\b', head):
                    at = close  # an initialiser
                else:
                    yield start, at, (at, close)
                    at = close
                    break
            at += 1
        at += 1

def declares(statement):
    """A function without a body; no pointer to one."""
    head = statement.split('(')[0]
    if '(*' in statement: return False
    if "SINEW_API" in statement or "(" not in statement or SKIP.match(statement) or '=' in head or re.search(r'=\s*(default|delete|0)\s*$', statement): return False
    return '<' not in head.split()[-1] or 'operator<' in head

def has_defined_elsewhere(text, body):
    return any(inner is None and declares(text[a:b]) for a, b, inner in statements(text, body[0] + 1, body[1]))

def places(text, begin, end, found):
    for start, stop, body in statements(text, begin, end):
        head = text[start:stop]
        specialised = re.match(r'template <>\s*', head)
        if body is None:
            past = specialised.end() if specialised else 0
            if declares(head[past:]): found.append(start + past)
        elif re.match(r'(namespace\b|extern\s+)', head): places(text, body[0] + 1, body[1], found)
        else: mark_class(text, start, head, body, found)

def mark_class(text, start, head, body, found):
    name = re.match(r'(class|struct) (?:alignas\([^)]*\) )?(?!SINEW_API)', head)
    if not name: return
    if has_defined_elsewhere(text, body): found.append(start + name.end())
    for a, b, inner in statements(text, body[0] + 1, body[1]):
        if inner: mark_class(text, a, text[a:b], inner, found)

def headers():
    """What public_headers.cmake names, and all of ours that these include."""
    names = re.findall(r'runtime/[\w/]+\.h', (ROOT / 'runtime/public_headers.cmake').read_text())
    for name in names:
        names += [n for n in re.findall(r'#include "(runtime/[^"]+)"', (ROOT / name).read_text()) if n not in names]
    return sorted(set(names + BETWEEN_LIBRARIES))

def marked(source, found):
    for place in sorted(found, reverse=True):
        source = source[:place] + 'SINEW_API ' + source[place:]
    source = re.sub(r'SINEW_API (\[\[\w+\]\]) ', r'\1 SINEW_API ', source)
    if '"runtime/base/api.h"' in source: return source
    lines = source.split('\n')
    ours = [i for i, line in enumerate(lines) if line.startswith('#include "')]
    others = [i for i, line in enumerate(lines) if line.startswith('#include <')]
    at = ours[0] if ours else (others[-1] if others else lines.index('#pragma once')) + 1
    lines[at:at] = ([] if ours or not others else ['']) + ['#include "runtime/base/api.h"']
    return '\n'.join(lines)

missing = 0
for name in headers():
    source = (ROOT / name).read_text()
    found = []
    places(blank(source), 0, len(source), found)
    for place in found:
        print(f'{name}:{source.count(chr(10), 0, place) + 1}: is not marked with SINEW_API')
    if '--write' in sys.argv and found: (ROOT / name).write_text(marked(source, found))
    else: missing += len(found)
sys.exit(missing > 0)
