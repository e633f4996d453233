"""Arrays that mask some of their values, as those of numpy.ma do: whatever has a `mask`."""
from __future__ import annotations

from typing import Any, Optional, Tuple

import numpy as np
import numpy.typing as npt

from ._arguments import shown
from ._errors import InputError

Array = npt.NDArray[Any]


def mask_of(given: Any, name: str) -> Optional[Array]:
    """Where an array is masked, in its shape; None if it has no mask, or masks nothing."""
    mask = getattr(given, 'mask', None)
    if mask is None or callable(mask):  # pandas has a method of that name
        return None
    marks = np.asarray(mask)
    if marks.dtype.kind not in 'biu' or not marks.any():
        return None
    shape = np.shape(given)
    if marks.shape == shape[:-1]:
        marks = marks[..., None]  # all components of a tuple
    try:
        return np.broadcast_to(marks, shape).astype(bool, copy=False)
    except ValueError:
        raise InputError(f'{name}: its mask has the shape {marks.shape}, and its values {shape}; use .filled(), or '
                         'numpy.asarray()') from None


def unmasked(given: Any, array: Array, name: str) -> Tuple[Array, Optional[Array]]:
    """The values as a plain array, with NaN for masked floats, and where masked values of other types are."""
    mask = mask_of(given, name)
    if mask is None and array is not given:
        mask = mask_of(array, name)  # of what a lazy array has computed
    plain: Array = np.asarray(array)
    if mask is None:
        return plain, None
    if plain.dtype.kind != 'f':
        return plain, mask
    plain = plain.copy()
    plain[mask] = np.nan
    return plain, None


def places(given: Any, name: str) -> Array:
    """Coordinates as an array of doubles, with NaN where they are masked."""
    try:
        array = np.asanyarray(given)
        doubles, mask = unmasked(given, array, name)
        if doubles.dtype.kind not in 'biuf':
            raise TypeError(name)
        doubles = np.ascontiguousarray(doubles, dtype=np.float64)
    except (TypeError, ValueError, OverflowError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(f'{name}: {shown(given)} cannot be; it takes numbers') from None
    if mask is not None:
        doubles = np.where(mask, np.nan, doubles)
    return doubles


def refuse_mask(mask: Optional[Array], name: str, why: str) -> None:
    """InputError if there is a mask."""
    if mask is not None:
        raise InputError(f'{name}: {int(mask.sum())} of its values are masked, and {why}; give what is to stand for '
                         'them by .filled(value)')
