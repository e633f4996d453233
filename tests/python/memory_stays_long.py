#!/usr/bin/env python3
"""Data sets that are opened, drawn and let go leave nothing behind in Python.

With each of them a device is opened and closed. After a warm-up 1000 of them may take 12 MiB more.
"""
import sys

import vprobe

WARM = 200
OPENS = 1200
MORE_MIB = 12.0


def resident_mib():
    with open('/proc/self/status', encoding='utf-8') as status:
        return next(int(line.split()[1]) for line in status if line.startswith('VmRSS:')) / 1024


def main():
    warm = 0.0
    for opened in range(OPENS):
        if opened == WARM:
            warm = resident_mib()
        data = vprobe.open('demo:shell:6', classify='gpu' if opened % 2 else 'cpu')
        data.render(size=(64, 48))
        del data
    after = resident_mib()
    print(f'{warm:.1f} MiB after {WARM} data sets, {after:.1f} MiB after {OPENS}')
    return after > warm + MORE_MIB


if __name__ == '__main__':
    sys.exit(main())
