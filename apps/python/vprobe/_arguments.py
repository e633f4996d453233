"""Looks at arguments: one that cannot be is an error of one line that names it."""
from __future__ import annotations

import numbers
import os
from typing import Any, List, Mapping, Optional, Sequence, Tuple

import numpy as np

from ._errors import InputError, UsageError

_LONGEST = 60  # characters of a value in a message


def shown(value: Any) -> str:
    """The value on one line, cut short."""
    words = ' '.join(repr(value).split())
    return words if len(words) <= _LONGEST else words[:_LONGEST - 3] + '...'


def wrong(name: str, value: Any, takes: str) -> UsageError:
    """The error for an argument that is of another kind."""
    return UsageError(f'{name}: {shown(value)} cannot be; it takes {takes}')


def text(value: Any, name: str, takes: str = 'a text') -> str:
    """A text, which the library takes as UTF-8."""
    if not isinstance(value, str):
        raise wrong(name, value, takes)
    try:
        value.encode('utf-8')
    except UnicodeEncodeError:
        raise wrong(name, value, 'a text of valid characters') from None
    return str(value)


def flag(value: Any, name: str) -> bool:
    """True or False; 0 and 1 are taken for them."""
    if isinstance(value, (bool, np.bool_)) or isinstance(value, numbers.Integral) and value in (0, 1):
        return bool(value)
    raise wrong(name, value, 'True or False')


def number(value: Any, name: str) -> float:
    """A finite number."""
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, numbers.Real) or not np.isfinite(float(value)):
        raise wrong(name, value, 'a finite number')
    return float(value)


def whole(value: Any, name: str) -> int:
    """A whole number that fits into 32 bits."""
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, numbers.Integral) or abs(int(value)) >= 2 ** 31:
        raise wrong(name, value, 'a whole number')
    return int(value)


def several(value: Any, name: str, count: Optional[int] = None) -> Tuple[float, ...]:
    """Finite numbers, `count` of them."""
    takes = 'finite numbers in a sequence' if count is None else f'{count} finite numbers'
    if isinstance(value, (str, bytes, Mapping)):
        raise wrong(name, value, takes)
    try:
        values = tuple(number(each, name) for each in value)
    except (TypeError, UsageError):
        raise wrong(name, value, takes) from None
    if count is not None and len(values) != count:
        raise wrong(name, value, takes)
    return values


def path(value: Any, name: str) -> bytes:
    """The name of a file, as the system has it."""
    if not isinstance(value, (str, os.PathLike)):
        raise wrong(name, value, 'the name of a file, as str or os.PathLike')
    try:
        plain = os.fsencode(value)
    except (TypeError, UnicodeEncodeError):
        raise wrong(name, value, 'the name of a file, as str or os.PathLike') from None
    if not plain or b'\0' in plain:
        raise wrong(name, value, 'the name of a file')
    return plain


def is_sequence(value: Any) -> bool:
    """Whether it has elements, and is neither a text nor a mapping."""
    if isinstance(value, (str, bytes, Mapping)):
        return False
    try:
        iter(value)
    except TypeError:
        return False
    return True


def texts(value: Any, name: str) -> List[str]:
    """One text, or several."""
    if isinstance(value, str):
        return [text(value, name)]
    if not is_sequence(value):
        raise wrong(name, value, 'a text, or several')
    return [text(each, name, 'a text, or several') for each in value]


def arrays(value: Any, name: str) -> Mapping[str, Any]:
    """Arrays by their names."""
    if value is None:
        return {}
    if not isinstance(value, Mapping):
        raise InputError(f'{name}: {shown(value)} cannot be; it takes a mapping of names to arrays')
    for key in value:
        text(key, name, 'names that are texts')
    return value


def options(given: Mapping[str, Any], known: Sequence[str], where: str) -> None:
    """UsageError for a keyword that is none of these."""
    for key in given:
        if key not in known:
            raise UsageError(f'{where}: there is no argument {key!r}; besides those of its signature it takes '
                             f'{" and ".join(known)}')
