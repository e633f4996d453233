"""Adds arrays to a data set and to a copy of a slice, saves and draws them."""
import numpy as np

import vprobe

data = vprobe.open('demo:shell:32')
data['number'] = np.arange(data.n_cells)
s = data.slice(normal='x', array='s')
print(s['number'].dtype, s.keys())
own = s.copy()
own['error'] = np.abs(own['s'] - np.sin(3 * own.points[:, 0]))
own.save('own.vtp')
data.render(own, array='error', size=(640, 400)).save('own.png')
