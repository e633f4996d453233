"""Counts comments in the code that are hard to read at first sight. The counts may only fall.

A comment that begins with "Of" or "What", or a trailing comment that begins with "of", mostly leaves out the noun that
it is about. The allowed counts are in comment_counts.txt beside this file: a number and a name in each line.
"""
import pathlib
import re

FOLDERS = ['engine', 'apps', 'tests', 'shaders']
ENDINGS = {'.h', '.cpp', '.inl', '.in', '.glsl', '.comp', '.vert', '.frag'}
PATTERNS = {'Of': re.compile(r'^\s*//+ Of '), 'of': re.compile('// of '), 'What': re.compile(r'^\s*//+ What ')}
ALLOWED = pathlib.Path(__file__).resolve().parent / 'comment_counts.txt'


def count(paths):
    counts = dict.fromkeys(PATTERNS, 0)
    for path in paths:
        if path.suffix not in ENDINGS or not path.exists():
            continue
        for line in path.read_text(encoding='utf-8', errors='replace').split('\n'):
            for name, pattern in PATTERNS.items():
                counts[name] += bool(pattern.search(line))
    return counts


def allowed_counts():
    return {name: int(number) for number, name in map(str.split, ALLOWED.read_text().split('\n')[:-1])}


def check(paths):
    """Yields a message for each count that is not the allowed one, and whether it is a fault: it rose."""
    counts = count(paths)
    for name, allowed in allowed_counts().items():
        shown = f'{counts[name]} comments begin with "{name} …"'
        if counts[name] > allowed:
            yield f'{shown}, and {allowed} are allowed; write a sentence that names what the comment is about', True
        elif counts[name] < allowed:
            yield f'{shown}, and {allowed} are allowed; lower the number in tests/docs/{ALLOWED.name}', False
