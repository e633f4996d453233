"""Wrong arguments of every kind: one line that names the argument, whatever is called with whatever."""
import inspect
import os
import pathlib
import warnings

import numpy as np
import pytest

import vprobe
from conftest import hexahedra, lattice

ODD = [None, True, 5, -1, 2 ** 40, 1.5, float('nan'), float('inf'), 1j, '', 'none', 'a\nb', '\ud800', b'bytes', [], (), {},
       [1, 2], (1, 2, 3), ['x', 'y'], [[1], [2, 3]], {'p': 1}, {1: 2}, np.array([]), np.zeros((2, 2)), np.array('text'),
       np.array([object()]), np.zeros(3, complex), object(), print, int, ...]
# Arguments that take a function.
ENDLESS = {'progress'}


class Wrong(str):
    """What was raised, and by which call."""


def told(error, name):
    """What is wrong with an error; nothing if it is as it should be."""
    words = str(error)
    if not isinstance(error, (vprobe.Error, TypeError)):
        return f'{type(error).__name__}: {words}'
    if '\n' in words or not words:
        return f'not one line: {words!r}'
    names = (name, name.replace('_', '-'), *{'n': ('sheets',), 'axis': ('normal',), 'piece': ('takes a slice',),
                                              'surface': ('iso',), 'mesh': ('data set',), 'point_data': ('array',),
                                              'cell_data': ('array',), 'points': ('connectivity', 'cell'),
                                              'types': ('cell ', 'offsets', 'tolerance'),
                                              'cells': ('offsets', 'connectivity', 'cell ', 'face_'),
                                              'dimensions': ('array', 'points'), 'files': ('no such file', 'file'),
                                              'text': ('probe',), 'tolerance': ('quadratic',), 'size': ('picture',),
                                              'kind': ('vectors',), 'array': ('no array',), 'arrays': ('array',), 'displace_by': ('`displace`',),
                                              'window': ('sheets',), 'sheets': ('probe',),
                                              'range': ('ranges',), 'frames': ('path',),
                                              'path': ('frames', 'times')}.get(name, ()))
    return None if any(each in words for each in names) else f'{name} is not named: {words}'


def tried(call, arguments, names):
    """Calls with one odd argument at a time, and gives what is not as it should be."""
    found = []
    for name in names:
        for odd in ODD:
            if name in ENDLESS and (odd is print or odd is int):
                continue
            try:
                with warnings.catch_warnings():
                    warnings.simplefilter('ignore')
                    made = call(**{**arguments, name: odd})
                    if inspect.isgenerator(made):
                        next(made, None)
            except Exception as error:  # pylint: disable=broad-except
                if why := told(error, name):
                    found.append(f'{getattr(call, "__qualname__", call)}({name}={odd!r}): {why}')
    return found


def names_of(call):
    return [name for name, parameter in inspect.signature(call).parameters.items()
            if parameter.kind not in (parameter.VAR_KEYWORD, parameter.VAR_POSITIONAL) and name != 'self']


@pytest.fixture(scope='module')
def small():
    return vprobe.open('demo:shell:4', classify='cpu')


def test_making_a_data_set(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    points, values = lattice(3, 3, 3)
    flat = points.reshape(-1, 3)
    cells = hexahedra(3, 3, 3)
    face = [[[0, 1, 4, 3], [9, 10, 13, 12], [0, 1, 10, 9], [1, 4, 13, 10], [4, 3, 12, 13], [3, 0, 9, 12]]]
    found = tried(vprobe.open, dict(files='demo:shell:2', classify='cpu'), names_of(vprobe.open))
    for call, arguments in ((vprobe.image, dict(point_data={'p': values})),
                            (vprobe.rectilinear, dict(x=[0, 1], y=[0, 1], z=[0, 1])),
                            (vprobe.structured, dict(points=points)),
                            (vprobe.unstructured, dict(points=flat, cells=cells, types='hexahedron')),
                            (vprobe.polyhedra, dict(points=flat, cells=face))):
        found += tried(call, arguments, [*names_of(call), 'classify', 'device'])
        with pytest.raises(vprobe.UsageError, match="no argument 'clasify'"):
            call(**arguments, clasify='cpu')
    assert not found, '\n'.join(found)


def test_wrapping():
    image = pytest.importorskip('vtkmodules.vtkCommonDataModel', reason='no VTK for Python').vtkImageData()
    image.SetDimensions(3, 3, 3)
    found = tried(vprobe.wrap, dict(mesh=image), names_of(vprobe.wrap))
    assert not found, '\n'.join(found)


def test_methods_of_a_data_set(small):
    piece = small.slice(array='s')
    arguments = {'block': {}, 'cut': {}, 'slice': {}, 'slice_along_axis': {}, 'isosurface': dict(value=.5),
                 'grow_contour': dict(piece=piece, value=float(piece.mean)), 'trace': dict(piece=piece), 'plan': {},
                 'sample': dict(points=[[0, 2, 0]]), 'sweep': dict(frames=2, draws=False)}
    found = []
    for name, given in arguments.items():
        call = getattr(small, name)
        found += tried(call, given, names_of(call))
    assert not found, '\n'.join(found)


def test_pictures(small, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    image = small.render(size=(32, 24), samples=1)
    # A picture of many pixels would take long.
    found = tried(lambda probe=None: small.render(probe, size=(32, 24), samples=1), {}, ['probe'])
    for odd in ODD:
        if odd is None or isinstance(odd, (list, tuple)) and len(odd) == 2:
            continue
        try:
            small.render(size=odd, samples=1)
        except Exception as error:  # pylint: disable=broad-except
            found += [f'render(size={odd!r}): {why}'] if (why := told(error, 'size')) else []
    found += tried(image.save, {}, ['file'])
    assert not found, '\n'.join(found)


def test_settings(small):
    found = []
    for name in ('normal', 'origin', 'window', 'array', 'lines', 'seeds', 'camera', 'opacity', 'no_such_setting'):
        found += tried(lambda **settings: small.cut(**settings), {}, [name])
    assert not [each for each in found if 'no_such_setting=None' not in each], '\n'.join(found)


def test_slices_cuts_and_traces(small, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    found = []
    own = small.slice().copy()
    for thing in (small.slice(), own, small.cut()):
        found += tried(thing.save, {}, ['file'])
    for odd in ODD:
        for get in (own.__getitem__, small.__getitem__):
            try:
                get(odd)
                found.append(f'[{odd!r}] gave something')
            except (KeyError, TypeError) as error:
                found += [f'[{odd!r}]: {error}'] if '\n' in str(error) else []
        try:
            small.cut()[odd]
        except (IndexError, TypeError) as error:
            found += [f'cut[{odd!r}]: {error}'] if '\n' in str(error) else []
        for put in (own.__setitem__, small.__setitem__):
            for name, values in ((odd, np.zeros(3)), ('a', odd)):
                try:
                    put(name, values)
                    found.append(f'[{name!r}] = {values!r} was taken')
                except (vprobe.Error, TypeError) as error:
                    found += [f'[{name!r}] = {values!r}: {error}'] if '\n' in str(error) else []
    assert not found, '\n'.join(found)


def test_probes(small, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    kinds = {'single': {}, 'trihedral': {}, 'paddlewheel': {}, 'stack': {}, 'of': dict(sheets=[vprobe.Sheet()])}
    found = []
    for kind, given in kinds.items():
        make = getattr(vprobe.Probe, kind)

        def use(make=make, **arguments):
            return small.cut(make(**arguments))
        found += tried(use, given, names_of(make))

    def with_sheet(**arguments):
        return small.cut(vprobe.Probe.of([vprobe.Sheet(**arguments)]))
    found += tried(with_sheet, {}, names_of(vprobe.Sheet))
    found += tried(vprobe.Probe.from_json, {}, ['text'])
    found += tried(vprobe.Probe.read, {}, ['file'])
    found += tried(vprobe.Probe.trihedral().to_json, {}, ['data'])
    assert not found, '\n'.join(found)


def test_every_public_method_is_tried():
    """A method that is added has to be added above, too."""
    tried_here = pathlib.Path(__file__).read_text(encoding='utf-8')
    no_arguments = {'memory', 'modified', 'copy', 'to_vtk', 'to_pyvista', 'png', 'keys', 'moved', 'view', 'render',
                    'slice_orthogonal'}
    for thing in (vprobe.Dataset, vprobe.Slice, vprobe.Cut, vprobe.Probe, vprobe.Image, vprobe.Traces):
        for name, member in inspect.getmembers(thing):
            is_own = not name.startswith('_') and '__module__' in dir(member) and callable(member) and str(
                getattr(member, '__module__', '')).startswith('vprobe')
            if is_own and name not in no_arguments:
                assert f"'{name}'" in tried_here or f'.{name}' in tried_here, f'{thing.__name__}.{name}'


def test_files_need_not_have_names_of_utf8(small, tmp_path):
    name = os.fsencode(tmp_path) + b'/\xff.vtp'
    small.slice().save(os.fsdecode(name))
    assert os.path.getsize(name) > 100
    with pytest.raises(vprobe.InputError) as raised:
        vprobe.open(os.fsdecode(os.fsencode(tmp_path) + b'/\xfe\n.vtu'))
    assert '\n' not in str(raised.value)


def test_files_may_name_others_where_it_is_allowed(tmp_path):
    for folder in ('data', 'far'):
        (tmp_path / folder).mkdir()
    (tmp_path / 'far/a.raw').write_bytes(b'12345678')
    head = tmp_path / 'data/a.mhd'
    head.write_text('ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementType = MET_UCHAR\n'
                    'ElementDataFile = ../far/a.raw\n')
    assert vprobe.open(head, follow=[tmp_path / 'far']).n_cells == 1
    assert vprobe.open(head, follow='anywhere').n_cells == 1
    with pytest.raises(vprobe.UsageError, match='no such folder; name one, or anywhere'):
        vprobe.open(head, follow=tmp_path / 'nowhere')
    try:  # of the one call alone
        vprobe.open(head)
    except vprobe.InputError as error:
        assert '--follow' in str(error)
    else:
        pytest.skip('this system has no Landlock')
