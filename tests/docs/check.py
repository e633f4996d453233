#!/usr/bin/env python3
"""The style of the documents: every Markdown file under version control.

- A line ends at 120 columns. Rows of tables and code are left out, since they cannot be wrapped.
- American spelling.
- None of the odd words that the project once used.
- Links to files of the repository lead somewhere.

What stands in code, in a block or between backquotes, is not looked at. Prints FILE:LINE: MESSAGE for each finding;
exit code 1 where there is one.
"""
import pathlib
import re
import subprocess
import sys

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
        if in_code or line.startswith(('\t', '    ')) and not re.match(r'\s*([-*]|\d+\.) ', line) and '](' not in line:
            continue
        if len(line) > COLUMNS and not line.startswith('|'):
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
        listed = subprocess.run(['git', '-C', root, 'ls-files', '*.md'], capture_output=True, text=True)
    except FileNotFoundError:
        listed = None
    if listed is None or listed.returncode:
        print('no version control here, so nobody knows which documents belong to the project')
        return 77
    findings = 0
    for name in listed.stdout.split('\n'):
        path = root / name
        if not name or not path.exists():
            continue
        for number, message in check(path, root):
            print(f'{name}:{number}: {message}')
            findings += 1
    return 1 if findings else 0


sys.exit(main())
