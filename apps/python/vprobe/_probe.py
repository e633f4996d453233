"""Probes: sheets that move as one."""
from __future__ import annotations

import dataclasses
import json
import numbers
import os
from typing import TYPE_CHECKING, Any, Callable, Dict, List, Mapping, Optional, Sequence, Tuple, Union

from . import _core
from ._arguments import flag, number, path, several, text, whole, wrong
from ._arguments import text as words
from ._errors import InputError, UsageError

if TYPE_CHECKING:
    from ._dataset import Dataset

Vector = Sequence[float]


@dataclasses.dataclass(frozen=True)
class Sheet:
    """A sheet of a probe of one's own: a plane with a window, and what it shows.

    Parameters
    ----------
    origin, normal, up : sequence of 3 floats, optional
        Where the sheet stands in the probe, in the grid's units. By default it is the probe's plane z = 0.
    window : (float, float) or ((float, float), (float, float)), optional
        Width and height about the origin, or the ranges along x and y. By default the sheet covers the whole cut.
    magnification : float
        How much larger the sheet shows what it cuts, 1e-6 to 1e6.
    pan : sequence of 3 floats
        The point of the sheet that appears at its origin.
    surface : str, optional
        What cuts instead of the plane, such as ``"sphere:0.5"``.
    opacity : float, optional
        0 (clear) to 1.
    array, component, colormap : str, optional
        What the sheet shows, where that is not what all sheets show.
    range : (float, float), optional
        Of the colors.
    lines : int, optional
        About how many contour lines.
    hidden : bool
        Neither cut nor drawn.
    """

    origin: Optional[Vector] = None
    normal: Optional[Vector] = None
    up: Optional[Vector] = None
    window: Optional[Tuple[Any, Any]] = None
    magnification: float = 1.0
    pan: Vector = (0.0, 0.0, 0.0)
    surface: Optional[str] = None
    opacity: Optional[float] = None
    array: Optional[str] = None
    component: Optional[str] = None
    colormap: Optional[str] = None
    range: Optional[Tuple[float, float]] = None
    lines: Optional[int] = None
    hidden: bool = False

    def _json(self) -> Dict[str, Any]:
        sheet: Dict[str, Any] = {}
        frame = {key: list(several(getattr(self, key), key, 3)) for key in ('origin', 'normal', 'up')
                 if getattr(self, key) is not None}
        if frame:
            sheet['to_sheet'] = frame
        magnification, pan = number(self.magnification, 'magnification'), several(self.pan, 'pan', 3)
        if magnification != 1.0 or pan != (0.0, 0.0, 0.0):
            sheet['fx'] = {'magnification': magnification, 'pan': list(pan)}
        if self.window is not None:
            sheet['window'] = _window(self.window)
        for key in ('surface', 'array', 'component', 'colormap'):
            if getattr(self, key) is not None:
                sheet[key] = text(getattr(self, key), key)
        if self.opacity is not None:
            sheet['opacity'] = number(self.opacity, 'opacity')
        if self.lines is not None:
            sheet['lines'] = whole(self.lines, 'lines')
        if self.range is not None:
            sheet['range'] = list(several(self.range, 'range', 2))
        if flag(self.hidden, 'hidden'):
            sheet['hidden'] = True
        return sheet


def _window(window: Any) -> Union[List[float], Dict[str, List[float]]]:
    try:
        x, y = window
    except (TypeError, ValueError):
        raise wrong('window', window, 'a width and a height, or two ranges') from None
    if isinstance(x, numbers.Real):
        return list(several(window, 'window', 2))
    return {'x': list(several(x, 'window', 2)), 'y': list(several(y, 'window', 2))}


_SHAPES = ('single', 'trihedral', 'paddlewheel', 'stack')


class Probe:
    """Sheets that move as one: a built-in probe, or one's own.

    Make one by `single`, `trihedral`, `paddlewheel`, `stack`, `of`, `from_json` or `read`. A probe is a value: it does
    not change, and `moved` gives another.

    Examples
    --------
    >>> import vprobe
    >>> vprobe.Probe.paddlewheel(vanes=3, opacity=.6)
    <vprobe.Probe paddlewheel, vanes 3, opacity 0.6>
    """

    __slots__ = ('_settings', '_own')

    def __init__(self, settings: Mapping[str, Any], own: Optional[Mapping[str, Any]] = None) -> None:
        self._settings = {key: value for key, value in settings.items() if value is not None}
        self._own = None if own is None else dict(own)

    @classmethod
    def single(cls, *, origin: Optional[Vector] = None, normal: Union[str, Vector, None] = None,
               up: Union[str, Vector, None] = None, window: Optional[Tuple[float, float]] = None,
               opacity: Optional[float] = None) -> Probe:
        """One sheet.

        Parameters
        ----------
        origin : sequence of 3 floats, optional
            Of the hot spot, in the grid's units. By default the center of the bounds.
        normal, up : sequence of 3 floats or str, optional
            Directions of any length, or ``"x"``, ``"-z"`` and the like. By default z and y.
        window : (float, float), optional
            Width and height of each sheet. By default a sheet covers the whole cut.
        opacity : float, optional
            0 (clear) to 1, for every sheet.
        """
        return cls(dict(probe='single', origin=origin, normal=normal, up=up, window=window, opacity=opacity))

    @classmethod
    def trihedral(cls, *, origin: Optional[Vector] = None, normal: Union[str, Vector, None] = None,
                  up: Union[str, Vector, None] = None, window: Optional[Tuple[float, float]] = None,
                  opacity: Optional[float] = None) -> Probe:
        """Three sheets at right angles: to the probe's x axis, to up and to the normal. Parameters as of `single`."""
        return cls(dict(probe='trihedral', origin=origin, normal=normal, up=up, window=window, opacity=opacity))

    @classmethod
    def paddlewheel(cls, vanes: int = 3, *, origin: Optional[Vector] = None, normal: Union[str, Vector, None] = None,
                    up: Union[str, Vector, None] = None, window: Optional[Tuple[float, float]] = None,
                    opacity: Optional[float] = None) -> Probe:
        """Vanes (1 to 64) that meet along the up axis. Other parameters as of `single`."""
        return cls(dict(probe='paddlewheel', vanes=vanes, origin=origin, normal=normal, up=up, window=window,
                        opacity=opacity))

    @classmethod
    def stack(cls, sheets: Optional[int] = None, *, offsets: Optional[Sequence[float]] = None,
              origin: Optional[Vector] = None, normal: Union[str, Vector, None] = None,
              up: Union[str, Vector, None] = None, window: Optional[Tuple[float, float]] = None,
              opacity: Optional[float] = None) -> Probe:
        """Parallel sheets: `sheets` (1 to 64) spread evenly over the bounds, or at `offsets` along the normal.

        Other parameters as of `single`.
        """
        return cls(dict(probe='stack', sheets=sheets, offsets=offsets, origin=origin, normal=normal, up=up,
                        window=window, opacity=opacity))

    @classmethod
    def of(cls, sheets: Sequence[Sheet], *, name: Optional[str] = None, origin: Optional[Vector] = None,
           normal: Union[str, Vector, None] = None, up: Union[str, Vector, None] = None,
           opacity: Optional[float] = None) -> Probe:
        """A probe of one's own, of 1 to 64 sheets.

        Parameters
        ----------
        sheets : sequence of Sheet
            The sheets.
        name : str, optional
            For legends and lists.
        origin, normal, up, opacity
            As of `single`.
        """
        if not isinstance(sheets, Sequence) or not all(isinstance(sheet, Sheet) for sheet in sheets):
            raise wrong('sheets', sheets, 'a sequence of vprobe.Sheet')
        own: Dict[str, Any] = {'sheets': [sheet._json() for sheet in sheets]}
        if name is not None:
            own['name'] = text(name, 'name')
        return cls(dict(origin=origin, normal=normal, up=up, opacity=opacity), own)

    @classmethod
    def from_json(cls, text: str) -> Probe:
        """The probe of a probe file's text (docs/PROBES.md).

        Raises
        ------
        InputError
            Where the text is no such probe. The message names the place in it.
        """
        try:
            own = json.loads(words(text, 'text'))
        except (json.JSONDecodeError, RecursionError) as error:
            raise InputError(f'the probe is no JSON: {error}') from None
        if not isinstance(own, dict):
            raise InputError('the probe is no JSON object; docs/PROBES.md describes it')
        own.pop('$schema', None)
        probe = cls({}, own)
        _core.View().read(probe._state())  # says what does not fit
        return probe

    @classmethod
    def read(cls, file: Union[str, os.PathLike[str]]) -> Probe:
        """Reads a probe file, as the program's ``--probe`` takes it."""
        name = os.fsdecode(path(file, 'file'))
        try:
            with open(name, encoding='utf-8') as source:
                return cls.from_json(source.read())
        except (OSError, UnicodeDecodeError) as error:
            raise InputError(f'{name}: {error}') from None

    def moved(self, **settings: Any) -> Probe:
        """The same probe with other settings: `origin`, `normal`, `up`, `window`, `opacity` and what it was made with.

        Examples
        --------
        >>> import vprobe
        >>> vprobe.Probe.stack(5).moved(normal='x')
        <vprobe.Probe stack, sheets 5, normal x>
        """
        return Probe({**self._settings, **settings}, self._own)

    def to_json(self, data: Optional[Dataset] = None) -> str:
        """The text of a probe file, which the program's ``--probe`` takes.

        Parameters
        ----------
        data : Dataset, optional
            A built-in probe takes its place, and what else is not given, from a data set. One's own needs none.

        Raises
        ------
        UsageError
            A built-in probe, and no data set.
        """
        if data is not None:
            if not hasattr(data, '_core'):
                raise wrong('data', data, 'a vprobe.Dataset')
            return data._core.probe_text(data._view(self, {}))
        if self._own is None:
            raise UsageError('to_json: a built-in probe takes its place from a data set; give one')
        return json.dumps(self._own, indent='\t') + '\n'

    @property
    def shape(self) -> str:
        """``single``, ``trihedral``, ``paddlewheel``, ``stack`` or ``own``."""
        return 'own' if self._own is not None else str(self._settings['probe'])

    def _state(self) -> str:
        return json.dumps({'version': 1, 'probe': {'probe': self._own}})

    def _put(self, view: _core.View, put: Callable[[str, Any], None]) -> None:
        if self._own is not None:
            view.read(self._state())
        for key, value in self._settings.items():
            put(key, value)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Probe) and (self._settings, self._own) == (other._settings, other._own)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        words = [self.shape]
        if self._own is not None:
            words += [repr(self._own['name'])] if 'name' in self._own else []
            words.append(f'{len(self._own.get("sheets", []))} sheets')
        words += [f'{key} {value}' for key, value in self._settings.items() if key != 'probe']
        return f'<vprobe.Probe {", ".join(words)}>'
