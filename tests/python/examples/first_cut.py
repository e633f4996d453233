"""Cuts a data set, looks at the numbers, and saves the polygons."""
import vprobe

data = vprobe.open('demo:shell:32')  # or any file of the program, at time=0.5
print(data)
s = data.slice(normal=(.3, .5, .8), origin='center', array='s')
print(s)
print(f'area {s.area:.3f}, mean {s.mean:.4f}, from {s.min:.3f} to {s.max:.3f}')
print(s.points.shape, s['s'].dtype, s['v'].shape)  # read-only views of the library's memory
own = s.copy()
own['s'][:] *= 2  # a copy is one's own
s.save('cut.vtp')
for piece in data.slice_along_axis(4, 'x'):
    print(f'x = {piece.origin[0]:+.2f}: area {piece.area:.3f}')
