#!/usr/bin/env python3
"""Files that other programs write: read, and compared with the same data in a file of VTK or NRRD.

usage: others.py VPROBE [PART-OF-A-NAME]; convert_reference_sets, which takes long, runs by its whole name only

VPROBE_TRY_EVERY asks for every so many of the cases (tests/unit/support/tries.h), VPROBE_LONG for all.
A case whose program or module is missing is left out; exit code 77 where that is all of them.
"""
import os
import pathlib
import sys
import tempfile
import traceback

import against
import boxes
import codes
import conventions
import conversion
import curved
import damage
import ensight
import exodus
import far
import meshes
import models
import odd
import stacks
import steps
import volumes


def main():
    failed = done = 0
    every = 1 if 'VPROBE_LONG' in os.environ or len(sys.argv) > 2 else int(os.environ.get('VPROBE_TRY_EVERY', 1))
    cases = (meshes.CASES + volumes.CASES + boxes.CASES + codes.CASES + odd.CASES + steps.CASES + exodus.CASES +
             conversion.CASES + conventions.CASES + far.CASES + stacks.CASES + curved.CASES +
             ensight.CASES + models.CASES + damage.CASES)
    for case in cases[::every]:
        wanted = sys.argv[2] if len(sys.argv) > 2 else ''
        if wanted not in case.__name__ or case is conversion.convert_reference_sets and wanted != case.__name__:
            continue
        with tempfile.TemporaryDirectory(prefix='vprobe-formats-') as folder:
            against.scratch = pathlib.Path(folder)
            try:
                case(against.scratch)
                done += 1
                print(f'{case.__name__}: as it should be')
            except against.Missing as missing:
                print(f'{case.__name__}: left out, {missing} is not installed')
            except Exception as error:  # pylint: disable=broad-except
                if not isinstance(error, AssertionError):
                    traceback.print_exc()
                failed += 1
                print(f'{case.__name__}: FAILED: {error}')
    return 1 if failed else 0 if done else 77


if __name__ == '__main__':
    sys.exit(main())
