"""Pictures, as arrays that show themselves in a notebook."""
from __future__ import annotations

import os
from typing import Any, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._arguments import path
from ._errors import UsageError


class Image(np.ndarray):  # type: ignore[type-arg]
    """A picture: a uint8 array of the shape (height, width, 4), rows from the top, red, green, blue, alpha in sRGB.

    In a notebook it shows itself.
    """

    @classmethod
    def _of(cls, pixels: npt.NDArray[np.uint8]) -> Image:
        return pixels.view(cls)

    def png(self) -> bytes:
        """The picture as a PNG file.

        Raises
        ------
        UsageError
            Where this is no whole picture any more, such as one channel of it.
        """
        if self.ndim != 3 or self.shape[2] != 4 or self.dtype != np.uint8 or self.size == 0:
            raise UsageError(f'an array of the shape {self.shape} is no picture; it needs (height, width, 4) of uint8')
        return _core.png(np.ascontiguousarray(self))

    def save(self, file: Union[str, os.PathLike[str]]) -> None:
        """Writes a PNG file, whole or not at all.

        Raises
        ------
        OutputError
            Where it cannot be written.
        """
        self.png()  # whether it is one
        _core.save_png(np.ascontiguousarray(self), path(file, 'file'))

    def _repr_png_(self) -> Any:
        return self.png() if self.ndim == 3 and self.shape[2:] == (4,) and self.size else None

    def __repr__(self) -> str:
        if self.ndim != 3:
            return repr(np.asarray(self))
        return f'<vprobe.Image {self.shape[1]} x {self.shape[0]} pixels>'

    __str__ = __repr__
