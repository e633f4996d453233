"""Volume Probes: cuts of volume data on any grid, after Speray and Kennon (1990).

>>> import vprobe
>>> data = vprobe.open('demo:shell:16')
>>> s = data.slice(normal=(.3, .5, .8), array='s')
>>> round(s.area, 2)
14.46
"""
from __future__ import annotations

from typing import Any

from ._arguments import flag, number, text
from ._answers import ArrayInfo, Block, Frame, Memory, PlanRow, Samples
from ._core import __version__
from ._dataset import Dataset
from ._errors import (CancelledError, DeviceError, Error, FoundError, InputError, InternalError, OutOfMemoryError,
                      OutputError, UsageError, VprobeWarning)
from ._grids import image, polyhedra, rectilinear, structured, unstructured
from ._open import open
from ._picture import Image
from ._probe import Probe, Sheet
from ._slice import Cut, Polygons, Slice
from ._traces import Traces

__all__ = [
    'ArrayInfo', 'Block', 'CancelledError', 'Cut', 'Dataset', 'DeviceError', 'Error', 'FoundError', 'Frame', 'Image',
    'InputError', 'InternalError', 'Memory', 'OutOfMemoryError', 'OutputError', 'PlanRow', 'Polygons', 'Probe',
    'Samples', 'Sheet', 'Slice', 'Traces', 'UsageError', 'VprobeWarning', '__version__', 'image', 'open', 'polyhedra',
    'rectilinear', 'structured', 'unstructured', 'wrap']


def wrap(mesh: Any, *, copy: bool = False, tolerance: float = 0.0, classify: str = 'auto',
         device: str = '') -> Dataset:
    """A data set that shares the arrays of a VTK data set or a PyVista mesh.

    Parameters
    ----------
    mesh : vtkDataSet, vtkMultiBlockDataSet or another composite data set, or a PyVista mesh
        What holds no volume, such as a vtkPolyData, is refused, or left out of a composite.
    copy : bool
        Arrays that cannot be shared are copied. If False, they raise InputError.
    tolerance : float, optional
        Between 0 and 1, of curved cells (quadratic, Lagrange, Bezier): slices refine those that they meet, until they
        are off by no more than this share of their size, and of the range of the array that is shown.
    classify, device : str
        As of `open`.

    Returns
    -------
    Dataset

    Raises
    ------
    InputError
        One line says what cannot be used, and why.

    Notes
    -----
    Do not resize an array while a data set or a slice shares it. After changing values in place, call
    `Dataset.modified`.
    """
    from ._vtk_grids import wrap_vtk
    return wrap_vtk(mesh, flag(copy, 'copy'), number(tolerance, 'tolerance'), text(classify, 'classify'),
                    text(device, 'device'))
