"""Cuts a grid of numpy arrays, which are shared, and changes values in place."""
import numpy as np

import vprobe

r, t, z = np.meshgrid(np.linspace(1, 2, 20), np.linspace(0, np.pi, 40), np.linspace(0, 3, 30))
points = np.stack([r * np.cos(t), r * np.sin(t), z], axis=-1)  # (nk, nj, ni, 3)
p = np.sin(3 * t) / r
data = vprobe.structured(points, {'p': p, 'place': points})
print(data, data.memory())
print(f'mean {data.slice(normal="z").mean:.4f}')
p += 1
data.modified()  # after changing values in place
print(f'mean {data.slice(normal="z").mean:.4f}')
try:
    vprobe.structured(points, {'p': p[:, ::2]})
except vprobe.InputError as error:
    print(error)
