"""Reading files."""
from __future__ import annotations

import numbers
import os
from typing import List, Optional, Sequence, Union

from . import _core
from ._arguments import flag, is_sequence, number, path, text, whole, wrong
from ._dataset import Dataset
from ._settings import Progress, listener

File = Union[str, 'os.PathLike[str]']


def _paths(given: Union[File, Sequence[File]], name: str, takes: str) -> List[bytes]:
    if isinstance(given, (str, os.PathLike)):
        given = [given]
    elif not is_sequence(given):
        raise wrong(name, given, takes)
    return [path(each, name) for each in given]


def open(files: Union[File, Sequence[File]], *, time: Union[str, float, None] = None, solution: str = '',
         refine: float = 0, displace: Optional[float] = None, displace_by: str = '', format: str = '', inputs: str = 'auto',
         classify: str = 'auto', device: str = '', cell_to_point: bool = False,
         follow: Union[File, Sequence[File]] = (), level: int = 0, progress: Progress = None) -> Dataset:
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
    displace : float, optional
        Points move by their displacements, times this. By default 0, or 1 with `displace_by`.
    displace_by : str
        The point array of displacements. By default one whose name says so.
    format : str
        A name that ``vprobe info --formats`` lists. By default the file tells.
    inputs : str
        ``blocks``: several files are one data set. ``times``: each is a time of a series. ``auto``: times if their
        names differ by a number alone and their grids are the same.
    classify : str
        ``auto``, ``cpu`` or ``gpu``: where cells are classified.
    device : str
        A part of the device's name, or its number. By default the best.
    cell_to_point : bool
        Arrays of cells become arrays of points: each point has the mean of its cells.
    follow : path or sequence of paths
        Files may name others in their own folder. These are further folders for that, or ``"anywhere"``; give them
        for data that you trust.
    level : int
        Of images that hold several resolutions (OME-Zarr): 0 is the finest.
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
    names = _paths(files, 'files', 'a file, or several in a sequence')
    if isinstance(time, numbers.Real) and not isinstance(time, bool):
        time = str(number(time, 'time'))
    core = _core.Dataset.open(
        names, 'last' if time is None else text(time, 'time', 'a time, "first", "last" or "#INDEX"'),
        path(solution, 'solution') if solution != '' else '', number(refine, 'refine'),
        None if displace is None else number(displace, 'displace'),
        text(displace_by, 'displace_by'), text(format, 'format'), text(inputs, 'inputs'), text(classify, 'classify'),
        text(device, 'device'), flag(cell_to_point, 'cell_to_point'),
        _paths(follow, 'follow', 'a folder, or several in a sequence'), whole(level, 'level'), listener(progress))
    return Dataset(core, ' '.join(map(os.fsdecode, names)))
