#!/usr/bin/env python3
"""Whether two builds of vprobe export the same bytes: every input, cut by four planes, with both classifiers, as .vtp.

usage: compare_exports.py OLD_VPROBE NEW_VPROBE INPUT...

For changes that must not change a cut. Ends with a line "N the same, N different"; exit code 0: none is different.
"""
import os
import subprocess
import sys
import tempfile

NORMALS = (('x',), ('y',), ('z',), ('0.3', '0.5', '0.81'))


def export(vprobe, source, normal, classifier, folder):
    """The bytes of the export, or the error line where there is none."""
    path = os.path.join(folder, 'cut.vtp')
    run = subprocess.run([vprobe, 'slice', source, '--normal', *normal, '--classify', classifier, '-o', path],
                         capture_output=True, text=True)
    if run.returncode:
        return run.stderr.strip()
    with open(path, 'rb') as file:
        return file.read()


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    old, new, sources = sys.argv[1], sys.argv[2], sys.argv[3:]
    same = different = 0
    with tempfile.TemporaryDirectory() as folder:
        for source in sources:
            for normal in NORMALS:
                for classifier in ('cpu', 'gpu'):
                    before, after = (export(vprobe, source, normal, classifier, folder) for vprobe in (old, new))
                    if before == after:
                        same += 1
                        continue
                    different += 1
                    print(f'{source}, normal {" ".join(normal)}, {classifier}: different', flush=True)
    print(f'{same} the same, {different} different')
    return 1 if different else 0


if __name__ == '__main__':
    sys.exit(main())
