"""Finds Markdown that a formatter of code has rewritten.

clang-format takes a document for C++ if its name is passed by mistake. It then drops the blank after "#", moves the
stars of emphasis away from their words, takes the blank after a period, and breaks lines before colons and periods.
None of this stands in a document that a person wrote.
"""
import re

SIGNS = [
    (re.compile(r'^#+[^#\s!]'), 'a heading has no blank after #'),
    (re.compile(r'^\s*[:.,;](\s|$|\*\*)'), 'a line begins with punctuation'),
    (re.compile(r'[a-z]{2}[.,][A-Z][a-z]+\s'), 'a sentence begins without a blank'),
]


def stars_apart(prose):
    parts = re.split(r'(?<!\*)\*\*(?!\*)', prose)
    return len(parts) % 2 == 1 and any(bold != bold.strip() for bold in parts[1::2])


def signs_of_damage(line):
    """Yields what looks like a formatter's work in a line of prose."""
    prose = re.sub(r'`[^`]*`|\]\([^)]*\)', 'x', line)
    for pattern, message in SIGNS:
        if pattern.search(prose):
            yield f'{message}; did a code formatter run over this document?'
    if stars_apart(prose):
        yield 'the stars of bold text are apart from their words; did a code formatter run over this document?'
