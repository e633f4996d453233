#!/usr/bin/env python3
"""Files that other programs write: read, and compared with the same data in a file of VTK or NRRD.

usage: others.py VPROBE [PART-OF-A-NAME | N/M | drawn]; N/M is every M-th case from the N-th on, and `drawn` are those that
need a Vulkan device. convert_reference_sets, which takes long, runs by its whole name only

VPROBE_TRY_EVERY asks for every so many of the cases (tests/unit/support/tries.h), VPROBE_LONG for all.
A case whose program or module is missing is left out; exit code 77 where that is all of them.
"""
import os
import pathlib
import re
import sys
import tempfile
import time
import traceback

import against
import boxes
import codes
import conventions
import conversion
import curved
import damage
import drawn
import ensight
import everyday
import exodus
import far
import indexed_formats
import indices
import labels
import meshes
import models
import n5
import newest
import odd
import packed_polyhedra
import packed_times
import packs
import parts
import pictures
import scans
import stacked
import stacks
import steps
import volumes
import zarr3


def chosen_cases():
    cases = (meshes.CASES + volumes.CASES + boxes.CASES + codes.CASES + odd.CASES + steps.CASES + exodus.CASES +
             conversion.CASES + conventions.CASES + far.CASES + stacks.CASES + curved.CASES +
             ensight.CASES + models.CASES + damage.CASES + pictures.CASES + labels.CASES + everyday.CASES +
             parts.CASES + newest.CASES + scans.CASES + stacked.CASES + zarr3.CASES + n5.CASES + packs.CASES +
             packed_times.CASES + packed_polyhedra.CASES + indices.CASES + indexed_formats.CASES)
    wanted = sys.argv[2] if len(sys.argv) > 2 else '1/1'
    if wanted == 'drawn':
        return drawn.CASES
    part = re.fullmatch(r'(\d+)/(\d+)', wanted)
    if not part:
        return [case for case in cases + drawn.CASES if wanted in case.__name__ and
                (case is not conversion.convert_reference_sets or wanted == case.__name__)]
    every = 1 if 'VPROBE_LONG' in os.environ else int(os.environ.get('VPROBE_TRY_EVERY', 1))
    cases = [case for case in cases if case is not conversion.convert_reference_sets]
    return cases[::every][int(part[1]) - 1::int(part[2])]


def main():
    failed = done = 0
    for case in chosen_cases():
        began = time.monotonic()
        with tempfile.TemporaryDirectory(prefix='vprobe-formats-') as folder:
            against.scratch = pathlib.Path(folder)
            try:
                case(against.scratch)
                done += 1
                print(f'{case.__name__}: as it should be, {time.monotonic() - began:.1f} s')
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
