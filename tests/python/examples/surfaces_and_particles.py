"""Other surfaces, contours that grow from a slice, particles, samples, and why a cut goes the way it goes."""
import numpy as np

import vprobe

data = vprobe.open('demo:shell:32')
print('wave    ', data.slice('z = sin(x)'))
print('ball    ', data.slice('sphere:2', origin=(0, 0, 0)))
print('iso     ', data.isosurface(.5))
s = data.slice(normal='x', origin=(0, 1, 0), array='s', window=(3, 3))
print('grown   ', data.grow_contour(s, .5))
print('traced  ', data.trace(s, 'v', vector_lattice=8))
line = np.linspace((1, 1, .5), (2, 1.5, 1), 5)
print('sampled ', data.sample(line)['s'].round(3))
for row in data.plan(vprobe.Probe.trihedral()):
    print('plan    ', row.sheet, row.strategy, '-', row.reason)
