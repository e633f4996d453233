"""Settings of a cut and its picture, from Python values to those of the library."""
from __future__ import annotations

import numbers
import sys
from typing import Any, Callable, Dict, Mapping, Optional, Union

import numpy as np

from . import _core
from ._arguments import shown, text, wrong
from ._errors import UsageError
from ._probe import Probe

Progress = Union[bool, Callable[[str], Any], None]


def text_of(value: Any, key: str) -> str:
    """Writes a value as a state file and a command line have it: several numbers with blanks between them."""
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value.item()
    if isinstance(value, str):
        return text(value, key)
    if isinstance(value, (bool, np.bool_)):
        return 'true' if value else 'false'
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        return repr(float(value))
    if isinstance(value, (list, tuple, np.ndarray)):
        return ' '.join(text_of(each, key) for each in value)
    raise wrong(key, value, 'a text, a number, True, False, or several of them')


def put(view: _core.View, key: str, value: Any) -> None:
    """Sets one setting; None leaves it as it is."""
    if value is None or key == 'origin' and isinstance(value, str) and value == 'center':
        return
    if isinstance(value, (tuple, list)) and key in ('size', 'camera'):
        value = ('x' if key == 'size' else ',').join(text_of(each, key) for each in value)
    view.set(text(key, 'settings'), text_of(value, key))


def view_of(probe: Optional[Probe] = None, settings: Optional[Mapping[str, Any]] = None) -> _core.View:
    """Makes the library's view of a probe and of settings by their keys. Settings that are None stay as they are."""
    view = _core.View()
    given: Dict[str, Any] = dict(settings or {})
    if probe is not None:
        if not isinstance(probe, Probe):
            raise UsageError(f'probe: {shown(probe)} is no probe; make one by vprobe.Probe, or read its file')
        probe._put(view, lambda key, value: put(view, key, value))
    for key, value in given.items():
        put(view, key, value)
    return view


def listener(progress: Progress) -> Optional[Callable[[str], Any]]:
    """What is called with each line of progress, if anything."""
    if progress is True:
        return lambda line: print(f'vprobe: {line}', file=sys.stderr)
    if progress is None or progress is False:
        return None
    if not callable(progress):
        raise wrong('progress', progress, 'True, False, or what is called with each line')
    return progress
