#!/usr/bin/env python3
"""How two builds of bench_cut compare: they run in turns, and each row is given as the median of the ratios NEW : OLD
with its 95 % interval (by order statistics, so no distribution is assumed).

usage: compare_builds.py OLD_BENCH_CUT NEW_BENCH_CUT FILTER [PAIRS]

FILTER is a regular expression, as --benchmark_filter takes it. PAIRS: 20. Ends with a line for each row; exit code 1:
some row's interval begins above 1.02.
"""
import math
import statistics
import sys

from turns import times


def interval(ratios):
    """The narrowest interval between two of the sorted ratios that holds their median with 95 %."""
    n = len(ratios)
    rank = 0
    while sum(math.comb(n, j) for j in range(rank + 1)) / 2 ** n <= 0.025:
        rank += 1
    return ratios[max(rank - 1, 0)], ratios[min(n - rank, n - 1)]


def main():
    if len(sys.argv) not in (4, 5):
        sys.exit(__doc__)
    old, new, pattern = sys.argv[1:4]
    pairs = []
    for pair in range(int(sys.argv[4]) if len(sys.argv) == 5 else 20):
        pairs.append((times([old], pattern), times([new], pattern)))
        print(f'pair {pair + 1} done', file=sys.stderr)
    slower = False
    for row in pairs[0][0]:
        ratios = sorted(after[row] / before[row] for before, after in pairs)
        low, high = interval(ratios)
        slower = slower or low > 1.02
        print(f'{row:32} {statistics.median(ratios):.3f}  95 % {low:.3f} to {high:.3f}  '
              f'{statistics.median(a[row] for a, _ in pairs):.3f} : {statistics.median(b[row] for _, b in pairs):.3f} ms')
    sys.exit(slower)


if __name__ == '__main__':
    main()
