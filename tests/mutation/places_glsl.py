# SPDX-License-Identifier: MIT
"""Places of a shader where a mutant can be set. clang does not read GLSL: tokens and brackets show where functions are."""
import bisect
import re

from mutant import Mutant

TOKEN = re.compile(rb'//[^\n]*|/\*.*?\*/|^[ \t]*#[^\n]*|[A-Za-z_]\w*|\d+\.?\d*(?:[eE][-+]?\d+)?[uf]?|\.\d+|'
                   rb'<<=|>>=|[-+*/%&|^<>=!]=|&&|\|\||<<|>>|\+\+|--|[^\s]', re.S | re.M)
RELATIONAL = {'<': '<=', '<=': '<', '>': '>=', '>=': '>', '==': '!=', '!=': '==', '&&': '||', '||': '&&'}
ARITHMETIC = {'+': '-', '-': '+', '*': '/', '/': '*', '+=': '-=', '-=': '+=', '*=': '/='}
CALLS = {'min': 'max', 'max': 'min', 'floor': 'ceil', 'sin': 'cos', 'cos': 'sin', 'transpose': 'inverse'}
COMPONENTS = {'x': 'y', 'y': 'z', 'z': 'y', 'w': 'x', 'r': 'g', 'g': 'b', 'b': 'g', 'a': 'r', 'xy': 'yx', 'rg': 'gr'}
SYMMETRIC = {'min', 'max', 'dot', 'distance', 'vec2', 'ivec2'}


class Finder:
    def __init__(self, text, name):
        self.text, self.name, self.mutants, self.function = text, name, [], ''
        self.tokens = [(m.start(), m.end(), m.group().decode()) for m in TOKEN.finditer(text)
                       if not m.group().startswith((b'//', b'/*')) and not m.group().lstrip().startswith(b'#')]
        self.starts = [t[0] for t in self.tokens]
        self.partner = self.brackets()
        self.functions()

    def brackets(self):
        partner, stack = {}, []
        for i, (_, _, spelling) in enumerate(self.tokens):
            if spelling in '([{':
                stack.append(i)
            elif spelling in ')]}' and stack:
                partner[stack.pop()] = i
        return partner

    def functions(self):
        i = 0
        while i < len(self.tokens):
            spelling = self.tokens[i][2]
            if spelling == '(' and self.partner.get(i, 0) + 1 < len(self.tokens) and self.tokens[self.partner[i] + 1][2] == '{':
                self.function = self.tokens[i - 1][2]
                body = self.partner[i] + 1
                self.body(body + 1, self.partner[body])
                i = self.partner[body]
            elif spelling in '({':
                i = self.partner.get(i, i)
            i += 1

    def flat(self, first, last):
        """Tokens first..last-1 on one line."""
        out, end = [], self.tokens[first][0] if first < last else 0
        for begin, stop, spelling in self.tokens[first:last]:
            out.append((' ' if begin > end else '') + spelling)
            end = stop
        return ''.join(out)

    def add(self, first, last, kind, mutated, context=None):
        start, end = self.tokens[first][0], self.tokens[last - 1][1]
        if b'\n#' in self.text[start:end]:
            return
        a, b = context or (first, last)
        shown = (self.flat(a, first) + ' ' + mutated + ' ' + self.flat(last, b)).strip()
        self.mutants.append(Mutant(self.name, self.text.count(b'\n', 0, start) + 1, start, end, kind, self.function,
                                   self.flat(a, b), mutated, '', '', shown))

    def body(self, first, last):
        statement = first
        for i in range(first, last):
            before, spelling, after = self.tokens[i - 1][2], self.tokens[i][2], self.tokens[i + 1][2]
            if spelling in '{};' or before == ')' and self.is_condition(i - 1):
                if spelling == ';':
                    self.statement(statement, i)
                statement = i if before == ')' and spelling not in '{};' else i + 1
            here = (max(first, i - 4), min(last, i + 5))
            binary = before not in '(,=<>?:+-*/%{;' and before not in ('return', '&&', '||', '==', '!=', '<=', '>=', '+=', '-=', '*=')
            if spelling in RELATIONAL:
                self.add(i, i + 1, 'comparison', RELATIONAL[spelling], here)
            elif spelling in ARITHMETIC and binary:
                self.add(i, i + 1, 'arithmetic', ARITHMETIC[spelling], here)
            elif spelling in CALLS and after == '(':
                self.add(i, i + 1, 'call', CALLS[spelling], here)
            elif re.fullmatch(r'\d+\.?\d*(?:[eE][-+]?\d+)?[uf]?|\.\d+', spelling) and before != 'case':
                self.constant(i, spelling, here)
            elif before == '.' and spelling in COMPONENTS and after not in '=(':
                self.add(i, i + 1, 'index', COMPONENTS[spelling], here)
            elif spelling == '(' and before in ('if', 'while'):
                self.add(i + 1, self.partner[i], 'condition', f'!({self.flat(i + 1, self.partner[i])})')
            elif spelling == '?':
                self.add(i, i + 1, 'condition', '!= true ?' if before == ')' else '== false ?', here)
            if spelling == '(' and re.match(r'[a-z]\w*$', before) and before not in SYMMETRIC | {'if', 'for', 'while', 'return'}:
                self.arguments(i)

    def is_condition(self, close):
        return any(end == close and self.tokens[open_ - 1][2] in ('if', 'for', 'while') for open_, end in self.partner.items())

    def statement(self, first, last):
        words = [t[2] for t in self.tokens[first:last]]
        if not words or words[0] in ('for', 'return', 'const', 'if', 'else', 'discard') or not re.match(r'[A-Za-z_]', words[0]):
            return
        if len(words) > 1 and (words[1] in ('=', '.', '[', '+=', '-=', '*=', '(') and '++' not in words):
            self.add(first, last, 'statement', '')

    def constant(self, i, spelling, here):
        if spelling.rstrip('u').isdigit():
            mutated = str(int(spelling.rstrip('u')) + 1) + ('u' if spelling.endswith('u') else '')
        else:
            value = float(spelling.rstrip('f'))
            mutated = repr(value * 2 if value else 1.0)
        self.add(i, i + 1, 'constant', mutated, here)

    def arguments(self, open_):
        close, parts, start, depth = self.partner[open_], [], open_ + 1, 0
        for i in range(open_ + 1, close):
            depth += (self.tokens[i][2] in '([') - (self.tokens[i][2] in ')]')
            if self.tokens[i][2] == ',' and depth == 0:
                parts.append((start, i))
                start = i + 1
        parts.append((start, close))
        for (a, b), (c, d) in zip(parts, parts[1:]):
            if a < b and c < d and self.flat(a, b) != self.flat(c, d):
                self.add(a, d, 'arguments', f'{self.flat(c, d)}, {self.flat(a, b)}', (open_ - 1, close + 1))


def places(path, name):
    with open(path, 'rb') as file:
        return Finder(file.read(), name).mutants
