"""A picture in a notebook, with sliders where ipywidgets is there."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, Optional

import numpy as np

from ._picture import Image
from ._probe import Probe

if TYPE_CHECKING:
    from ._dataset import Dataset


def direction(azimuth: float, elevation: float) -> 'tuple[float, float, float]':
    """The direction of these angles in degrees: from x towards y, and up towards z."""
    a, e = np.radians([azimuth, elevation])
    return float(np.cos(e) * np.cos(a)), float(np.cos(e) * np.sin(a)), float(np.sin(e))


class Viewer:
    """Shows a cut in a notebook. The picture follows the sliders while they are dragged.

    Attributes
    ----------
    image : Image
        The picture as it is now.
    widget : ipywidgets.VBox or None
        The sliders and the picture; None without ipywidgets.
    """

    def __init__(self, data: Dataset, probe: Optional[Probe], settings: Dict[str, Any]) -> None:
        self._data = data
        self._probe = probe
        self._settings: Dict[str, Any] = {'size': (640, 400), **settings}
        self.image: Image = self._draw()
        self.widget: Any = self._widgets()

    def _draw(self, **settings: Any) -> Image:
        return self._data.render(self._probe, **{**self._settings, **settings})

    def _widgets(self) -> Any:
        try:
            import ipywidgets as widgets
        except ImportError:
            return None
        bounds = np.array(self._data.bounds).reshape(3, 2)
        self._center, reach = bounds.mean(axis=1), float(np.linalg.norm(np.ptp(bounds, axis=1))) / 2
        names = [array.name for array in self._data.arrays]
        self.position = widgets.FloatSlider(description='position', min=-reach, max=reach, step=reach / 100, value=0.0)
        self.azimuth = widgets.FloatSlider(description='azimuth', min=-180.0, max=180.0, step=1.0, value=0.0)
        self.elevation = widgets.FloatSlider(description='elevation', min=-90.0, max=90.0, step=1.0, value=90.0)
        self.opacity = widgets.FloatSlider(description='opacity', min=0.0, max=1.0, step=0.05,
                                           value=float(self._settings.get('opacity') or 1.0))
        self.array = widgets.Dropdown(description='array', options=list(dict.fromkeys(names)))
        self.picture = widgets.Image(value=self.image.png(), format='png')
        if self._settings.get('array') in names:
            self.array.value = self._settings['array']
        controls = [self.position, self.azimuth, self.elevation, self.opacity, *([self.array] if names else [])]
        for control in controls:
            control.observe(self._follow, names='value')
        return widgets.VBox([*controls, self.picture])

    def _follow(self, change: Any) -> None:
        normal = np.array(direction(self.azimuth.value, self.elevation.value))
        moved: Dict[str, Any] = {'opacity': self.opacity.value}
        if self.array.value is not None:
            moved['array'] = self.array.value
        # The place of a probe, or of a slice, that was given stays until somebody moves it.
        if change['owner'] in (self.position, self.azimuth, self.elevation) or 'normal' in self._moved():
            moved.update(normal=tuple(normal), origin=tuple(self._center + self.position.value * normal))
        self._settings.update(moved)
        self.image = self._draw()
        self.picture.value = self.image.png()

    def _moved(self) -> Dict[str, Any]:
        return self._settings if self.position.value or self.elevation.value != 90.0 or self.azimuth.value else {}

    def _ipython_display_(self) -> None:
        from IPython.display import display
        if self.widget is not None:
            display(self.widget)
        else:
            display(self.image)

    def _repr_png_(self) -> bytes:
        return self.image.png()

    def __repr__(self) -> str:
        return f'<vprobe.Viewer of {self._data!r}>'
