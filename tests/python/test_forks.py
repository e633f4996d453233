"""Forked processes: multiprocessing forks by default on Linux. Nothing there may wait for threads that are not there."""
import multiprocessing
import threading

import numpy as np
import pytest

import vprobe

PLANE = dict(normal=(.3, .5, .8))
SIZE = dict(size=(80, 60), samples=1)
SECONDS = 60  # far more than any of it takes


def in_child(work, how='fork'):
    """What `work` gives in a child: ('done', value) or ('error', kind, text). It fails where the child hangs."""
    context = multiprocessing.get_context(how)
    answers = context.Queue()

    def run():
        try:
            answers.put(('done', work()))
        except BaseException as error:  # pylint: disable=broad-except
            answers.put(('error', type(error).__name__, str(error)))
    child = context.Process(target=run)
    child.start()
    try:
        answer = answers.get(timeout=SECONDS)
        child.join(SECONDS)
        assert not child.is_alive(), 'the child has not ended'
        return answer
    except Exception as error:
        raise AssertionError(f'the child gave nothing within {SECONDS} s') from error
    finally:
        child.kill()
        child.join()


def figures(data):
    return [data.slice(normal=normal).area for normal in ((.3, .5, .8), 'x', 'y')]


@pytest.mark.parametrize('demo', ['shell:16', 'tets:24', 'mixed:8', 'blob:24'])
def test_slices_of_the_parents_data_set(demo):
    data = vprobe.open(f'demo:{demo}', classify='cpu')
    expected = figures(data)
    for _ in range(5):  # threads of the last call may be on their way to sleep
        kind, *rest = in_child(lambda: figures(data))
        assert kind == 'done' and rest[0] == pytest.approx(expected, rel=1e-12), rest
    assert figures(data) == pytest.approx(expected, rel=1e-12)  # the parent goes on


def test_slices_of_an_untouched_data_set_and_of_one_that_the_child_opens():
    data = vprobe.open('demo:tets:24', classify='cpu')
    assert in_child(lambda: len(figures(data)))[:2] == ('done', 3)
    assert in_child(lambda: vprobe.open('demo:shell:8', classify='cpu').slice().n_polygons > 0) == ('done', True)


def test_arrays_of_the_parents_slice():
    piece = vprobe.open('demo:shell:16', classify='cpu').slice(**PLANE)
    expected = piece.area
    kind, *rest = in_child(lambda: (piece.area, piece['s'].shape, piece.copy().n_points))
    assert (kind, rest[0]) == ('done', (expected, piece['s'].shape, piece.n_points))


def test_a_file_is_read_in_a_child(tmp_path):
    file = tmp_path / 'ramp.nrrd'
    file.write_bytes(b'NRRD0004\ntype: float\ndimension: 3\nsizes: 6 5 4\nencoding: raw\nendian: little\n\n'
                     + np.arange(120, dtype=np.float32).tobytes())
    assert in_child(lambda: vprobe.open(file).slice().n_polygons) == ('done', 20)


def test_a_picture_in_a_child_of_a_process_that_has_drawn_none():
    data = vprobe.open('demo:shell:8', classify='cpu')
    answer = in_child(lambda: in_child_shape(data))
    assert answer[0] == 'done' and answer[1] == (60, 80, 4) or 'get_context("spawn")' in answer[2], answer


def in_child_shape(data):
    return data.render(**SIZE).shape


def test_a_picture_in_a_child_of_a_process_that_has_drawn_is_refused_at_once():
    data = vprobe.open('demo:shell:8', classify='cpu')
    before = np.asarray(data.render(**SIZE))
    for _ in range(3):
        kind, error, text = in_child(lambda: in_child_shape(data))
        assert (kind, error) == ('error', 'DeviceError') and 'get_context("spawn")' in text and '\n' not in text
    # The same twice in one child, of another data set, and then a slice.
    other = vprobe.open('demo:tets:4', classify='cpu')

    def again():
        texts = []
        for each in (data, data, other):
            try:
                each.render(**SIZE)
            except vprobe.DeviceError as refused:
                texts.append(str(refused))
        return len(texts), other.slice().n_polygons > 0
    assert in_child(again) == ('done', (3, True))
    assert np.array_equal(np.asarray(data.render(**SIZE)), before)  # the parent draws on


def spawned(queue):
    queue.put(vprobe.open('demo:shell:8', classify='cpu').render(**SIZE).shape)


def test_the_remedy_works():
    vprobe.open('demo:shell:8', classify='cpu').render(**SIZE)
    context = multiprocessing.get_context('spawn')
    queue = context.Queue()
    child = context.Process(target=spawned, args=(queue,))
    child.start()
    try:
        assert queue.get(timeout=SECONDS) == (60, 80, 4)
    finally:
        child.join(SECONDS)


def test_a_pool_cuts():
    data = vprobe.open('demo:tets:16', classify='cpu')
    expected = [data.slice(normal=normal).area for normal in 'xyz']
    global shared  # a pool hands over names alone
    shared = data
    with multiprocessing.get_context('fork').Pool(2) as pool:
        assert pool.map_async(area_along, 'xyz').get(timeout=SECONDS) == pytest.approx(expected, rel=1e-12)


def area_along(normal):
    return shared.slice(normal=normal).area


def test_a_child_of_a_process_at_work_is_told():
    data = vprobe.open('demo:tets:48', classify='cpu')
    stop = threading.Event()

    def cut():
        while not stop.is_set():
            data.slice(**PLANE)
    thread = threading.Thread(target=cut)
    thread.start()
    try:
        for _ in range(3):
            answer = in_child(lambda: vprobe.open('demo:shell:4', classify='cpu').slice().n_polygons > 0)
            assert answer == ('done', True) or answer[1] == 'UsageError' and 'get_context("spawn")' in answer[2], answer
    finally:
        stop.set()
        thread.join()
    data.slice(**PLANE)
