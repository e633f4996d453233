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
    for frame in data.sweep(frames=2, size=(96, 64), **settings):
        yield f'frame {frame.index} of {frame.count}: {digest(frame.image)}'
        yield from of_cut(frame.cut)


def answers(data, settings):
    """What is asked, and a function that gives the lines of the answer."""
    def plan():
        return [repr(row) for row in data.plan(**settings)]
    yield 'first plan', plan
    yield 'first cut', lambda: of_cut(data.cut(**settings))
    yield 'second cut', lambda: of_cut(data.cut(**settings))
    yield 'second plan', plan
    yield 'picture', lambda: [digest(data.render(size=(96, 64), **settings))]
    yield 'sweep', lambda: of_sweep(data, settings)


def ask(name, source, classify, settings):
    try:
        data = vprobe.open(source, classify=classify)
    except vprobe.Error as error:
        print(f'[{name}] open: {type(error).__name__}: {error}')
        return
    for what, answer in answers(data, settings):
        try:
            for line in answer():
                print(f'[{name}] {what}: {line}')
        except vprobe.Error as error:
            print(f'[{name}] {what}: {type(error).__name__}: {error}')


def main():
    warnings.showwarning = lambda message, *_, **__: print('warning:', message)
    warnings.simplefilter('always')
    _, plans, source, classify = sys.argv
    name, settings = '', {}
    with open(plans, encoding='utf-8') as lines:
        for line in lines:
            word, _, rest = line.rstrip('\n').partition(' ')
            if word == 'plan':
                name, settings = rest, {}
            elif word == 'set':
                key, _, value = rest.partition(' ')
                settings[key] = value
            elif word == 'ask':
                ask(name, source, classify, settings)


main()
