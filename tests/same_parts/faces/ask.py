"""Asks the Python module for plans, and prints and saves what it answers, as ask.cpp does through the C++ face.

usage: ask.py PLANS.txt INPUT cpu|gpu
"""
import hashlib
import sys
import warnings

import numpy as np

import vprobe

FIGURES = ('area', 'boundary_area', 'nan_area', 'mean', 'min', 'max', 'flux', 'boundary_mean', 'boundary_flux', 'components',
           'cut_cells')


def digest(*arrays):
    found = hashlib.sha256()
    for array in arrays:
        found.update(np.ascontiguousarray(array).tobytes())
    return found.hexdigest()[:16]


def of_mesh(mesh):
    arrays = ', '.join(f'{name} {digest(mesh[name])}' for name in mesh.keys())
    return f'{mesh!r}: {digest(mesh.points)} {digest(mesh.cells)} {digest(mesh.blocks)}; {arrays}'


def of_cut(cut):
    for piece in cut:
        yield f'sheet: {of_mesh(piece)}'
        yield 'figures: ' + ', '.join(f'{name} {getattr(piece, name)!r}' for name in FIGURES)


def of_sweep(data, settings):
    for frame in data.sweep(**settings | {'frames': 2, 'size': (96, 64), 'samples': 1}):
        yield f'frame {frame.index} of {frame.count}: {digest(frame.image)}'
        yield from of_cut(frame.cut)


def tell(name, what, answer):
    """answer: a function that gives lines."""
    try:
        for line in answer():
            print(f'[{name}] {what}: {line}')
    except vprobe.Error as error:
        print(f'[{name}] {what}: {type(error).__name__}: {error}')


def ask(name, data, settings):
    """Cuts twice, since the second cut may go another way."""
    for which in ('first', 'second'):
        tell(name, f'{which} plan', lambda: map(repr, data.plan(**settings)))
        tell(name, f'{which} cut', lambda: of_cut(data.cut(**settings)))


def draw(name, data, settings):
    tell(name, 'picture', lambda: [digest(data.render(**settings | {'size': (96, 64)}))])
    tell(name, 'sweep', lambda: of_sweep(data, settings))


def main():
    warnings.showwarning = lambda message, *_, **__: print('warning:', message)
    warnings.simplefilter('always')
    _, plans, source, classify = sys.argv
    drawn = vprobe.open(source, classify=classify)  # pictures share a device, since it takes its time to open
    name, settings = '', {}
    with open(plans, encoding='utf-8') as lines:
        for line in lines:
            word, _, rest = line.rstrip('\n').partition(' ')
            if word == 'plan':
                name, settings = rest, {}
            elif word == 'set':
                key, _, value = rest.partition(' ')
                settings[key] = getattr(vprobe.Probe, value)() if key == 'probe' else value
            elif word == 'ask':
                ask(name, vprobe.open(source, classify=classify), settings)
            elif word == 'draw':
                draw(name, drawn, settings)


main()
