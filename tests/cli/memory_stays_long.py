#!/usr/bin/env python3
"""Long sweeps take no more memory than short ones.

usage: memory_stays_long.py VPROBE

Sweeps of 20 000 frames, as figures and as pictures. In the second half the memory of the program may grow by 4 MiB.
Frames that leave 1 KiB each would take 10 MiB.
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import time

FRAMES = 20000
MORE_MIB = 4.0
SWEEPS = {'figures': ['demo:shell:8', '--classify', 'cpu', '--stats', '-'],
          'pictures': ['demo:shell:6', '--size', '64x48', '--samples', '1', '-o', 'frame{frame}.png'],
          'figures by the device': ['demo:blob:6', '--classify', 'gpu', '--probe', 'trihedral', '--stats', '-']}


def resident_mib(process):
    for line in pathlib.Path(f'/proc/{process.pid}/status').read_text(encoding='utf-8').splitlines():
        if line.startswith('VmRSS:'):
            return int(line.split()[1]) / 1024
    return None  # it has ended


def sizes_of(vprobe, options):
    """Pairs of a share of the time, and MiB."""
    with tempfile.TemporaryDirectory() as folder:
        start = time.monotonic()
        process = subprocess.Popen([vprobe, 'sweep', *options, '--frames', str(FRAMES)], cwd=folder,
                                   stdout=subprocess.DEVNULL, env={**os.environ, 'VPROBE_VALIDATION': '0'})
        sizes = []
        while process.poll() is None:
            if (size := resident_mib(process)) is not None:
                sizes.append((time.monotonic() - start, size))
            # There would be too many of them in the end.
            for picture in list(pathlib.Path(folder).glob('frame*.png'))[:-10]:
                picture.unlink()
            time.sleep(0.05)
        if process.returncode:
            sys.exit(f'vprobe ended with {process.returncode}')
        return [(at / (time.monotonic() - start), size) for at, size in sizes]


def main():
    failed = False
    for name, options in SWEEPS.items():
        sizes = sizes_of(sys.argv[1], options)
        warm = max(size for share, size in sizes if share < 0.5)
        most = max(size for share, size in sizes if share >= 0.5)
        grew = most > warm + MORE_MIB
        failed |= grew
        print(f'{name}: {warm:.1f} MiB in the first half of {FRAMES} frames, then at most {most:.1f} MiB'
              f'{": MORE" if grew else ""}', flush=True)
    return failed


if __name__ == '__main__':
    sys.exit(main())
