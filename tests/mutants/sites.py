# SPDX-License-Identifier: GPL-3.0-or-later
"""Places of C++ sources where a mutant can be inserted, found by libclang.

The operators are the functions below `find_sites`. Each returns texts: the original expression `{0}`
and a replacement. No place is chosen in a constant expression (constexpr, case, template argument,
array bound, static_assert), in an expansion of a macro, or in a header.

| operator    | change |
| ----------- | ------ |
| comparison  | `<` to `<=` or `>=`, and likewise `<=`, `>`, `>=`; `==` to `!=` and back |
| arithmetic  | `+` to `-`, `*` to `/`, and back; `%` to `*`; sums and differences of vectors, too |
| logical     | `&&` to `||` and back |
| sign        | `-x` to `x`, `!x` to `x` |
| number      | an integer plus one, minus one, or times ten; a float plus one or times ten |
| constant    | a named constexpr number of ncsim, where used: times ten; true to false and back |
| condition   | negated in `if`, `while`, `?:`, and `return` of a bool |
| accumulate  | `+=` to `-=`, `*=` to `/=`, and back |
| removal     | a statement `x = ...`, `x += ...`, or a call of a void function, removed |

`reserve` is never removed: it changes no value.
"""
import dataclasses
import os
import re

from clang.cindex import Cursor, CursorKind, Index, TranslationUnit, TypeKind

COMPARISONS = {'<': ('<=', '>='), '<=': ('<', '>'), '>': ('>=', '<='), '>=': ('>', '<'),
               '==': ('!=',), '!=': ('==',)}
ARITHMETIC = {'+': '-', '-': '+', '*': '/', '/': '*', '%': '*'}
LOGICAL = {'&&': '||', '||': '&&'}
COMPOUND = {'+=': '-=', '-=': '+=', '*=': '/=', '/=': '*='}

FLOATS = {TypeKind.FLOAT, TypeKind.DOUBLE, TypeKind.LONGDOUBLE}
INTEGERS = {TypeKind.SHORT, TypeKind.USHORT, TypeKind.INT, TypeKind.UINT, TypeKind.LONG,
            TypeKind.ULONG, TypeKind.LONGLONG, TypeKind.ULONGLONG, TypeKind.SCHAR, TypeKind.UCHAR,
            TypeKind.CHAR_S, TypeKind.INT128, TypeKind.UINT128}
NUMBERS = FLOATS | INTEGERS
SCOPES = {CursorKind.NAMESPACE, CursorKind.CLASS_DECL, CursorKind.STRUCT_DECL,
          CursorKind.LINKAGE_SPEC, CursorKind.UNEXPOSED_DECL}
FUNCTIONS = {CursorKind.FUNCTION_DECL, CursorKind.CXX_METHOD, CursorKind.CONSTRUCTOR,
             CursorKind.DESTRUCTOR, CursorKind.CONVERSION_FUNCTION}
VARIABLES = {CursorKind.VAR_DECL, CursorKind.FIELD_DECL}
BODIES = {CursorKind.COMPOUND_STMT, CursorKind.IF_STMT, CursorKind.FOR_STMT,
          CursorKind.WHILE_STMT, CursorKind.CXX_FOR_RANGE_STMT, CursorKind.CASE_STMT,
          CursorKind.DEFAULT_STMT}


@dataclasses.dataclass(frozen=True, order=True)
class Site:
    """An expression of a source, and what replaces it.

    `changes` are pairs: what a reader sees, and C++ text with `MUTANT` for the choice at run time
    and `{begin:end}` for bytes of the source.
    """
    file: str
    begin: int
    end: int
    operator: str
    line: int
    column: int
    changes: tuple


def span(begin, end):
    """Text that stands for the bytes `begin` to `end` of the source, mutants within included."""
    return '{%d:%d}' % (begin, end)


def either(changed, original):
    return f'(MUTANT ? ({changed}) : ({original}))'


class Finder:
    """Collects the sites of one source of a translation unit."""

    def __init__(self, path, name, macros):
        with open(path, 'rb') as source:
            self.bytes = source.read()
        self.path = path
        self.name = name
        self.macros = macros
        self.sites = []

    # --- Text ---

    def text(self, begin, end):
        return self.bytes[begin:end].decode()

    def extent(self, cursor):
        return cursor.extent.start.offset, cursor.extent.end.offset

    def whole(self, cursor):
        return span(*self.extent(cursor))

    def add(self, cursor, operator, changes):
        begin, end = self.extent(cursor)
        if not changes or end <= begin or self.in_macro(begin, end):
            return
        start = cursor.extent.start
        self.sites.append(Site(self.name, begin, end, operator, start.line, start.column,
                               tuple(changes)))

    def in_macro(self, begin, end):
        return any(first < end and begin < last for first, last in self.macros)

    # --- Walk ---

    def visit(self, cursor, parents):
        kind = cursor.kind
        if self.is_constant(cursor):
            return
        if kind.is_expression() and self.is_here(cursor):
            self.expression(cursor, parents)
        if self.is_here(cursor):
            self.conditions(cursor)
        for child in self.children(cursor):
            if child.kind.is_statement() or child.kind.is_expression():
                if kind in BODIES and not self.is_head(cursor, child):
                    self.removal(child)
            self.visit(child, parents + [cursor])

    def is_here(self, cursor):
        file = cursor.location.file
        return file is not None and file.name == self.path

    def is_constant(self, cursor):
        """True if no part of `cursor` is evaluated at run time, or if its types are unknown."""
        kind = cursor.kind
        if kind in (CursorKind.STATIC_ASSERT, CursorKind.ENUM_DECL, CursorKind.FUNCTION_TEMPLATE,
                    CursorKind.CLASS_TEMPLATE, CursorKind.TYPE_REF, CursorKind.TEMPLATE_REF,
                    CursorKind.TYPEDEF_DECL, CursorKind.TYPE_ALIAS_DECL,
                    CursorKind.CLASS_TEMPLATE_PARTIAL_SPECIALIZATION):
            return True
        if kind in FUNCTIONS or kind in VARIABLES:
            return is_constexpr(cursor)
        if kind == CursorKind.IF_STMT:
            begin, _ = self.extent(cursor)
            return self.bytes[begin:begin + 14].startswith(b'if constexpr')
        return False

    def children(self, cursor):
        """Children that are evaluated at run time."""
        kind = cursor.kind
        children = list(cursor.get_children())
        if kind == CursorKind.CASE_STMT:
            return children[1:]
        if kind == CursorKind.DECL_REF_EXPR:
            return []
        if kind in VARIABLES or kind == CursorKind.PARM_DECL:
            name = cursor.location.offset
            return [child for child in children if child.extent.start.offset > name and
                    self.bytes[:child.extent.start.offset].rstrip()[-1:] != b'[']
        if kind in FUNCTIONS:
            return [child for child in children if child.kind != CursorKind.PARM_DECL and
                    child.extent.start.offset > cursor.location.offset]
        return children

    def is_head(self, statement, child):
        """True for the condition, the initialisation or the step of `statement`."""
        if statement.kind == CursorKind.COMPOUND_STMT:
            return False
        body = [c for c in statement.get_children() if self.is_body(statement, c)]
        return child not in body

    def is_body(self, statement, child):
        children = list(statement.get_children())
        if statement.kind == CursorKind.IF_STMT:
            begin, end = self.extent(statement)
            depth = 0
            for at in range(begin, end):
                depth += {40: 1, 41: -1}.get(self.bytes[at], 0)
                if depth == 0 and self.bytes[at] == 41:
                    return child.extent.start.offset > at
            return False
        return child == children[-1]

    # --- Operators ---

    def expression(self, cursor, parents):
        kind = cursor.kind
        if kind == CursorKind.BINARY_OPERATOR:
            self.binary(cursor)
        elif kind == CursorKind.COMPOUND_ASSIGNMENT_OPERATOR:
            self.compound(cursor)
        elif kind == CursorKind.CALL_EXPR:
            self.overloaded(cursor)
        elif kind == CursorKind.UNARY_OPERATOR:
            self.sign(cursor)
        elif kind in (CursorKind.INTEGER_LITERAL, CursorKind.FLOATING_LITERAL):
            self.number(cursor, parents)
        elif kind == CursorKind.CXX_BOOL_LITERAL_EXPR:
            original = self.text(*self.extent(cursor))
            changed = 'false' if original == 'true' else 'true'
            self.add(cursor, 'constant', [(changed, either(changed, original))])
        elif kind == CursorKind.DECL_REF_EXPR:
            self.named(cursor)

    def operands(self, cursor):
        """The operands of an infix operator as spans, and the operator; None if it is not infix."""
        children = [child for child in cursor.get_children()
                    if not child.spelling.startswith('operator') or child.kind.is_reference()]
        if len(children) != 2:
            return None
        (first, middle), (right, last) = map(self.extent, children)
        if not first < middle <= right < last or (first, last) != self.extent(cursor):
            return None
        between = re.sub(r'//[^\n]*|/\*.*?\*/', '', self.text(middle, right), flags=re.DOTALL)
        return span(first, middle), between.strip(), span(right, last)

    def binary(self, cursor):
        found = self.operands(cursor)
        if not found:
            return
        left, symbol, right = found
        original = f'{left} {symbol} {right}'
        if symbol in COMPARISONS:
            self.add(cursor, 'comparison', [(f'{symbol} to {other}', either(
                f'{left} {other} {right}', original)) for other in COMPARISONS[symbol]])
        elif symbol in LOGICAL:
            other = LOGICAL[symbol]
            self.add(cursor, 'logical', [(f'{symbol} to {other}', either(
                f'({left}) {other} ({right})', original))])
        elif symbol in ARITHMETIC and cursor.type.get_canonical().kind in NUMBERS:
            self.arithmetic(cursor, left, symbol, right)

    def arithmetic(self, cursor, left, symbol, right):
        other = ARITHMETIC[symbol]
        self.add(cursor, 'arithmetic', [(f'{symbol} to {other}', either(
            f'({left}) {other} ({right})', f'{left} {symbol} {right}'))])

    def compound(self, cursor):
        found = self.operands(cursor)
        if found and found[1] in COMPOUND and cursor.type.get_canonical().kind in NUMBERS:
            left, symbol, right = found
            other = COMPOUND[symbol]
            self.add(cursor, 'accumulate', [(f'{symbol} to {other}', either(
                f'{left} {other} {right}', f'{left} {symbol} {right}'))])

    def overloaded(self, cursor):
        if not cursor.spelling.startswith('operator'):
            return
        found = self.operands(cursor)
        if not found:
            return
        left, symbol, right = found
        if symbol in ('==', '!='):
            other = COMPARISONS[symbol][0]
            self.add(cursor, 'comparison', [(f'{symbol} to {other}',
                                             f'(MUTANT != ({left} {symbol} {right}))')])
        elif symbol in ('+', '-') and 'Vec' in cursor.type.get_canonical().spelling:
            self.arithmetic(cursor, left, symbol, right)

    def sign(self, cursor):
        begin, end = self.extent(cursor)
        symbol = self.text(begin, begin + 1)
        children = list(cursor.get_children())
        if len(children) != 1:
            return
        operand = self.whole(children[0])
        if symbol == '!':
            self.add(cursor, 'sign', [('! removed', f'(MUTANT != !({operand}))')])
        elif symbol == '-' and self.text(begin, begin + 2) != '--' and (
                cursor.type.get_canonical().kind in NUMBERS):
            self.add(cursor, 'sign', [('- removed', either(f'+{operand}', f'-{operand}'))])

    def number(self, cursor, parents):
        begin, end = self.extent(cursor)
        if self.is_template_argument(begin, end, parents):
            return
        text = self.text(begin, end)
        is_float = cursor.kind == CursorKind.FLOATING_LITERAL
        suffix = re.search(r'[uUlLzZ]*$' if not is_float else r'[fFlL]*$', text)[0]
        digits = text[:len(text) - len(suffix)].replace("'", '')
        try:
            value = float(digits) if is_float else int(digits, 0)
        except ValueError:
            return
        changed = [value + 1] + ([] if is_float or value == 0 else [value - 1])
        changed += [value * 10] if value else []
        to = self.converted(cursor, parents)
        self.add(cursor, 'number', [
            (f'{text} to {other!r}',
             f'static_cast<{to}>(MUTANT ? {other!r}{suffix} : {text})') for other in changed])

    def is_template_argument(self, begin, end, parents):
        if parents[-1].kind == CursorKind.BINARY_OPERATOR:
            return False
        before = self.bytes[:begin].rstrip()[-1:]
        after = self.bytes[end:].lstrip()[:1]
        return before == b'<' or after == b'>'

    def converted(self, cursor, parents):
        """The type to which the language converts the number: braces forbid to narrow the choice."""
        kind = cursor.type.get_canonical()
        for parent in reversed(parents):
            if parent.kind != CursorKind.UNEXPOSED_EXPR or self.extent(parent) != self.extent(
                    cursor) or parent.type.get_canonical().kind not in NUMBERS:
                break
            kind = parent.type.get_canonical()
        return kind.spelling.replace('const ', '')

    def named(self, cursor):
        if cursor.type.get_canonical().kind not in NUMBERS:
            return
        target = cursor.referenced
        if target is None or target.kind != CursorKind.VAR_DECL or not is_constexpr(target):
            return
        text = self.text(*self.extent(cursor))
        if text.startswith('std::') or not re.fullmatch(r'[\w:]+', text):
            return
        to = cursor.type.get_canonical().spelling.replace('const ', '')
        self.add(cursor, 'constant', [
            (f'{text} times ten', f'static_cast<{to}>(MUTANT ? 10 * {text} : {text})')])

    def conditions(self, cursor):
        kind = cursor.kind
        children = list(cursor.get_children())
        if kind == CursorKind.RETURN_STMT:
            if children and children[0].type.get_canonical().kind == TypeKind.BOOL:
                self.negate(children[0])
        elif kind == CursorKind.CONDITIONAL_OPERATOR:
            self.negate(children[0])
        elif kind in (CursorKind.IF_STMT, CursorKind.WHILE_STMT):
            if any(child.kind == CursorKind.VAR_DECL for child in children):
                return
            heads = [child for child in children if child.kind.is_expression() and
                     self.is_head(cursor, child)]
            if len(heads) == 1:
                self.negate(heads[0])

    def negate(self, cursor):
        """Adds the negation of a condition that no other operator negates."""
        inner = cursor
        while inner.kind == CursorKind.UNEXPOSED_EXPR:
            children = list(inner.get_children())
            if len(children) != 1 or self.extent(children[0]) != self.extent(inner):
                break
            inner = children[0]
        if inner.kind in (CursorKind.UNARY_OPERATOR, CursorKind.CXX_BOOL_LITERAL_EXPR):
            return
        if inner.kind in (CursorKind.BINARY_OPERATOR, CursorKind.CALL_EXPR):
            found = self.operands(inner)
            if found and found[1] in COMPARISONS:
                return
        self.add(cursor, 'condition', [
            ('negated', f'(MUTANT != static_cast<bool>({self.whole(cursor)}))')])

    def removal(self, cursor):
        inner = cursor
        while inner.kind == CursorKind.UNEXPOSED_EXPR:
            children = list(inner.get_children())
            if len(children) != 1:
                return
            inner = children[0]
        kind = inner.kind
        if kind == CursorKind.CALL_EXPR:
            is_assignment = re.fullmatch(r'operator[-+*/]?=', inner.spelling)
            if inner.spelling == 'reserve' or not (
                    is_assignment or inner.type.get_canonical().kind == TypeKind.VOID):
                return
        elif kind == CursorKind.BINARY_OPERATOR:
            found = self.operands(inner)
            if not found or found[1] != '=':
                return
        elif kind != CursorKind.COMPOUND_ASSIGNMENT_OPERATOR:
            return
        self.add(cursor, 'removal', [
            ('statement removed',
             f'(MUTANT ? static_cast<void>(0) : static_cast<void>({self.whole(cursor)}))')])


_constexpr = {}


def is_constexpr(declaration):
    """True if a token before the name of `declaration` is constexpr, consteval or constinit."""
    key = declaration.hash
    if key not in _constexpr:
        file = declaration.location.file
        begin, name = declaration.extent.start.offset, declaration.location.offset
        if file is None or name <= begin:
            return False
        with open(file.name, 'rb') as source:
            source.seek(begin)
            _constexpr[key] = re.search(rb'\bconst(expr|eval|init)\b',
                                        source.read(name - begin)) is not None
    return _constexpr[key]


def find_sites(unit_path, arguments, sources):
    """Returns the sites of `sources` in one translation unit.

    `sources` maps the paths of files to names that identify them on every machine. Throws
    RuntimeError if the unit does not compile.
    """
    unit = Index.create().parse(unit_path, args=arguments,
                                options=TranslationUnit.PARSE_DETAILED_PROCESSING_RECORD)
    errors = [d for d in unit.diagnostics if d.severity >= 3]
    if errors:
        raise RuntimeError(f'{unit_path}: {errors[0]}')
    macros = {path: [] for path in sources}
    tops = {path: [] for path in sources}
    for cursor in unit.cursor.get_children():
        file = cursor.location.file
        if file is None or file.name not in sources:
            continue
        if cursor.kind == CursorKind.MACRO_INSTANTIATION:
            macros[file.name].append((cursor.extent.start.offset, cursor.extent.end.offset))
        elif not cursor.kind.is_preprocessing():
            tops[file.name].append(cursor)
    sites = []
    for path, cursors in tops.items():
        finder = Finder(path, sources[path], macros[path])
        for cursor in cursors:
            finder.visit(cursor, [unit.cursor])
        sites += finder.sites
    return sorted(set(sites))
