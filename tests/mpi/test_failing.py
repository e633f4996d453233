"""A rank that fails ends all soon, with one line, and leaves nothing half-written."""
import subprocess
import time

import numpy as np
import pytest

import pieces
from conftest import own_lines


@pytest.fixture
def case(tmp_path):
    grid = pieces.tetrahedra(5)
    return pieces.write_pvtu(tmp_path, grid, pieces.slabs(grid, 4))


def fails(programs, ranks, *arguments):
    began = time.monotonic()
    done = programs.run(ranks, *arguments)
    assert time.monotonic() - began < 10
    assert done.returncode != 0
    lines = own_lines(done.stderr)
    assert len(lines) == 1, done.stderr
    return lines[0]


def test_a_missing_piece(programs, case, tmp_path):
    (tmp_path / 'piece2.vtu').unlink()
    assert 'piece2.vtu cannot be opened; keep them together' in fails(programs, 4, 'slice', case)


def test_a_damaged_piece_names_the_rank_that_reads_it(programs, case, tmp_path):
    piece = tmp_path / 'piece2.vtu'
    held = bytearray(piece.read_bytes())
    held[len(held) // 2:len(held) // 2 + 64] = bytes(64)  # amid compressed arrays; its head and its end are whole
    piece.write_bytes(held)
    out = tmp_path / 'out.vtp'
    assert 'rank 2: ' in fails(programs, 4, 'slice', case, '-o', out)
    assert not out.exists()


@pytest.mark.parametrize('change', ['no file', 'array', 'kind'])
def test_a_piece_that_the_index_describes_otherwise(programs, case, tmp_path, change):
    """One process and several refuse it in the same words."""
    if change == 'no file':
        case.write_text(case.read_text().replace('Source="piece2.vtu"', ''))
    elif change == 'array':
        case.write_text(case.read_text().replace('<PPointData>',
                                                 '<PPointData><PDataArray type="Float64" Name="w"/>'))
    else:
        image = pieces.vtk.vtkImageData()
        image.SetDimensions(3, 3, 3)
        pieces.add_arrays(image, np.array([image.GetPoint(i) for i in range(27)]))
        pieces.write(pieces.vtk.vtkXMLImageDataWriter(), image, tmp_path / 'piece2.vti')
        case.write_text(case.read_text().replace('piece2.vtu', 'piece2.vti'))
    words = {'no file': 'one of its <Piece> elements names no file; give it the attribute Source',
             'array': 'has no point array w, which the index names; write it there',
             'kind': 'its piece piece2.vti is no UnstructuredGrid, as the index says'}[change]
    assert words in fails(programs, 3, 'slice', case)
    plain = subprocess.run([programs.program, 'slice', case], capture_output=True, encoding='utf-8', check=False)
    assert plain.returncode == 2 and words in plain.stderr


def test_an_array_that_no_block_has(programs, case):
    line = fails(programs, 3, 'slice', case, '--array', 'nothing')
    assert 'nothing: no such array; there are: point:s, point:v, cell:c' in line


def test_a_place_that_cannot_be_written(programs, case, tmp_path):
    blocked = tmp_path / 'file'
    blocked.write_text('')
    fails(programs, 3, 'slice', case, '-o', blocked / 'out.vtp')


@pytest.mark.parametrize('asked', [('--surface', 'patch=wall'), ('--strategy', 'generations'),
                                   ('--seeds', 'boundary', '--window', 0.5, 0.5), ('--vectors', 'lines', '--path-lines'),
                                   ('-o', 'flat.png')])
def test_what_is_refused_names_the_remedy(programs, case, asked):
    assert 'vprobe' in fails(programs, 2, 'slice', case, *asked).removeprefix('vprobe-mpi: ')


def test_labels_on_lines_are_refused(programs, case):
    assert 'add --no-labels' in fails(programs, 2, 'render', case, '--lines', 8, '-o', 'out.png')


def test_cells_of_different_sizes_between_ranks(programs, tmp_path):
    for number, (spacing, origin) in enumerate([(0.25, 0.0), (0.5, 1.0)]):
        image = pieces.vtk.vtkImageData()
        image.SetDimensions(*[round(1 / spacing) + 1] * 3)
        image.SetSpacing(spacing, spacing, spacing)
        image.SetOrigin(origin, 0.0, 0.0)
        pieces.write(pieces.vtk.vtkXMLImageDataWriter(), image, tmp_path / f'block{number}.vti')
    blocks = [tmp_path / f'block{number}.vti' for number in range(2)]
    programs.mpi(1, 'slice', *blocks, '--normal', 0.1, 0.2, 0.9)
    assert 'cells of different sizes meet' in fails(programs, 2, 'slice', *blocks, '--normal', 0.1, 0.2, 0.9)


def test_an_unknown_option(programs, case):
    assert 'see vprobe-mpi slice --help' in fails(programs, 3, 'slice', case, '--nonsense')
