"""Reading files."""
from __future__ import annotations

import os
from typing import Sequence, Union

from . import _core
from ._dataset import Dataset
from ._settings import Progress, listener

File = Union[str, 'os.PathLike[str]']


def open(files: Union[File, Sequence[File]], *, time: Union[str, float, None] = None, solution: str = '',
         refine: float = 0, displace: float = 0.0, format: str = '', inputs: str = 'auto', classify: str = 'auto',
         device: str = '', progress: Progress = None) -> Dataset:
    """Reads files, or makes a built-in data set.

    Parameters
    ----------
    files : path or sequence of paths
        Any input of the program, or ``"demo:NAME"``. Several make one data set of several blocks, or one series.
    time : float or str, optional
        A time (the nearest there is), ``"first"``, ``"last"`` or ``"#INDEX"``. By default the last.
    solution : str
        PLOT3D solution file, where its name does not follow from the grid's.
    refine : int or float
        How often the linear parts of curved cells are halved, 0 to 6. Between 0 and 1 a tolerance: slices refine the
        curved cells that they meet, until they are off by no more than this share of their size and of the
        range of the array that is shown.
    displace : float
        Points of Exodus files move by their displacements, times this.
    format : str
        A name that ``vprobe info --formats`` lists. By default the file tells.
    inputs : str
        ``blocks``: several files are one data set. ``times``: each is a time of a series. ``auto``: times if their
        names differ by a number alone and their grids are the same.
    classify : str
        ``auto``, ``cpu`` or ``gpu``: where cells are classified.
    device : str
        A part of the device's name, or its number. By default the best.
    progress : bool or callable, optional
        True prints what takes its time; a callable is given each such line.

    Returns
    -------
    Dataset

    Raises
    ------
    InputError
        Where a file cannot be used.

    Examples
    --------
    >>> import vprobe
    >>> vprobe.open('demo:shell:16')
    <vprobe.Dataset demo:shell:16: curvilinear, 4096 cells, s, v>
    """
    names = [os.fspath(files)] if isinstance(files, (str, os.PathLike)) else [os.fspath(each) for each in files]
    core = _core.Dataset.open(names, 'last' if time is None else str(time), solution, refine, displace, format,
                              inputs, classify, device, listener(progress))
    return Dataset(core, ' '.join(names))
