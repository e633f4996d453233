#!/usr/bin/env python3
"""Data sets that are opened, drawn and let go leave nothing behind in Python.

With each of them a device is opened and closed. After a warm-up, 1000 of them may leave 2 MiB in use: what is left by
lavapipe is some 0.6 KiB a device. It is not the size of the process that tells, since glibc keeps memory that is free:
with threads that come and go the process grows by some 50 KiB a device for long, and malloc_trim() gives that back.
"""
import ctypes
import sys

import vprobe

WARM = 200
OPENS = 1200
MORE_MIB = 2.0


class Mallinfo2(ctypes.Structure):
    _fields_ = [(name, ctypes.c_size_t) for name in (
        'arena', 'ordblks', 'smblks', 'hblks', 'hblkhd', 'usmblks', 'fsmblks', 'uordblks', 'fordblks', 'keepcost')]


def used_mib(libc=ctypes.CDLL('libc.so.6')):
    libc.mallinfo2.restype = Mallinfo2
    info = libc.mallinfo2()
    return (info.uordblks + info.hblkhd) / 2**20


def resident_mib():
    with open('/proc/self/status', encoding='utf-8') as status:
        return next(int(line.split()[1]) for line in status if line.startswith('VmRSS:')) / 1024


def main():
    warm = 0.0
    for opened in range(OPENS):
        if opened == WARM:
            warm = used_mib()
            print(f'{warm:.2f} MiB in use after {WARM} data sets, {resident_mib():.0f} MiB resident', flush=True)
        data = vprobe.open('demo:shell:6', classify='gpu' if opened % 2 else 'cpu')
        data.render(size=(64, 48))
        del data
    after = used_mib()
    print(f'{after:.2f} MiB in use after {OPENS}, {resident_mib():.0f} MiB resident')
    ctypes.CDLL('libc.so.6').malloc_trim(0)
    print(f'{resident_mib():.0f} MiB resident after malloc_trim()')
    return after > warm + MORE_MIB


if __name__ == '__main__':
    sys.exit(main())
