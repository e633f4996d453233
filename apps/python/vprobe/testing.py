"""Assertions for tests of pictures and figures, such as those of pytest.

>>> import vprobe, vprobe.testing
>>> data = vprobe.open('demo:shell:16')
>>> vprobe.testing.assert_figures(data.slice(normal='x', array='s'), {'area': 11.25}, relative=1e-3)

With VPROBE_UPDATE=1 in the environment, what is expected is written instead of compared.
"""
from __future__ import annotations

import json
import os
import pathlib
from typing import Any, Dict, Mapping, Optional, Union

import numpy as np

from . import _core
from ._errors import UsageError
from ._picture import Image
from ._slice import Cut, Slice

__all__ = ['assert_figures', 'assert_picture']

_Path = Union[str, 'os.PathLike[str]']
_FIGURES = ('area', 'boundary_area', 'nan_area', 'mean', 'min', 'max', 'boundary_mean', 'flux', 'boundary_flux',
            'components', 'cut_cells')


def _updates() -> bool:
    return os.environ.get('VPROBE_UPDATE', '') not in ('', '0')


def assert_picture(picture: Image, expected: _Path, *, similarity: float = 0.95, mean: float = 1.5,
                   difference: Optional[_Path] = None) -> None:
    """Passes if a picture looks like the one in a file, whatever driver drew either.

    Parameters
    ----------
    picture : Image
        As `Dataset.render` gives it.
    expected : str or path
        A PNG of the same size.
    similarity, mean : float
        The limits: of the structure, at least, and of the mean difference of a channel, at most, of 255 levels. Both
        hold for the worst tile. The defaults are those of ``vprobe verify`` for eight samples a pixel.
    difference : str or path, optional
        Where to draw the difference if there is one.

    Raises
    ------
    AssertionError
        The picture differs; the message has both figures and their places.
    InputError
        The expected picture cannot be read.
    """
    if not isinstance(picture, np.ndarray):
        raise UsageError(f'picture: takes an Image, as render() gives it, not {type(picture).__name__}')
    picture = picture.view(Image)
    if _updates():
        picture.save(expected)
        return
    picture.png()  # whether it is one
    found = _core.difference(np.ascontiguousarray(picture), os.fspath(expected))
    if found[0] >= similarity and abs(found[1]) <= mean:
        return
    if difference is not None:
        _core.save_difference(np.ascontiguousarray(picture), os.fspath(expected), os.fspath(difference))
    raise AssertionError(f'{os.fspath(expected)}: is not as drawn: {found[2]}')


def _figures_of(given: Union[Slice, Cut]) -> Dict[str, Any]:
    sheets = [given] if isinstance(given, Slice) else list(given)
    return {'sheets': [{name: getattr(sheet, name) for name in _FIGURES if getattr(sheet, name) is not None}
                       for sheet in sheets]}


def _moved(expected: Any, found: Any, place: str, relative: float, absolute: float) -> Optional[str]:
    if isinstance(expected, Mapping):
        for key, value in expected.items():
            where = f'{place}.{key}' if place else str(key)
            if not isinstance(found, Mapping) or key not in found:
                return f'{where} is missing, expected {value}'
            moved = _moved(value, found[key], where, relative, absolute)
            if moved:
                return moved
        return None
    if isinstance(expected, list):
        if len(expected) != len(found):
            return f'{place} has {len(found)} entries, expected {len(expected)}'
        for number, (value, other) in enumerate(zip(expected, found)):
            moved = _moved(value, other, f'{place}[{number}]', relative, absolute)
            if moved:
                return moved
        return None
    may = max(absolute, relative * abs(expected)) if isinstance(expected, float) else 0.0
    return None if expected == found or abs(found - expected) <= may else f'{place} is {found}, expected {expected}'


def assert_figures(cut: Union[Slice, Cut], expected: Union[_Path, Mapping[str, Any]], *, relative: float = 1e-6,
                   absolute: float = 1e-9) -> None:
    """Passes if a cut has the figures that are expected of it.

    Parameters
    ----------
    cut : Slice or Cut
        The slice of one sheet, or the cut of a probe.
    expected : path or dict
        ``{'area': 14.5}`` for one sheet, or ``{'sheets': [{'area': 14.5}]}``, or a JSON file of such. Only the keys
        that stand there are compared: those of `Slice`, from ``area`` to ``cut_cells``.
    relative, absolute : float
        Numbers with a point may differ by the larger of both. Whole numbers must be equal.

    Raises
    ------
    AssertionError
        A figure differs; the message names it.
    """
    if not isinstance(cut, (Slice, Cut)):
        raise UsageError(f'cut: takes a Slice or a Cut, not {type(cut).__name__}')
    found = _figures_of(cut)
    if isinstance(expected, Mapping):
        wanted, name = dict(expected), 'figures'
    else:
        file = pathlib.Path(expected)
        if _updates():
            file.write_text(json.dumps(found, indent=1) + '\n')
            return
        wanted, name = json.loads(file.read_text()), os.fspath(expected)
    if 'sheets' not in wanted:
        found = found['sheets'][0]
    moved = _moved(wanted, found, '', relative, absolute)
    if moved:
        raise AssertionError(f'{name}: {moved}')
