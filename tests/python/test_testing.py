"""vprobe.testing: pictures and figures as they are expected, and faults that are found."""
import json

import pytest

import vprobe
import vprobe.testing
from vprobe.testing import assert_figures, assert_picture


def test_figures_of_a_file_and_of_a_dictionary(shell, tmp_path, monkeypatch):
    piece = shell.slice(normal='x', array='s')
    file = tmp_path / 'x.json'
    monkeypatch.setenv('VPROBE_UPDATE', '1')
    assert_figures(piece, file)
    monkeypatch.delenv('VPROBE_UPDATE')
    assert_figures(piece, file)
    assert_figures(piece, {'area': piece.area, 'cut_cells': piece.cut_cells})
    assert_figures(piece, {'area': piece.area * 1.001}, relative=0.01)
    with pytest.raises(AssertionError, match=r'figures: area is .*, expected'):
        assert_figures(piece, {'area': piece.area * 1.001})
    with pytest.raises(AssertionError, match='nothing is missing'):
        assert_figures(piece, {'nothing': 1.0})
    wanted = json.loads(file.read_text())
    wanted['sheets'][0]['cut_cells'] += 1
    file.write_text(json.dumps(wanted))
    with pytest.raises(AssertionError, match=r'x.json: sheets\[0\].cut_cells is'):
        assert_figures(piece, file)
    with pytest.raises(vprobe.UsageError, match='cut: takes a Slice'):
        assert_figures(3, file)


def test_figures_of_the_program_are_expected_of_a_slice(shell, sheet_of):
    piece = shell.slice(normal=(.3, .5, .8), array='s')
    of_program = sheet_of('demo:shell:16', '--normal', '0.3', '0.5', '0.8', '--array', 's')
    assert_figures(piece, {key: of_program[key] for key in ('area', 'mean', 'min', 'max', 'cut_cells', 'components')})


@pytest.mark.gpu
def test_pictures(shell, tmp_path, monkeypatch):
    drawn = shell.render(normal='x', size=(160, 120))
    file, difference = tmp_path / 'x.png', tmp_path / 'difference.png'
    monkeypatch.setenv('VPROBE_UPDATE', '1')
    assert_picture(drawn, file)
    monkeypatch.delenv('VPROBE_UPDATE')
    assert_picture(drawn, file, difference=difference)
    assert not difference.exists()
    other = shell.render(normal='x', size=(160, 120), colormap='turbo')
    with pytest.raises(AssertionError, match='x.png: is not as drawn: similarity'):
        assert_picture(other, file, difference=difference)
    assert difference.exists()
    with pytest.raises(vprobe.Error, match='160'):
        assert_picture(shell.render(normal='x', size=(170, 120)), file)
    with pytest.raises(vprobe.UsageError, match='picture: takes an Image'):
        assert_picture(None, file)
