"""Pictures, sweeps with pictures, devices that are lost, notebooks."""
import glob
import os
import subprocess
import sys
import time
import zlib

import numpy as np
import pytest

import vprobe

pytestmark = pytest.mark.gpu
PLANE = dict(normal=(.3, .5, .8))
SMALL = dict(size=(160, 100), samples=1, background='white')


def render(data, *arguments, **settings):
    try:
        return data.render(*arguments, **{**SMALL, **settings})
    except vprobe.DeviceError as error:
        pytest.skip(str(error))


def drawn(image):
    return int((np.asarray(image)[..., :3] != 255).any(axis=2).sum())


def test_a_picture_is_an_array_that_shows_itself(shell, tmp_path):
    told = []
    image = render(shell, vprobe.Probe.paddlewheel(3, opacity=.6), progress=told.append)
    assert image.shape == (100, 160, 4) and image.dtype == np.uint8 and drawn(image) > 1000
    png = image._repr_png_()
    assert png.startswith(b'\x89PNG') and png == image.png()
    image.save(tmp_path / 'picture.png')
    assert (tmp_path / 'picture.png').read_bytes() == png
    assert repr(image) == '<vprobe.Image 160 x 100 pixels>'
    assert image[..., 0].mean() > 0 and image[..., 0]._repr_png_() is None
    with pytest.raises(vprobe.UsageError, match='is no picture'):
        image[..., :3].png()
    with pytest.raises(vprobe.OutputError):
        image.save('/proc/none/picture.png')
    view = np.asarray(image)
    view[:50] = 0  # it is the caller's own
    assert image[0, 0, 0] == 0 and image.png() != png


def test_a_slice_is_drawn_as_it_was_cut(shell):
    piece = shell.slice(**PLANE, array='s')
    assert np.array_equal(render(shell, piece), render(shell, **PLANE, array='s'))
    assert not np.array_equal(render(shell, piece), render(shell, piece, colormap='turbo'))
    one_of_three = shell.slice_orthogonal()[1]
    assert drawn(render(shell, one_of_three, outline='none', axes='none', no_legend=True)) > 500


def test_a_slice_that_is_drawn_otherwise_is_cut_anew(shell):
    piece = shell.slice(**PLANE, array='s')
    for settings in (dict(contour='0.5 -0.5'), dict(vectors='lines', vector_lattice=6), dict(color_by='generation'),
                     dict(crinkle=True), dict(window=(1, 1))):
        wanted = {**PLANE, 'array': 's', **settings}
        assert np.array_equal(render(shell, piece, **settings), render(shell, **wanted)), settings
    other = vprobe.open('demo:tets:6')
    with pytest.raises(vprobe.UsageError, match='of this data set'):
        other.render(piece)
    frame = next(shell.sweep(draws=False, frames=3))
    with pytest.raises(vprobe.UsageError, match='of this data set'):
        shell.render(frame.cut[0])


def test_the_picture_is_that_of_the_program(shell, program, tmp_path):
    image = render(shell, **PLANE, no_legend=True, title='none')
    file = tmp_path / 'picture.png'
    program('render', 'demo:shell:16', '--normal', .3, .5, .8, '--size', '160x100', '--samples', 1, '--background',
            'white', '--no-legend', '--title', 'none', '-o', file)
    assert pixels_of(file.read_bytes()).tolist() == np.asarray(image)[..., :3].tolist()


def pixels_of(png):
    """The pixels of an opaque PNG without interlace."""
    width, height = (int.from_bytes(png[at:at + 4], 'big') for at in (16, 20))
    data, at = b'', 8
    while at < len(png):
        size = int.from_bytes(png[at:at + 4], 'big')
        if png[at + 4:at + 8] == b'IDAT':
            data += png[at + 8:at + 8 + size]
        at += 12 + size
    rows = np.frombuffer(zlib.decompress(data), np.uint8).reshape(height, 1 + 3 * width)
    image = np.zeros((height + 1, width + 1, 3), int)
    for y, (kind, row) in enumerate(zip(rows[:, 0], rows[:, 1:].reshape(height, width, 3).astype(int)), 1):
        for x, pixel in enumerate(row, 1):
            a, b, c = image[y, x - 1], image[y - 1, x], image[y - 1, x - 1]
            p = a + b - c
            pa, pb, pc = abs(p - a), abs(p - b), abs(p - c)
            paeth = np.where((pa <= pb) & (pa <= pc), a, np.where(pb <= pc, b, c))
            image[y, x] = (pixel + (0, a, b, (a + b) // 2, paeth)[kind]) % 256
    return image[1:, 1:]


def test_sweeps_give_pictures(shell):
    render(shell)
    frames = list(shell.sweep(vprobe.Probe.paddlewheel(3), path='revolve', frames=3, **SMALL))
    assert len(frames) == 3 and all(drawn(frame.image) > 1000 for frame in frames)
    assert not np.array_equal(frames[0].image, frames[1].image)


def test_ctrl_c_ends_drawing(shell):
    from test_work import assert_no_processor_works, interrupted_after
    data = vprobe.open('demo:tets:32')
    before = render(data)

    def draw_on():
        for _ in range(100):
            data.render(vprobe.Probe.stack(16), size=(2000, 2000))
    assert interrupted_after(.3, draw_on) < .4  # the device's threads draw on meanwhile
    used = time.process_time()
    repr(data)  # waits for the sample that is being drawn, not for the rest of a hundred pictures
    assert time.process_time() - used < 5
    assert_no_processor_works()
    assert np.array_equal(render(data), before)


def test_a_lost_device_raises_and_another_follows(tmp_path):
    layer = os.path.join(os.environ.get('VPROBE_BUILD', ''), 'tests/devices/layer')
    if not glob.glob(layer + '/*.so'):
        pytest.skip('the layer that lets calls of Vulkan fail is not built')
    render(vprobe.open('demo:shell:8'))
    code = '''
import vprobe
data = vprobe.open('demo:shell:8')
lost = 0
for _ in range(30):
    try:
        image = data.render(size=(64, 64), samples=1)
    except vprobe.DeviceError as error:
        lost += 1
        assert "\\n" not in str(error)
    except vprobe.OutOfMemoryError:
        pass
print(lost, data.slice().area > 0)
'''
    done = subprocess.run(
        [sys.executable, '-c', code], capture_output=True, text=True, check=False, timeout=120,
        env={**os.environ, 'VK_LAYER_PATH': layer, 'VK_INSTANCE_LAYERS': 'VK_LAYER_VPROBE_test',
             'VPROBE_LAYER_FAULT': 'lost:60'})
    assert done.returncode == 0, done.stderr
    lost, cuts = done.stdout.split()[-2:]
    assert int(lost) >= 1 and cuts == 'True', done.stdout


def test_a_viewer_shows_a_picture(shell):
    render(shell)
    view = shell.view(size=(120, 80), samples=1)
    assert view.image.shape == (80, 120, 4) and view._repr_png_().startswith(b'\x89PNG')
    assert 'vprobe.Viewer' in repr(view)


def test_sliders_change_the_picture(shell):
    pytest.importorskip('ipywidgets', reason='no ipywidgets')
    render(shell)
    view = shell.view(size=(120, 80), samples=1)
    seen = [view.picture.value]
    for control, value in ((view.position, 1.0), (view.elevation, 10.0), (view.azimuth, 40.0), (view.opacity, .5),
                           (view.array, 'v')):
        control.value = value
        assert view.picture.value != seen[-1], control.description
        seen.append(view.picture.value)
