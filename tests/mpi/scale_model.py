#!/usr/bin/env python3
"""What vprobe-mpi takes on more machines than there are to try: a model, and a simulation of the tree of layers.

Times of the parts are fitted to runs of one rank with one thread (docs/SCALE.md tells which). The network is assumed.
Usage: scale_model.py              the table of docs/SCALE.md
       scale_model.py simulate X Y Z  bytes of layers that the ranks of X x Y x Z blocks send
"""
import math
import sys

import numpy as np

# Fitted: seconds.
READ_START = 0.064  # a reader's process and the first pages
READ_CELL = 0.080e-6
BUILD_CELL = 0.003e-6
SCAN_CELL = 0.0060e-6  # a sheet
EMIT_POLYGON = 0.65e-6
MEASURE_POLYGON = 0.12e-6
DRAW = 0.22  # a picture of 8 layers by a software device
# Assumed: the time of a message, bytes a second, and how long it takes to look at a piece on a disk that many share.
LATENCY = 20e-6
BANDWIDTH = 1.0e9
MERGE = 1.0e9  # bytes of layers that a core takes in each second
LIST_PART = 60e-6

SHEETS = 8
WIDTH, HEIGHT = 1280, 720
LAYER_BYTES = 1.23e6  # that the wheel shows at all: as two ranks send half of them
POLYGONS = 0.75  # a vane cuts about this times cells^(2/3)


def lattice_of(ranks):
    """Blocks of a cube, as even as can be, x fastest."""
    shapes = [(x, y, ranks // x // y) for x in range(1, ranks + 1) if ranks % x == 0
              for y in range(x, ranks // x + 1) if ranks // x % y == 0 and ranks // x // y >= y]
    return min(shapes, key=lambda shape: shape[2] - shape[0])


def neighbors_of(counts):
    """The most ranks whose blocks touch that of one: 26 in a large lattice."""
    return math.prod(min(count, 3) for count in counts) - 1


def shares_of(counts, samples=400_000):
    """Which part of the wheel's area lies in each block of a cube. Its vanes are the halves of planes through z."""
    random = np.random.default_rng(1)
    along = random.uniform(0.0, 1.0, samples)
    angle = 2.0 * math.pi * random.integers(0, SHEETS, samples) / SHEETS
    reach = 0.5 / np.maximum(np.abs(np.cos(angle)), np.abs(np.sin(angle)))
    places = (0.5 + along * reach * np.cos(angle), 0.5 + along * reach * np.sin(angle),
              random.uniform(0.0, 1.0, samples))
    block = [np.clip((places[axis] * counts[axis]).astype(int), 0, counts[axis] - 1) for axis in range(3)]
    rank = (block[2] * counts[1] + block[1]) * counts[0] + block[0]
    return np.bincount(rank, weights=reach, minlength=math.prod(counts)) / reach.sum()


def tree(shares):
    """Bytes that each rank sends, and when the first rank has all: as mergeLayers() goes."""
    held = shares * LAYER_BYTES
    ready = np.zeros(len(held))
    sent = np.zeros(len(held))
    step = 1
    while step < len(held):
        for rank in range(0, len(held) - step, 2 * step):
            message = held[rank + step]
            sent[rank + step] = message
            arrives = max(ready[rank], ready[rank + step]) + LATENCY + message / BANDWIDTH
            ready[rank] = arrives + message / MERGE
            held[rank] += message
        step *= 2
    return sent, ready[0]


def seconds(ranks, cells):
    """Of one picture: parts by name."""
    each = cells / ranks
    polygons = POLYGONS * SHEETS * cells ** (2 / 3) / ranks
    levels = math.ceil(math.log2(ranks))
    return {'list': LIST_PART * ranks,
            'read': READ_START + each * (READ_CELL + BUILD_CELL),
            'cut': each * SCAN_CELL * SHEETS + polygons * EMIT_POLYGON,
            'measure': polygons * MEASURE_POLYGON,
            # For each sheet some 9 sums or gatherings, up and down the tree, and 9 exchanges with each neighbor.
            'agree': SHEETS * 9 * (2 * levels + neighbors_of(lattice_of(ranks))) * LATENCY,
            'draw': DRAW,
            'layers': tree(shares_of(lattice_of(ranks)))[1]}


def main():
    if len(sys.argv) == 5 and sys.argv[1] == 'simulate':
        sent, time = tree(shares_of(tuple(map(int, sys.argv[2:]))))
        print(' '.join(f'{count:.0f}' for count in sent), f'sum {sent.sum():.0f}, {time * 1e3:.2f} ms')
        return
    names = list(seconds(1, 1e6))
    print('| cells | ranks |', ' | '.join(names), '| all, s |')
    print('| ---', '| ---:' * (len(names) + 2), '|')
    for cells in (1e9, 1e10, 1e11, 1e12):
        for ranks in (1, 8, 64, 512, 4096):
            if cells / ranks > 2e9:
                continue  # more than the ids of a block hold
            parts = seconds(ranks, cells)
            print(f'| 10^{round(math.log10(cells))} | {ranks} |', ' | '.join(f'{parts[name]:.2g}' for name in names),
                  f'| {sum(parts.values()):.3g} |')


if __name__ == '__main__':
    main()
