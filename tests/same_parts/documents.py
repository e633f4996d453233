"""The command lines of README.md and docs/: in blocks of code, and between backquotes."""
import dataclasses
import functools
import os
import pathlib
import re
import shlex

from .cases import Case, LeftOut, Step
from .samples import stand_ins

ROOT = pathlib.Path(__file__).resolve().parents[2]
# What a line has in place of words of the user's own.
WORDS = {'FILE': ['demo:shell:24'], 'INPUT': ['demo:shell:24'], 'COMMAND': ['slice'],
         'PROBE': ['--normal', '0.3', '0.5', '0.8'], 'U0': ['-1'], 'V0': ['0.2'], 'U1': ['1'], 'V1': ['0.5']}
SHELL = ('|', '<', '&')
DRAWS = ('render', 'sweep')
SMALL = '320x180'
FEW_FRAMES = 4
FEW_PLANES = 5
COARSE = 64  # cells of a built-in data set each way, at most
# What vprobe view does in place of a user.
SCRIPT = b'wait\nsave-state state.json\nsave-picture 160 100 scene.png\nsave-slice slice.vtp\nquit\n'


def blocks_of(text):
    """Blocks of code, each as its lines. Those in a language of their own are left out."""
    fence = None
    block = []
    for line in text.split('\n'):
        if line.lstrip().startswith('```'):
            if fence is None:
                fence = line.strip()[3:]
            else:
                if fence in ('', 'sh'):
                    yield block
                fence = None
            block = []
        elif fence is not None or re.match(r'(    |\t)\S', line) or block and re.match(r'(    |\t)', line):
            block.append(line.strip())
        elif block:
            yield block
            block = []


def spans_of(text):
    """What stands between backquotes, outside of blocks, and has a command and more."""
    outside = re.sub(r'^```.*?^```$', '', text, flags=re.S | re.M)
    return [[span] for span in re.findall(r'`((?:mpiexec -n \d+ vprobe-mpi|vprobe) [a-z]+ [^`]+)`', outside)]


def commands_of(lines):
    """The words of each command: lines joined, remarks left out. Whatever is no command of ours is left out."""
    text = re.sub(r'\\\n\s*', ' ', '\n'.join(lines))
    for line in text.split('\n'):
        line = line.removeprefix('$ ')
        if re.match(r'(mpiexec -n \w+ vprobe-mpi|vprobe) ', line):
            yield shlex.split(line, comments=True)


@dataclasses.dataclass
class Fitted:
    """A command that can run here."""
    step: Step
    files: dict
    reason: str = ''  # why it cannot


@functools.cache
def data_files():
    """By its name, where each file of VPROBE_DATA is."""
    folder = os.environ.get('VPROBE_DATA')
    paths = sorted(pathlib.Path(folder).rglob('*.*')) if folder else []
    return {path.name: str(path) for path in paths if path.is_file()}


class Documents:
    def __init__(self, full=False, root=ROOT):
        self.full = full
        self.root = root
        self.stand_ins = stand_ins()
        self.data = data_files()

    def cases(self):
        seen = set()
        for page in [self.root / 'README.md', *sorted((self.root / 'docs').glob('*.md'))]:
            text = page.read_text(encoding='utf-8')
            for block in [*blocks_of(text), *spans_of(text)]:
                yield from self.of_block(list(commands_of(block)), seen)

    def of_block(self, commands, seen):
        """The commands of a block share a folder: one may read what another wrote."""
        case = Case('docs', [])
        for words in commands:
            if tuple(words) in seen:
                continue
            seen.add(tuple(words))
            fitted = self.fit(words)
            if fitted.reason:
                yield LeftOut('docs', shlex.join(words), fitted.reason)
            elif fitted.step.window:
                yield Case('view', [fitted.step], fitted.files | {'script': SCRIPT})
            else:
                case.files.update(fitted.files)
                case.steps += [fitted.step, *self.variants(fitted.step)]
        if case.steps:
            yield case

    def fit(self, words):
        if words[-1] == '--state' or any(word in SHELL or word.startswith(('[', '>')) or word.endswith('...') for word in words):
            return Fitted(None, {}, 'shows the syntax, or needs a shell')
        ranks = 0
        if words[0] == 'mpiexec':
            ranks, words = int(words[2]), words[3:]
        files = {}
        fitted = []
        for word in words:
            if word in self.stand_ins:
                files.update(self.stand_ins[word])
                fitted += [name for name in self.stand_ins[word] if '*' in word or name == word]
            else:
                fitted += [self.data[word]] if word in self.data else WORDS.get(word, [word])
        first = fitted[2] if len(fitted) > 2 else ''
        if '.' in first and not first.startswith(('-', 'demo:', '/')) and first not in files:
            return Fitted(None, {}, f'{first} is not at hand' + ('' if self.data else '; VPROBE_DATA is not set'))
        if fitted[1] == 'profile' and {'--versus', '--versus-program'} & set(fitted):
            return Fitted(None, {}, 'all that it prints is measured')
        if fitted[1] == 'view' and not {'--help', '--list-bindings', '--explain'} & set(fitted):
            return Fitted(Step([*fitted, '--commands', 'script', '--size', '640x400'], window=True), files)
        return Fitted(Step(fitted if self.full else shortened(fitted), ranks), files)

    def variants(self, step):
        """The same with --explain and --stats."""
        words = step.words
        if not {'--help', '--explain', '--stats'}.isdisjoint(words) or words[2].startswith('-') and '--state' not in words:
            return
        if words[1] in ('slice', 'render', 'sweep', 'profile'):
            yield Step([*words, '--explain'], step.ranks)
        if words[1] in ('slice', 'render', 'sweep'):
            yield Step([*words, '--stats', 'stats.json'], step.ranks)


def shortened(words):
    """A command with a small picture, few frames and a coarse grid."""
    coarse = lambda demo: f'{demo[1]}:{min(int(demo[2]), COARSE)}'  # noqa: E731
    words = [re.sub(r'^(demo:\w+):(\d+)$', coarse, word) for word in words]
    if '--help' in words:
        return words
    for option, most in (('--frames', FEW_FRAMES), ('--planes', FEW_PLANES)):
        if option in words:
            words[words.index(option) + 1] = str(most)
    if words[1] == 'sweep' and '--frames' not in words:
        words += ['--frames', str(FEW_FRAMES)]
    if words[1] == 'profile' and '--planes' not in words and '--compare' not in words:
        words += ['--planes', str(FEW_PLANES)]
    if '--size' not in words and (words[1] in DRAWS or words[1] == 'profile' and '--draw' in words):
        words += ['--size', SMALL]
    return words
