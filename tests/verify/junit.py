#!/usr/bin/env python3
"""Reads the file of `vprobe verify --junit` with python3-junitparser.

usage: junit.py VPROBE
Ends with 77 where junitparser is not installed.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

try:
    import junitparser
except ImportError:
    sys.exit(77)


def main(program):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for state, figures in [('good', {'grid': {'cells': 64}}), ('bad <&">', {'grid': {'cells': 65}}), ('lost', {})]:
            (folder / f'{state}.figures.json').write_text(json.dumps(figures), encoding='utf-8')
            inputs = ['none.vtu'] if state == 'lost' else ['demo:shell:4']
            (folder / f'{state}.json').write_text(json.dumps({'version': 1, 'input': {'files': inputs}}), encoding='utf-8')
        junit = folder / 'junit.xml'
        done = subprocess.run([program, 'verify', '--classify', 'cpu', name, '--junit', junit], capture_output=True,
                              check=False)
        assert done.returncode == 2, done
        suites = junitparser.JUnitXml.fromfile(str(junit))
        assert (suites.tests, suites.failures, suites.errors) == (3, 1, 1), suites
        results = {case.name: case.result for suite in suites for case in suite}
        assert results['good.figures.json'] == []
        failure, = results['bad <&">.figures.json']
        assert isinstance(failure, junitparser.Failure)
        assert failure.message == 'grid/cells is 64, expected 65', failure.message
        error, = results['lost.json']
        assert isinstance(error, junitparser.Error) and 'none.vtu' in error.message


if __name__ == '__main__':
    main(sys.argv[1])
