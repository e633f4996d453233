"""Where the sources can be mutated: comparisons, constants, indices and calls.

The sources are formatted by clang-format, and this relies on it: a comparison has a space on each side, and the angle
brackets of a template have none. What the compiler evaluates is left alone.
"""
import bisect
import dataclasses
import hashlib
import re

COMPARISONS = {'<': ('<', 'Less', '>'), '<=': ('<', 'LessOrSame', '>'), '>': ('<', 'More', '>'),
               '>=': ('<', 'MoreOrSame', '>'), '==': ('==', 'Same', '=='), '!=': ('==', 'Other', '==')}
KINDS = ('compare', 'constant', 'index', 'drop')
# Calls without which a program does the same, only slower.
IDLE_CALLS = ('reserve', 'shrink_to_fit', 'assert', 'static_assert')
KEYWORDS = ('return', 'if', 'for', 'while', 'switch', 'else', 'delete', 'throw', 'case', 'do', 'sizeof', 'decltype')


@dataclasses.dataclass
class Site:
    file: str      # from the top folder
    kind: str
    begin: int     # offsets in the text
    end: int
    line: int
    last_line: int
    key: str       # changes with the function around it
    detail: str

    def insertions(self, number, text):
        """Pairs of an offset and a text. They add no lines."""
        call = f'vp_mutants::mutant({number})'
        if self.kind == 'compare':
            first, name, second = COMPARISONS[text[self.begin:self.end]]
            return [(self.begin, f'{first} vp_mutants::{name}({number}) {second}', self.end)]
        if self.kind == 'constant':
            sign = '-' if self.detail.endswith('less') else '+'
            return [(self.begin, '(', self.begin), (self.end, f' {sign} {call})', self.end)]
        if self.kind == 'index':
            return [(self.begin, '(', self.begin), (self.end, f') + {call}', self.end)]
        return [(self.begin, f'static_cast<void>({call} || ((', self.begin), (self.end, '), true))', self.end)]


def masked(text):
    """The text with spaces in place of comments, strings and lines of the preprocessor. Offsets stay the same."""
    blank = lambda match: re.sub(r'[^\n]', ' ', match.group())
    pattern = (r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<![0-9A-Fa-f])\'(?:\\.|[^\'\\\n])+\''
               r'|^[ \t]*#(?:[^\n]*\\\n)*[^\n]*')
    return re.sub(pattern, blank, text, flags=re.S | re.M)


def closing(text, at):
    """The offset of the bracket that closes the one at the offset, or None."""
    pairs = {'(': ')', '[': ']', '{': '}'}
    wanted = []
    for i in range(at, len(text)):
        if text[i] in pairs:
            wanted.append(pairs[text[i]])
        elif text[i] in ')]}':
            if not wanted or text[i] != wanted.pop():
                return None
            if not wanted:
                return i
    return None


def left_alone(text):
    """Ranges that the compiler evaluates, or that only declare."""
    ranges = []

    def to(begin, end):
        if end is not None and end >= 0:
            ranges.append((begin, end + 1))

    for match in re.finditer(r'\bif constexpr \(|\bstatic_assert\(|\balignas\(|\bdecltype\(|\bsizeof\(|\brequires\(', text):
        to(match.start(), closing(text, match.end() - 1))
    for match in re.finditer(r'\btemplate <', text):
        depth = 0
        for i in range(match.end() - 1, len(text)):
            depth += {'<': 1, '>': -1}.get(text[i], 0)
            if depth == 0:
                to(match.start(), i)
                break
    # Variables, but not functions: there a parenthesis comes first.
    for match in re.finditer(r'\bconstexpr\b[^;(){}=]*(=|\{)|\bconst [\w:<>, ]+ k[A-Z]\w*(?:\[\w*\])* ?(=|\{)', text):
        end = match.start()
        while end is not None and end < len(text) and text[end] != ';':
            end = closing(text, end) if text[end] in '([{' else end
            end = end + 1 if end is not None else None
        to(match.start(), end)
    for match in re.finditer(r'\benum\b[^;{]*\{|\bconcept\b[^;]*;|\bcase [^:;]*:|\busing [^;]*;|^requires .*$', text, re.M):
        to(match.start(), closing(text, match.end() - 1) if match.group().endswith('{') else match.end() - 1)
    for match in re.finditer(r'\w<[^<>;(){}]*>', text):
        to(match.start(), match.end() - 1)
    # Arrays and bit fields that are declared, and functions without a body.
    for match in re.finditer(r'^\s*(?:const |static )*[\w:]+(?:<[^;\n]*>)?[*&]? \w+(?:\[[^\]\n]*\])+(?= =|;|\{|,)'
                             r'| : \d+;|\)(?: const)?(?: noexcept)? = 0;', text, re.M):
        to(match.start(), match.end() - 1)
    return sorted(ranges)


def functions(text):
    """Ranges of the outermost blocks that are neither a namespace nor a type, with the words before them."""
    found, stack, start = [], [], 0
    for match in re.finditer(r'[{};]', text):
        i = match.start()
        if match.group() == '{':
            is_scope = re.search(r'\b(namespace|class|struct|union|enum|extern)\b[^()]*$', text[start:i]) is not None
            stack.append((start, is_scope))
        elif match.group() == '}' and stack:
            begin, is_scope = stack.pop()
            if not is_scope and all(scope for _, scope in stack):
                found.append((begin, i + 1))
        if not stack or stack[-1][1]:
            start = i + 1
    return sorted(found)


class Source:
    def __init__(self, file, text):
        self.file, self.text, self.masked = file, text, masked(text)
        self.line_starts = [0] + [m.end() for m in re.finditer('\n', text)]
        self.alone = left_alone(self.masked)
        self.functions = functions(self.masked)
        self.counts = {}

    def line_of(self, offset):
        return bisect.bisect_right(self.line_starts, offset)

    def around(self, offset):
        for begin, end in self.functions:
            if begin <= offset < end:
                return self.masked[begin:end]
        start = self.line_starts[self.line_of(offset) - 1]
        return self.masked[start:self.masked.find('\n', start)]

    def site(self, kind, begin, end, detail):
        if any(first <= begin < last for first, last in self.alone):
            return
        around = ' '.join(self.around(begin).split())
        number = self.counts[kind, around] = self.counts.get((kind, around), 0) + 1
        digest = hashlib.sha1(f'{around}|{kind}|{number}'.encode()).hexdigest()[:10]
        yield Site(self.file, kind, begin, end, self.line_of(begin), self.line_of(end), f'{self.file}:{kind}:{digest}',
                   detail)

    def compares(self):
        for match in re.finditer(r'(?<=[^\s,]) (<=|>=|<|>|==|!=)(?=[ \n])', self.masked):
            if not re.search(r'\b(template|operator)$', self.masked[:match.start(1) - 1]):
                yield from self.site('compare', match.start(1), match.end(1), match.group(1))

    def constants(self):
        number = r'(?<![\w.\'])(\d+\.\d*(?:[eE][-+]?\d+)?f?|\d+[uU]?[lL]{0,2})(?![\w.\'])'
        for match in re.finditer(number, self.masked):
            # Half of them become less, if they are not 0.
            half = hashlib.sha1(f'{self.file}{match.group()}{self.around(match.start())}'.encode()).digest()[0] % 2
            is_zero = not re.search('[1-9]', match.group())
            yield from self.site('constant', match.start(), match.end(),
                                 f'{match.group()} {"one less" if half and not is_zero else "one more"}')

    def indices(self):
        for match in re.finditer(r'(?<=[\w)\]])\[', self.masked):
            if re.search(r'\b(operator|delete|new [\w:]+|auto)$', self.masked[:match.start()][-60:]):
                continue
            end = closing(self.masked, match.start())
            inside = self.masked[match.end():end] if end else ''
            if inside.strip() and not re.search(r'[{};=]', inside):
                yield from self.site('index', match.end(), end, f'[{inside}]')

    def drops(self):
        call = r'^[ \t]+([a-z_]\w*(?:(?:::|\.|->)\w+|\[[^\[\]\n]*\])*)\('
        for match in re.finditer(call, self.masked, re.M):
            name = re.split(r'::|\.|->', match.group(1))[-1]
            end = closing(self.masked, match.end() - 1)
            if end is None or self.masked[end + 1:end + 2] != ';' or name[0].isupper():
                continue
            before = self.masked[:match.start(1)].rstrip()[-1:]
            if name in IDLE_CALLS or name.startswith('prefetch') or match.group(1) in KEYWORDS:
                continue
            if before not in (';', '{', '}', ')'):
                continue
            if re.search(r'\b(namespace|class|struct)\b', self.around(match.start(1)).split('{')[0]):
                continue
            yield from self.site('drop', match.start(1), end + 1, f'{match.group(1)}()')

    def sites(self):
        self.counts = {}
        yield from self.compares()
        yield from self.constants()
        yield from self.indices()
        yield from self.drops()


def chosen(sites, count, seed):
    """As many of each kind, by a number that a change elsewhere leaves as it is."""
    rank = lambda site: hashlib.sha1(f'{seed}|{site.key}'.encode()).hexdigest()
    by_kind = {kind: sorted((s for s in sites if s.kind == kind), key=rank) for kind in KINDS}
    return [site for row in zip(*by_kind.values()) for site in row][:count]


def mutated(text, numbered):
    """numbered: pairs of a number and a site of this text."""
    pieces = sorted((piece for number, site in numbered for piece in site.insertions(number, text)),
                    key=lambda piece: piece[0])
    result, at = [], 0
    for begin, inserted, end in pieces:
        result += [text[at:begin], inserted]
        at = end
    return ''.join(result) + text[at:]
