# SPDX-License-Identifier: MIT
"""Places of a C++ file where a mutant can be set, found in clang's AST. Only code that runs: bodies of functions, no
declarations, contracts or messages; and numbers that the compiler computes, whose mutants no switch can choose."""
import bisect
import re
import shlex

from clang import cindex
from clang.cindex import CursorKind as K, TypeKind

from mutant import Mutant

# The neighbour only: a comparison that is turned round falls at once.
RELATIONAL = {'<': ['<='], '<=': ['<'], '>': ['>='], '>=': ['>'], '==': ['!='], '!=': ['==']}
LOGICAL = {'&&': ['||'], '||': ['&&']}
ARITHMETIC = {'+': ['-'], '-': ['+'], '*': ['/'], '/': ['*'], '%': ['*'], '&': ['|'], '|': ['&'], '^': ['|']}
COMPOUND = {'+=': ['-='], '-=': ['+='], '*=': ['/='], '/=': ['*='], '|=': ['&='], '&=': ['|='], '=': []}
SHIFT = {'<<': ['>>'], '>>': ['<<']}
# Functions that another of the same shape is easily written for.
SWAPPED_CALLS = {'min': 'max', 'max': 'min', 'floor': 'ceil', 'ceil': 'floor', 'sin': 'cos', 'cos': 'sin', 'Min': 'Max',
                 'Max': 'Min', 'Add': 'Sub', 'Sub': 'Add', 'Mul': 'Add', 'MulAdd': 'NegMulAdd', 'NegMulAdd': 'MulAdd',
                 'Lt': 'Le', 'Le': 'Lt', 'Gt': 'Ge', 'Ge': 'Gt', 'lower_bound': 'upper_bound',
                 'upper_bound': 'lower_bound', 'any_of': 'all_of', 'all_of': 'any_of', 'front': 'back', 'back': 'front'}
COMPONENTS = {'x': 'y', 'y': 'z', 'z': 'x', 'w': 'x'}
# Statements that change no result: what they do is memory, messages or silence.
SILENT_CALLS = {'reserve', 'shrink_to_fit', 'prefetch', 'prefetch_memory', 'Prefetch', 'fprintf', 'fputs', 'fflush',
                'perror', 'printf', 'contract_failed', 'say', 'log', 'warn', 'description', 'footer'}
FUNCTIONS = {K.FUNCTION_DECL, K.CXX_METHOD, K.CONSTRUCTOR, K.DESTRUCTOR, K.FUNCTION_TEMPLATE, K.CONVERSION_FUNCTION}
SKIPPED = {K.STATIC_ASSERT, K.TYPE_ALIAS_DECL, K.TYPEDEF_DECL, K.ENUM_DECL, K.USING_DECLARATION, K.TYPE_REF,
           K.TEMPLATE_REF, K.NAMESPACE_REF, K.CXX_UNARY_EXPR, K.TEMPLATE_TYPE_PARAMETER, K.TEMPLATE_NON_TYPE_PARAMETER,
           K.TEMPLATE_TEMPLATE_PARAMETER, K.STRING_LITERAL, K.CHARACTER_LITERAL}
INTEGERS = {TypeKind.BOOL, TypeKind.UCHAR, TypeKind.USHORT, TypeKind.UINT, TypeKind.ULONG, TypeKind.ULONGLONG,
            TypeKind.SCHAR, TypeKind.CHAR_S, TypeKind.SHORT, TypeKind.INT, TypeKind.LONG, TypeKind.LONGLONG}
NUMBERS = INTEGERS | {TypeKind.FLOAT, TypeKind.DOUBLE, TypeKind.LONGDOUBLE}


def clang_arguments(command):
    """What clang needs of a g++ command."""
    words, kept, skip = shlex.split(command)[1:], [], False
    for index, word in enumerate(words):
        if skip:
            skip = False
        elif word in ('-o', '-include'):
            skip = True
        elif word in ('-isystem', '-I'):
            kept += [word, words[index + 1]]
            skip = True
        elif word.startswith(('-I', '-D', '-std')):
            kept.append(word)
    return kept + ['-w', '-DHWY_COMPILE_ONLY_STATIC', '-x', 'c++']


def number_of(text):
    """The value of a literal, and its suffix."""
    hexadecimal, floating = text.lower().startswith('0x'), 'p' in text.lower()
    digits = text.rstrip('uUlL' if hexadecimal and not floating else 'uUlLfF')
    suffix, digits_only = text[len(digits):], digits.replace("'", '')
    if hexadecimal:
        return (float.fromhex(digits_only) if floating else int(digits_only, 16)), suffix
    return (float(digits_only) if '.' in digits or 'e' in digits.lower() else int(digits_only, 10)), suffix


class Finder:
    """Walks the declarations of one file in a translation unit."""

    def __init__(self, unit, cursors, path, name):
        self.path, self.name, self.mutants, self.function = path, name, [], ''
        self.is_computed_before = False  # inside a `constexpr` variable
        with open(path, encoding='utf-8') as file:
            self.text = file.read().encode()
        whole = unit.get_extent(path, (0, len(self.text)))
        self.tokens = [(t.extent.start.offset, t.extent.end.offset, t.spelling, t.kind) for t in unit.get_tokens(extent=whole)
                       if t.kind != cindex.TokenKind.COMMENT]
        self.starts = [t[0] for t in self.tokens]
        self.macros = [self.range_of(c) for c in cursors if c.kind == K.MACRO_INSTANTIATION]
        for cursor in cursors:
            if cursor.kind != K.MACRO_INSTANTIATION:
                self.declarations(cursor)

    def is_here(self, cursor):
        file = cursor.location.file
        return file is not None and file.name == self.path

    # -- text

    def between(self, start, end):
        return self.tokens[bisect.bisect_left(self.starts, start):bisect.bisect_left(self.starts, end)]

    def flat(self, start, end):
        """The text of a range on one line and without comments."""
        out, last = [], start
        for begin, stop, spelling, _ in self.between(start, end):
            out.append((' ' if begin > last else '') + spelling)
            last = stop
        return ''.join(out).strip()

    def range_of(self, cursor):
        return cursor.extent.start.offset, cursor.extent.end.offset

    def clean(self, start, end):
        """True where no macro is cut and no line is for the preprocessor."""
        if start >= end or b'\n#' in self.text[start:end]:
            return False
        for begin, stop in self.macros:
            if begin <= start < stop or begin < end <= stop:
                return False
        return True

    # -- mutants

    def add(self, start, end, kind, mutated, before=None, after='))', shown=None):
        """`before` and `after` stand around the text as it was written; without them the whole is chosen by `?:`."""
        if not self.clean(start, end):
            return
        if self.is_computed_before:
            before = after = ''
        elif before is None:
            before = '(mutation_is({n}) ? (' + mutated.replace('{', '{{').replace('}', '}}') + ') : ('
        line = self.text.count(b'\n', 0, start) + 1
        self.mutants.append(Mutant(self.name, line, start, end, kind, self.function, self.flat(start, end), mutated,
                                   before, after, shown or mutated))

    def replace_token(self, whole, token, kind, spelling):
        start, end = whole
        mutated = (self.flat(start, token[0]) + ' ' + spelling + ' ' + self.flat(token[1], end)).strip()
        self.add(start, end, kind, mutated)

    # -- the walk

    def declarations(self, cursor):
        if cursor.kind in FUNCTIONS:
            outer, self.function = self.function, cursor.spelling
            for child in cursor.get_children():
                if child.kind == K.COMPOUND_STMT or (cursor.kind == K.CONSTRUCTOR and child.kind.is_expression()):
                    self.visit(child, cursor)
            self.function = outer
        elif cursor.kind == K.VAR_DECL:
            outer, self.function = self.function, cursor.spelling
            self.constant(cursor)
            self.function = outer
        elif cursor.kind in (K.NAMESPACE, K.STRUCT_DECL, K.CLASS_DECL, K.CLASS_TEMPLATE, K.UNEXPOSED_DECL, K.LINKAGE_SPEC,
                             K.CLASS_TEMPLATE_PARTIAL_SPECIALIZATION):
            for child in cursor.get_children():
                if self.is_here(child):
                    self.declarations(child)

    def visit(self, cursor, parent):
        kind = cursor.kind
        if kind in SKIPPED:
            return
        if kind in (K.STRUCT_DECL, K.CLASS_DECL):
            self.declarations(cursor)
            return
        if kind == K.VAR_DECL and (self.is_constant(cursor) or self.is_constant_statement(parent)):
            self.constant(cursor)
            return
        children = list(cursor.get_children())
        if kind == K.CALL_EXPR and cursor.spelling in SILENT_CALLS:
            return
        if kind == K.CASE_STMT:
            children = children[1:]
        if kind == K.IF_STMT and self.between(*self.range_of(cursor))[1:2] and self.between(*self.range_of(cursor))[1][2] == 'constexpr':
            children = children[1:]
        else:
            self.mutate(cursor, parent, children)
        for child in children:
            if kind == K.VAR_DECL and self.is_part_of_type(child, cursor):
                continue
            if kind in (K.COMPOUND_STMT, K.IF_STMT, K.FOR_STMT, K.WHILE_STMT, K.CXX_FOR_RANGE_STMT, K.CASE_STMT, K.DEFAULT_STMT):
                self.drop_statement(child, cursor, children)
            self.visit(child, cursor)

    def constant(self, variable):
        """A number that is `constexpr`. Tables are left out: they have too many numbers beside the code that reads them."""
        if variable.type.get_canonical().kind in NUMBERS and self.is_constexpr(variable):
            self.is_computed_before = True
            for child in variable.get_children():
                self.visit(child, variable)
            self.is_computed_before = False

    def is_constexpr(self, variable):
        at = bisect.bisect_left(self.starts, self.range_of(variable)[0])
        return 'constexpr' in [t[2] for t in self.tokens[at:at + 3]]

    def is_part_of_type(self, child, variable):
        """Arguments of templates and sizes of arrays, which the compiler has to know."""
        start, end = self.range_of(child)
        before = bisect.bisect_left(self.starts, start) - 1
        return end <= variable.location.offset or self.tokens[before][2] == '['

    def is_constant_statement(self, statement):
        words = [t[2] for t in self.between(*self.range_of(statement))][:2]
        return statement.kind == K.DECL_STMT and ('constexpr' in words or 'static' in words)

    def is_constant(self, variable):
        start, end = self.range_of(variable)
        words = [t[2] for t in self.between(start, end)][:4]
        if 'constexpr' in words or 'static' in words:
            return True
        # g++ computes constant integers when it compiles, where no switch can be.
        if variable.type.is_const_qualified() and variable.type.get_canonical().kind in INTEGERS | {TypeKind.ENUM}:
            return not any(c.kind in (K.CALL_EXPR, K.MEMBER_REF_EXPR, K.DECL_REF_EXPR, K.LAMBDA_EXPR) for c in variable.walk_preorder())
        return False

    def mutate(self, cursor, parent, children):
        kind = cursor.kind
        if kind in (K.BINARY_OPERATOR, K.COMPOUND_ASSIGNMENT_OPERATOR) and len(children) == 2:
            self.binary(cursor, children[0], children[1])
        elif kind == K.CALL_EXPR:
            self.call(cursor, children)
        elif kind in (K.IF_STMT, K.WHILE_STMT, K.CONDITIONAL_OPERATOR):
            self.condition(cursor, children)
        elif kind in (K.INTEGER_LITERAL, K.FLOATING_LITERAL, K.CXX_BOOL_LITERAL_EXPR):
            self.literal(cursor, parent)
        elif kind == K.MEMBER_REF_EXPR and cursor.spelling in COMPONENTS and children:
            self.component(cursor)
        elif kind == K.UNARY_OPERATOR and children:
            self.unary(cursor, children[0])
        elif kind == K.ARRAY_SUBSCRIPT_EXPR and len(children) == 2:
            self.subscript(cursor, children)

    def operator_between(self, left, right):
        for token in self.between(self.range_of(left)[1], self.range_of(right)[0]):
            if token[2] not in '()':
                return token
        return None

    def binary(self, cursor, left, right):
        token = self.operator_between(left, right)
        if token is None:
            return
        left_kind, right_kind = left.type.get_canonical().kind, right.type.get_canonical().kind
        known = lambda k: k in NUMBERS or k in (TypeKind.DEPENDENT, TypeKind.UNEXPOSED, TypeKind.INVALID)
        kinds = [('comparison', RELATIONAL), ('logic', LOGICAL)]
        if known(left_kind) and known(right_kind):
            kinds += [('arithmetic', ARITHMETIC), ('arithmetic', COMPOUND), ('arithmetic', SHIFT)]
        whole = self.range_of(cursor)
        for name, table in kinds:
            for other in table.get(token[2], []):
                if other in ('<=', '<', '>', '>=') and left_kind in (TypeKind.BOOL, TypeKind.NULLPTR):
                    continue
                self.replace_token(whole, token, name, other)

    def call(self, cursor, children):
        whole = self.range_of(cursor)
        if cursor.spelling.startswith('operator'):
            self.operator_call(cursor, children, whole)
            return
        arguments = list(cursor.get_arguments())
        written = [a for a in arguments if a is not None and self.is_written(a, whole)]
        name = children[0] if children else None
        if name is not None and cursor.spelling in SWAPPED_CALLS and written == arguments:
            for token in reversed(self.between(*self.range_of(name))):
                if token[2] == cursor.spelling:
                    other = SWAPPED_CALLS[cursor.spelling]
                    mutated = self.flat(whole[0], token[0]) + other + self.flat(token[1], whole[1])
                    self.add(*whole, 'call', mutated)
                    break
        if any(t[2] == '...' for t in self.between(*whole)):
            return
        for first, second in zip(written, written[1:]):
            if first.type.get_canonical().spelling.replace('const ', '') == second.type.get_canonical().spelling.replace('const ', ''):
                a, b = self.range_of(first), self.range_of(second)
                if self.flat(*a) == self.flat(*b) or self.flat(*b).endswith('end()') or cursor.spelling in ('min', 'max', 'Add', 'Mul', 'Min', 'Max', 'And', 'Or', 'dot', 'swap'):
                    continue
                if cursor.spelling == 'clamp' and first is written[0]:
                    continue  # the larger of value and lower end is the same either way
                mutated = (self.flat(whole[0], a[0]) + self.flat(*b) + self.flat(a[1], b[0]) + ' ' + self.flat(*a) + self.flat(b[1], whole[1]))
                self.add(*whole, 'arguments', mutated)

    def is_written(self, argument, whole):
        start, end = self.range_of(argument)
        return whole[0] <= start < end <= whole[1]

    def operator_call(self, cursor, children, whole):
        spelling = cursor.spelling[len('operator'):]
        operands = sorted((c for c in children if self.is_written(c, whole)), key=lambda c: c.extent.start.offset)
        operands = [c for c in operands if self.flat(*self.range_of(c)) != spelling and self.flat(*self.range_of(c)) not in ('[]', '()')]
        if spelling == '[]' and len(operands) >= 2:
            self.offset_index(whole, operands[0], operands[-1])
        if len(operands) != 2:
            return
        token = self.operator_between(*operands)
        if token is None or token[2] != spelling:
            return
        first, second = (o.type.get_canonical().spelling.replace('const ', '') for o in operands)
        if spelling in RELATIONAL:
            self.replace_token(whole, token, 'comparison', RELATIONAL[spelling][0])
        if 'glm::' not in first + second:
            return
        if spelling == '*' and first == second and ('mat<' in first or 'qua<' in first):
            a, b = self.range_of(operands[0]), self.range_of(operands[1])
            self.add(*whole, 'arguments', f'({self.flat(*b)}) * ({self.flat(*a)})')
        elif spelling in ('+', '-', '+=', '-='):
            self.replace_token(whole, token, 'arithmetic', (ARITHMETIC | COMPOUND)[spelling][0])
        elif spelling == '*' and 'vec<' in first and second in ('float', 'double') or spelling == '/':
            self.replace_token(whole, token, 'arithmetic', ARITHMETIC[spelling][0])

    def condition(self, cursor, children):
        expressions = [c for c in children if c.kind.is_expression()]
        if not expressions or any(c.kind == K.VAR_DECL for c in children):
            return
        start, end = self.range_of(expressions[0])
        text = self.flat(start, end)
        if cursor.kind == K.IF_STMT and [t[2] for t in self.between(*self.range_of(cursor))[1:2]] != ['(']:
            return  # of a macro, or with something between
        negated_elsewhere = any(t[2] in ('==', '!=') for t in self.between(start, end)) or text.startswith('!')
        if cursor.kind != K.WHILE_STMT and not negated_elsewhere:
            self.add(start, end, 'condition', f'!({text})', '(mutation_is({n}) != static_cast<bool>(')
        if cursor.kind == K.IF_STMT:
            self.add(start, end, 'condition', f'false && ({text})', '(!mutation_is({n}) && static_cast<bool>(', shown='false')
            self.add(start, end, 'condition', f'true || ({text})', '(mutation_is({n}) || static_cast<bool>(', shown='true')

    def literal(self, cursor, parent):
        start, end = self.range_of(cursor)
        at = bisect.bisect_left(self.starts, start)
        if not 0 < at < len(self.tokens) - 1 or self.tokens[at][0] != start or self.tokens[at][1] != end:
            return
        before, text, after = self.tokens[at - 1][2], self.tokens[at][2], self.tokens[at + 1][2]
        if not (text[0].isdigit() or text in ('true', 'false')) or after in ('>', '>>') or before == '<' and parent.kind != K.BINARY_OPERATOR or '::' in before:
            return
        if parent.kind in (K.DECL_REF_EXPR, K.MEMBER_REF_EXPR, K.OVERLOADED_DECL_REF):
            return  # an argument of a template
        if text in ('true', 'false'):
            mutated = 'false' if text == 'true' else 'true'
        else:
            try:
                value, suffix = number_of(text)
            except ValueError:  # binary
                return
            mutated = f'{value * 2 if value else 1.0!r}{suffix}' if isinstance(value, float) else f'{value + 1}{suffix}'
        self.add(start, end, 'constant', mutated)

    def component(self, cursor):
        start, end = self.range_of(cursor)
        tokens = self.between(start, end)
        if tokens and tokens[-1][2] == cursor.spelling and len(tokens) > 1 and tokens[-2][2] in ('.', '->'):
            self.add(start, end, 'index', self.flat(start, tokens[-1][0]) + COMPONENTS[cursor.spelling])

    def unary(self, cursor, operand):
        start, end = self.range_of(cursor)
        tokens = self.between(start, end)
        if tokens and tokens[0][2] in ('-', '!', '~') and operand.kind not in (K.INTEGER_LITERAL, K.FLOATING_LITERAL):
            text = self.flat(*self.range_of(operand))
            if tokens[0][2] == '!':
                self.add(start, end, 'logic', f'static_cast<bool>({text})')
            else:
                self.add(start, end, 'arithmetic', text)

    def subscript(self, cursor, children):
        self.offset_index(self.range_of(cursor), children[0], children[1])

    def offset_index(self, whole, base, index):
        if index.type.get_canonical().kind not in INTEGERS or index.kind == K.INTEGER_LITERAL:
            return
        start, end = self.range_of(index)
        self.add(start, end, 'index', f'({self.flat(start, end)}) + 1')

    def drop_statement(self, child, parent, siblings):
        kind = child.kind
        if parent.kind in (K.IF_STMT, K.FOR_STMT, K.WHILE_STMT, K.CXX_FOR_RANGE_STMT):
            if child is siblings[0] or parent.kind == K.FOR_STMT and child is not siblings[-1]:
                return
            if parent.kind == K.IF_STMT and [c for c in siblings if c.kind.is_expression()][:1] == [child]:
                return
            if parent.kind == K.CXX_FOR_RANGE_STMT and child is not siblings[-1]:
                return
        if parent.kind == K.CASE_STMT and child is siblings[0]:
            return
        start, end = self.range_of(child)
        text = self.flat(start, end)
        droppable = kind in (K.CALL_EXPR, K.COMPOUND_ASSIGNMENT_OPERATOR, K.BINARY_OPERATOR, K.BREAK_STMT, K.CONTINUE_STMT,
                             K.UNARY_OPERATOR, K.UNEXPOSED_EXPR) or kind == K.RETURN_STMT and text == 'return'
        if not droppable or 'stderr' in text or child.spelling in SILENT_CALLS or text.startswith('progress.'):
            return
        if re.match(r'[\w.\[\]>-]+\.(reserve|shrink_to_fit)\(', text):  # templates hide what is called
            return
        tokens = self.between(start, end)
        if not tokens or tokens[-1][2].startswith('"') and ' ' in tokens[-1][2]:
            return  # of a macro; words for people
        if kind == K.RETURN_STMT and parent.kind == K.COMPOUND_STMT:
            return
        self.add(start, end, 'statement', ';', 'if (mutation_is({n})) {{}} else ', '', shown='(nothing)')


def places(path, names, command, root):
    """Mutants of files `names` (relative to `root`) as the translation unit `path` shows them."""
    index = cindex.Index.create()
    unit = index.parse(path, args=clang_arguments(command), options=cindex.TranslationUnit.PARSE_DETAILED_PROCESSING_RECORD)
    fatal = [d for d in unit.diagnostics if d.severity >= cindex.Diagnostic.Error]
    by_file = {f'{root}/{name}': [] for name in names}
    for cursor in unit.cursor.get_children():
        file = cursor.location.file
        if file is not None and file.name in by_file:
            by_file[file.name].append(cursor)
    found = {name: Finder(unit, by_file[f'{root}/{name}'], f'{root}/{name}', name).mutants for name in names}
    return found, [str(d) for d in fatal[:3]]
