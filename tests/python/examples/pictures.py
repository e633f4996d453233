"""Draws a probe, and frames of a film in which it turns."""
import vprobe

data = vprobe.open('demo:shell:32')
probe = vprobe.Probe.paddlewheel(vanes=3, opacity=.8, normal=(.3, .5, .8))
image = data.render(probe, size=(640, 400), colormap='turbo', background='white')
print(image, image.dtype, image.shape)
image.save('paddlewheel.png')
for frame in data.sweep(probe, path='revolve', frames=4, size=(320, 200)):
    frame.image.save(f'frame{frame.index}.png')
    print(f'{frame.index + 1} of {frame.count}: area {frame.cut.area:.2f}')
