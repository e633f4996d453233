"""Packs that are drawn. That needs a Vulkan device. Drivers leak memory, so the address sanitizer does not watch this."""
import subprocess
import time

from against import VPROBE, Missing, vprobe
from packs import older, packed, packs_are_swept_as_their_inputs


def need_device(folder):
    drawn = subprocess.run([VPROBE, 'render', 'demo:tets:2', '-o', folder / 'a.png'], capture_output=True, encoding='utf-8')
    if drawn.returncode == 3:
        raise Missing('a Vulkan device')
    assert drawn.returncode == 0, drawn.stderr


def packs_are_swept_and_drawn(folder):
    need_device(folder)
    packs_are_swept_as_their_inputs(folder, [['-o', folder / 'f{frame}.png']])


def packs_that_change_in_a_sweep_are_told(folder):
    """What was read stays right, and a file that is cut short ends the sweep in one line."""
    need_device(folder)
    _, pack = packed(folder, '--part', '64')
    film = folder / 'frames' / 'f{frame}.png'
    sweep = subprocess.Popen([VPROBE, 'sweep', pack, '--normal', '0', '0', '1', '--frames', '400', '--size', '40x30',
                              '-o', film], stderr=subprocess.PIPE, encoding='utf-8')
    while not (folder / 'frames' / 'f3.png').exists() and sweep.poll() is None:
        time.sleep(0.01)
    with open(pack, 'r+b') as file:
        file.truncate(3000)
    said = sweep.communicate()[1].strip().splitlines()
    assert sweep.returncode == 2 and len(said) == 1 and 'shorter while it was open' in said[0], (sweep.returncode, said)


def packs_are_drawn_as_their_inputs(folder):
    """The camera sees the same, although it has not met most points."""
    need_device(folder)
    path, pack = packed(folder, '--part', '64')
    sheet = ['--normal', '0', '0', '1', '--origin', '0', '0', '1', '--array', 'f']
    for options in (['--probe', 'trihedral', '--array', 'v'], [*sheet, '--log'], [*sheet, '--crinkle'],
                    [*sheet, '--threshold', '20', '60'], [*sheet, '--window', '1', '0.8', '--contour-at', '0.5', '0.5']):
        pictures = []
        for each in (path, pack, older(pack, folder)):
            out = folder / 'drawn.png'
            vprobe('render', each, *options, '--size', '320x240', '--title', '', '-o', out)
            pictures.append(out.read_bytes())
        assert pictures[0] == pictures[1] == pictures[2], options


CASES = [packs_are_swept_and_drawn, packs_that_change_in_a_sweep_are_told, packs_are_drawn_as_their_inputs]
