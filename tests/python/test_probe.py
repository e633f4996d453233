"""Probes, contours, particles, plans, samples, sweeps without pictures."""
import json

import numpy as np
import pytest

import vprobe
from conftest import lattice

Probe = vprobe.Probe


def test_builtin_probes(shell):
    assert len(shell.cut(Probe.single())) == 1
    assert len(shell.cut(Probe.trihedral(normal='x'))) == 3
    assert len(shell.cut(Probe.paddlewheel(5, opacity=.6))) == 5
    stack = shell.cut(Probe.stack(offsets=(-1, 0, 1), normal=(0, 0, 2), window=(1.5, 1), origin=(2, 1, 0)))
    assert [each.origin[2] for each in stack] == [-1, 0, 1]
    assert all(0 < each.area <= 1.5 + 1e-12 for each in stack)
    with pytest.raises(vprobe.UsageError, match='vanes'):
        shell.cut(Probe.paddlewheel(0))


def test_a_probe_is_a_value(shell):
    probe = Probe.stack(5)
    moved = probe.moved(normal='x')
    assert probe != moved and probe == Probe.stack(5) and moved.shape == 'stack'
    assert shell.cut(moved)[0].normal == (1, 0, 0) and shell.cut(probe)[0].normal == (0, 0, 1)


def test_ones_own_probe_is_a_probe_file(shell, tmp_path, program):
    lens = vprobe.Sheet(origin=(.5, .5, 0), magnification=5, pan=(0, 0, .25), window=(1, 1), array='v', component='z',
                        colormap='turbo', range=(-1, 1), lines=10)
    own = Probe.of([vprobe.Sheet(normal=(1, 0, 0), opacity=.6), vprobe.Sheet(normal=(0, 1, 0), window=((-1, 2), (0, 1))),
                    lens, vprobe.Sheet(hidden=True)], name='corner', origin=(2, 1, 0))
    cut = shell.cut(own)
    assert len(cut) == 3  # one is hidden
    file = tmp_path / 'probe.json'
    file.write_text(own.to_json())
    again = Probe.read(file)
    areas = [each.area for each in shell.cut(again.moved(origin=(2, 1, 0)))]
    assert areas == [each.area for each in cut]
    stats = json.loads(program('slice', 'demo:shell:16', '--probe', file, '--origin', 2, 1, 0, '--classify', 'cpu',
                               '--stats', '-'))
    assert [sheet['area'] for sheet in stats['sheets']] == areas
    assert Probe.from_json(own.to_json()).to_json() == own.to_json()


def test_a_builtin_probe_as_a_file_takes_its_place_from_the_data(shell, tmp_path):
    wheel = Probe.paddlewheel(3, normal=(.3, .5, .8))
    text = wheel.to_json(shell)
    assert [each.area for each in shell.cut(Probe.from_json(text))] == pytest.approx(
        [each.area for each in shell.cut(wheel)], rel=1e-12)
    with pytest.raises(vprobe.UsageError, match='data set'):
        wheel.to_json()
    for text, words in (('{', 'no JSON'), ('[]', 'no JSON object'), ('{"sheets": []}', 'sheets'),
                        ('{"sheets": [{"opacity": 7}]}', 'opacity')):
        with pytest.raises(vprobe.InputError, match=words):
            Probe.from_json(text)
    with pytest.raises(vprobe.InputError, match='absent.json'):
        Probe.read(tmp_path / 'absent.json')


def test_contours_grow_from_a_slice(shell):
    piece = shell.slice(normal='x', origin=(0, 1, 0), array='s')
    value = (piece.min + piece.max) / 2
    grown = shell.grow_contour(piece, value)
    assert grown.n_polygons > 0 and grown.value == value
    assert np.abs(grown['s'] - value).max() < 1e-4
    assert grown.area == pytest.approx(grown.copy().area)
    assert f'contour of {value:g}' in repr(grown)
    of_third = shell.grow_contour(shell.cut(Probe.trihedral(origin=(0, 1, 0)), array='s')[0], value)
    assert of_third.area == pytest.approx(grown.area, rel=.2)  # another window sets another depth
    with pytest.warns(vprobe.VprobeWarning), pytest.raises(vprobe.UsageError, match='no value 1000'):
        shell.grow_contour(piece, 1000)
    with pytest.raises(vprobe.UsageError, match='of this data set'):
        vprobe.open('demo:shell:8').grow_contour(piece, value)
    with pytest.raises(vprobe.UsageError, match='of this data set'):
        shell.grow_contour(piece.copy(), value)


def test_particles_start_on_a_slice():
    """A field of solid rotation about z: a particle keeps its distance from the axis."""
    points, _ = lattice(17, 17, 17)
    points = points * 2 - 1
    vectors = np.ascontiguousarray(np.stack([-points[..., 1], points[..., 0], 0 * points[..., 0]], axis=-1))
    data = vprobe.structured(points, {'v': vectors}, classify='cpu')
    traces = data.trace(data.slice(normal='x', origin=(.1, 0, 0), window=(.6, .6)), 'v', vector_lattice=6,
                        vector_steps=100, vector_dt=.02)
    assert len(traces) > 10
    for places, times in traces:
        distance = np.hypot(places[:, 0], places[:, 1])
        assert np.ptp(distance) < 2e-3 and np.ptp(places[:, 2]) < 1e-9
        assert (np.diff(times) > 0).all()
    assert traces.points.shape == (traces.offsets[-1], 3) and not traces.points.flags.writeable
    assert data.slice(normal='x', vectors='lines').flux == pytest.approx(0, abs=1e-9)


def test_figures_of_the_boundary():
    points, values = lattice(3, 4, 5)
    wind = np.ascontiguousarray(np.broadcast_to([1.0, 2.0, 3.0], (*values.shape, 3)))
    data = vprobe.structured(points, {'u': values, 'wind': wind}, classify='cpu')
    low, high = (data.slice(normal='z', origin=(.5, .5, z), array='u', vectors='lines', vector_array='wind')
                 for z in (0, 1))
    assert (low.area, high.area) == (0, pytest.approx(1)) and (low.boundary_area, high.boundary_area) == (pytest.approx(1), 0)
    assert low.boundary_mean == pytest.approx(1.5) and high.mean == pytest.approx(4.5)
    assert low.mean is None and high.boundary_mean is None
    assert low.boundary_flux == pytest.approx(3) and high.flux == pytest.approx(3)
    assert low.flux == 0 and high.boundary_flux == 0


def test_plans_tell_why(shell):
    rows = shell.plan(Probe.trihedral())
    assert [row.sheet for row in rows] == [0, 1, 2] and {row.strategy for row in rows} == {'spans'}
    assert 'curvilinear' in rows[0].reason and rows[0].classifier == 'cpu'
    tets = vprobe.open('demo:tets:8', classify='cpu')
    assert tets.plan(normal='x')[0].strategy == 'scan'
    tets.slice()
    assert tets.plan(normal='x')[0].strategy == 'cells'


def test_samples():
    points, values = lattice(6, 7, 8)
    data = vprobe.structured(points, {'p': values, 'q': points}, {'number': np.arange(5 * 6 * 7)}, classify='cpu')
    places = np.random.default_rng(5).random((50, 3))
    found = data.sample(np.vstack([places, [[2, 2, 2]]]))
    assert np.allclose(found['p'][:50], places @ (1, 2, 3)) and np.isnan(found['p'][50])
    assert np.allclose(found['q'][:50], places) and found['q'].shape == (51, 3)
    assert np.array_equal(found['number'][:50], found.cells[:50]) and found.cells[50] == found.blocks[50] == -1
    assert list(found) == ['p', 'q', 'number'] and list(data.sample(places, 'q')) == ['q']
    assert data.sample(np.zeros((0, 3)))['p'].shape == (0,)


def test_sweeps_without_pictures(shell):
    frames = list(shell.sweep(frames=10, draws=False))
    assert [frame.index for frame in frames] == list(range(10)) and {frame.count for frame in frames} == {10}
    heights = [frame.cut[0].origin[2] for frame in frames]
    assert np.allclose(np.diff(heights), (shell.bounds[5] - shell.bounds[4]) / 10)
    assert frames[0].image is None and frames[3].cut[0].area == pytest.approx(
        shell.slice(origin=(0, 1.5, heights[3])).area)
    turns = [frame.cut[0].normal for frame in shell.sweep(Probe.paddlewheel(3), path='revolve', frames=4, draws=False)]
    assert len(set(turns)) == 4
    early = shell.sweep(frames=10, draws=False)
    assert next(early).index == 0 and shell.slice().area > 0 and next(early).index == 1  # others may cut meanwhile
    with pytest.raises(vprobe.UsageError, match='path'):
        next(shell.sweep(path='times', draws=False))


def times_file(folder):
    """Two times of one grid, in files of VTK's and a list of them."""
    entries = ''
    for step in (0, 1):
        values = ' '.join(str(step * 10 + x) for z in range(3) for y in range(3) for x in range(3))
        (folder / f'step{step}.vti').write_text(
            '<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian"><ImageData WholeExtent="0 2 0 2 0 2" '
            'Origin="0 0 0" Spacing="1 1 1"><Piece Extent="0 2 0 2 0 2"><PointData><DataArray type="Float32" Name="p" '
            f'format="ascii">{values}</DataArray></PointData></Piece></ImageData></VTKFile>')
        entries += f'<DataSet timestep="{step}" file="step{step}.vti"/>'
    file = folder / 'steps.pvd'
    file.write_text(f'<VTKFile type="Collection" version="0.1"><Collection>{entries}</Collection></VTKFile>')
    return file


def test_sweeps_through_the_times_of_a_file(tmp_path):
    data = vprobe.open(times_file(tmp_path), time=0, classify='cpu')
    assert data.times == (0.0, 1.0)
    piece = data.slice()
    frames = list(data.sweep(path='times', draws=False))
    assert [frame.time for frame in frames] == [0.0, 1.0]
    assert [frame.cut[0].mean for frame in frames] == pytest.approx([1, 11])
    # Each cut has the arrays of its time, also where they are asked for later; the data set is at its own again.
    assert [frame.cut[0]['p'].max() for frame in frames] == [2, 12] and piece['p'].max() == 2
    assert data.slice().mean == pytest.approx(1) and data.sample([[2, 0, 0]])['p'][0] == 2
    assert vprobe.open(tmp_path / 'steps.pvd').slice().mean == pytest.approx(11)


def test_settings_of_the_program_are_keywords(shell, program):
    options = ('--probe', 'trihedral', '--seeds', 'boundary', '--component', 'y', '--array', 'v')
    stats = json.loads(program('slice', 'demo:shell:16', *options, '--classify', 'cpu', '--stats', '-'))
    cut = shell.cut(Probe.trihedral(), seeds='boundary', component='y', array='v')
    assert [each.mean for each in cut] == [sheet['mean'] for sheet in stats['sheets']]
