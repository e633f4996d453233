#!/usr/bin/env python3
"""The style of the documents: every Markdown file under version control.

- A line ends at 120 columns. Rows of tables, code and lines of one link are left out, since they cannot be wrapped.
- American spelling.
- None of the odd words that the project once used.
- Links to files of the repository lead somewhere.
- No code formatter ran over the document (formatter_damage.py).

Code, in a block or between backquotes, is not checked. Hard comments in the code are counted too (code_comments.py).
Prints FILE:LINE: MESSAGE for each finding. The exit code is 1 if there is one.
"""
import pathlib
import re
import subprocess
import sys

import code_comments
import formatter_damage

COLUMNS = 120
BRITISH = {
    'behaviour': 'behavior', 'catalogue': 'catalog', 'centre': 'center', 'colour': 'color', 'defence': 'defense',
    'favour': 'favor', 'fibre': 'fiber', 'grey': 'gray', 'initialis': 'initializ', 'labelled': 'labeled',
    'labelling': 'labeling', 'licence': 'license', 'maximis': 'maximiz', 'metre': 'meter', 'minimis': 'minimiz',
    'modelling': 'modeling', 'neighbour': 'neighbor', 'normalis': 'normaliz', 'optimis': 'optimiz', 'organis': 'organiz',
    'recognis': 'recogniz', 'summaris': 'summariz', 'synchronis': 'synchroniz', 'travell': 'travel',
    'visualis': 'visualiz', 'artefact': 'artifact', 'judgement': 'judgment'}
ODD = ['Workbench', 'the hand ', 'an Artist', 'the artist', 'Lettering', 'kMost', 'kLeast']


def prose_of(line):
    return re.sub(r'`[^`]*`|\]\([^)]*\)', '', line)


def check(path, root):
    in_code = False
    for number, line in enumerate(path.read_text(encoding='utf-8').split('\n'), 1):
        if line.lstrip().startswith('```'):
            in_code = not in_code
            continue
        if not in_code:
            for message in formatter_damage.signs_of_damage(line):
                yield number, message
        if in_code or line.startswith(('\t', '    ')) and not re.match(r'\s*([-*]|\d+\.) ', line) and '](' not in line:
            continue
        if len(line) > COLUMNS and not line.startswith('|') and not re.fullmatch(r'\s*\S*\]\(\S*\)\S*', line):
            yield number, f'{len(line)} columns; a line ends at {COLUMNS}'
        prose = prose_of(line)
        for british, american in BRITISH.items():
            found = re.search(rf'\b{british}\w*', prose, re.IGNORECASE)
            if found:
                yield number, f'"{found.group()}": write {american}'
        for odd in ODD:
            if odd in prose:
                yield number, f'"{odd.strip()}" is not the word for it; see the names in the code'
        for target in re.findall(r'\]\(([^)#]+)[^)]*\)', re.sub(r'`[^`]*`', '', line)):
            if '://' not in target and not (path.parent / target).exists():
                yield number, f'{target}: the link leads nowhere'


def main():
    root = pathlib.Path(__file__).resolve().parents[2]
    try:
        listed = subprocess.run(['git', '-C', root, 'ls-files', '*.md', *code_comments.FOLDERS], capture_output=True,
                                text=True)
    except FileNotFoundError:
        listed = None
    if listed is None or listed.returncode:
        print('no version control here, so nobody knows which documents belong to the project')
        return 77
    findings = 0
    names = listed.stdout.split('\n')[:-1]
    for name in names:
        path = root / name
        if path.suffix != '.md' or not path.exists():
            continue
        for number, message in check(path, root):
            print(f'{name}:{number}: {message}')
            findings += 1
    for message, is_fault in code_comments.check([root / name for name in names]):
        print(f'comments: {message}')
        findings += is_fault
    return 1 if findings else 0


sys.exit(main())
