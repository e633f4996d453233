"""Plans: data sets and settings, which every face of the program is asked for."""
import dataclasses
import functools
import re
import shlex

from .cases import Case, LeftOut, Step
from .documents import ROOT, data_files
from .samples import hexahedra, in_pieces

# Every kind of grid, small: most of a run's time is the start of programs.
DEMOS = ('demo:blob:10', 'demo:graded:10', 'demo:shell:12', 'demo:tets:8', 'demo:mixed:8', 'demo:hexes:8', 'demo:layer:8')
# Beside the options of docs/CUTTING.md: what is shown, how it looks, and what is refused.
OPTIONS = (
    '--normal 0.3 0.5 0.81 --origin 0.1 1.2 0.2',
    '--probe trihedral --origin 0.2 1.5 0.1 --context boundary --outline edges',
    '--probe paddlewheel --vanes 4 --opacity 0.5 --normal 0.5 0.2 0 --up 0 0 1 --lit',
    '--probe stack --sheets 3 --normal 1 0.2 0 --window 1.5 1 --corners skip',
    '--probe stack --offsets -0.5 0.1 0.7 --normal y --axes box --lines 6',
    '--normal x --crinkle --mesh',
    '--surface cylinder:1.2 --origin 0 1.5 0 --crinkle',
    '--surface cone:20 --normal 0 0.3 1',
    '--surface i=0..4 --path translate',
    '--surface k=3.5 --array v --component y',
    '--window 2 2 --contour 0.2 -0.1 --origin 0 1.5 0.1',
    '--window 1.5 1 --contour-at 0.2 0.1 --contour-depth 0.4 --origin 0 1.8 0',
    '--vectors tufts --origin 0 1.5 0.1 --vector-lattice 8',
    '--vectors ribbons --origin 0 1.5 0.1 --vector-lattice 5 --vector-steps 12 --vector-jitter 0.5',
    '--vectors tubes --origin 0 1.5 0.1 --vector-lattice 4 --vector-direction both',
    '--array v --component 1 --symmetric --bands 6',
    '--array v --log --range-of slice --colormap viridis_r',
    '--color-by generation --seeds hotspot --origin 0 1.9 0.1',
    '--threshold -0.2 0.6 --window 2 2 --origin 0 1.9 0.1',
    '--hanging interpolate --outside refuse --origin 9 9 9',
    '--origin 9 9 9 --outside nearest --range 0 1',
    '--path revolve --probe paddlewheel --there-and-back',
    '--path spin --window 2 1 --background black --camera 30,20',
    '--threads 1 --samples 4 --size 96x64 --no-legend --title ""',
    '--normal 0 0 0', '--array none', '--size 0x0', '--opacity 2', '--surface z=sin(x',
)
# Small pictures, and few frames. Drawing takes ten times as long as cutting, so each plan is drawn for one grid.
PICTURE = ['--size', '96x64', '--samples', '1']
DRAWN = 1
SWEEP = ['--frames', '3']
# Well-known data sets of every kind, and how they are cut. The name is a file's below VPROBE_DATA.
DATA = (
    ('bluntfinxyz.bin', '--normal 0.3 0.5 0.8 --array Density'), ('disk_out_ref.ex2', '--array Temp --normal y'),
    ('RectGrid2.vtk', '--normal 1 1 0.4'), ('SampleStructGrid.vtk', '--probe trihedral'),
    ('carotid.vtk', '--window 40 30 --contour 180 --origin 137 104 23'), ('flange.foam', '--normal x'),
    ('case.foam', '--probe paddlewheel --time first'), ('office_bin.case', '--normal z'),
    ('HierarchicalBoxDataset.v1.1.vthb', '--normal 0.3 0.5 0.8'), ('5blocks-struc.cgns', '--normal z'),
    ('notch_disp.vtu', '--refine 0.01 --normal 0.3 0.5 0.8'), ('TEST_bin.case', '--normal x --crinkle'),
    ('uGridEx.vtk', '--normal 0.3 0.5 0.8 --vectors tufts'), ('hexa.vtk', '--normal y'))
# What a user of a window may do: actions by their names, and what is saved after each.
STEPS = ('preset_trihedral', 'push_forward', 'normal_to_camera', 'next_array', 'lines', 'window_bigger', 'contour', 'next_frame',
         'preset_paddlewheel', 'turn_up_plus', 'undo', 'mesh')
WINDOW_PLANS = 5


@dataclasses.dataclass
class Plan:
    source: str
    options: list
    draws: bool

    def settings(self):
        """(key, value) of each option, as a face takes them; None where the command line alone has one."""
        found = []
        for word in self.options:
            if re.match(r'--[a-z]', word):
                found.append([word[2:].replace('-', '_'), []])
            else:
                found[-1][1].append(word)
        if any(key in ('strategy', 'visited', 'threads', 'refine', 'time') for key, _ in found):
            return None
        return [(key, ' '.join(values) if values else 'true') for key, values in found]


def options_of_document():
    """The first column of the tables of docs/CUTTING.md that begin with `| options |`."""
    options = []
    inside = False
    for line in (ROOT / 'docs' / 'CUTTING.md').read_text(encoding='utf-8').split('\n'):
        inside = line.startswith('|') and (inside or line.startswith('| options |'))
        cell = line.split('|')[1].strip() if inside else ''
        if cell.startswith('`'):
            options.append(re.match('`([^`]*)`', cell)[1])
        elif cell == 'none':
            options.append('')
    return list(dict.fromkeys(options))


@functools.cache
def demo_plans():
    return [Plan(source, shlex.split(options), (demo - number) % len(DEMOS) < DRAWN)
            for number, options in enumerate([*options_of_document(), *OPTIONS]) for demo, source in enumerate(DEMOS)]


def command_lines(plan):
    """What a user may ask of a plan, and gets in files."""
    words = [plan.source, *plan.options]
    picture = [] if {'--size', '--samples'} & set(plan.options) else PICTURE
    steps = [Step(['vprobe', 'slice', *words, '--explain']),
             Step(['vprobe', 'slice', *words, '-o', 'cut.vtp', '--stats', '-'])]
    if plan.draws:
        steps += [Step(['vprobe', 'render', *words, *picture, '-o', 'cut.png', '--stats', 'render.json']),
                  Step(['vprobe', 'sweep', *words, *picture, *SWEEP, '-o', '{frame}.png', '--stats', 'sweep.json'])]
    return steps


def plan_cases():
    for plan in demo_plans():
        yield Case('plans', command_lines(plan))


def other_commands():
    """Commands that take no plan, for every kind of grid; what each command tells of itself."""
    commands = ('info', 'render', 'view', 'sweep', 'slice', 'sample', 'check', 'profile', 'convert', 'pack', 'manual')
    yield Case('plans', [Step(['vprobe', *words]) for words in (['--help'], ['--version'], ['manual'], ['info', 'demo:'])])
    yield Case('plans', [Step(['vprobe', command, '--help']) for command in commands])
    for source in DEMOS:
        yield Case('plans', [
            Step(['vprobe', 'info', source, '--json']), Step(['vprobe', 'check', source]),
            Step(['vprobe', 'sample', source, '--line', '-1', '0.5', '0.1', '2', '1.5', '0.4', '7']),
            Step(['vprobe', 'convert', source, '-o', 'out.vtu']), Step(['vprobe', 'slice', 'out.vtu', '--stats', '-']),
            Step(['vprobe', 'profile', source, '--planes', '4', '--json', '-']),
            Step(['vprobe', 'profile', source, '--planes', '4', '--window', '1', '1', '--draw', *PICTURE]),
            Step(['vprobe', 'slice', source, '--normal', 'x', '--lines', '5', '-o', 'flat.svg']),
            Step(['vprobe', 'slice', source, '--normal', 'x', '--lines', '5', '-o', 'flat.pdf']),
            Step(['vprobe', 'slice', source, '--probe', 'trihedral', '-o', 'cut.ply']),
            Step(['vprobe', 'slice', source, '--probe', 'trihedral', '-o', 'cut.csv']),
            Step(['vprobe', 'slice', source, '--probe', 'trihedral', '-o', 'cut.vtm']),
            Step(['vprobe', 'sweep', source, *SWEEP, '-o', 'cut.pvd']),
            Step(['vprobe', 'sweep', source, *SWEEP, *PICTURE, '--exposure', 'exposure.png', '-o', 'film.gif']),
            Step(['vprobe', 'render', source, '--save', 'state.json', *PICTURE, '-o', 'a.png']),
            Step(['vprobe', 'render', '--state', 'state.json', '--normal', 'y', '-o', 'b.png'])])


def data_cases():
    files = data_files()
    if not files:
        yield LeftOut('data', f'{len(DATA)} data sets', 'VPROBE_DATA is not set')
        return
    for name, options in DATA:
        if name not in files:
            yield LeftOut('data', name, f'VPROBE_DATA has no {name}')
            continue
        first, *others = command_lines(Plan(files[name], shlex.split(options), True))
        yield Case('data', [Step(['vprobe', 'info', files[name]]), Step(['vprobe', 'check', files[name]]), first, *others])


def rank_cases():
    """One to four ranks, with pieces that several share and with blocks that one has alone."""
    files = in_pieces(8, 4, 'case') | {'whole.vtu': hexahedra(8, (0, 8))}
    plans = ['--normal 0.3 0.5 0.8', '--probe trihedral --opacity 0.5 --origin 0.1 0.2 0.05', '--surface sphere:0.7 --mesh',
             '--normal 0.2 0.1 1 --crinkle', '--window 1.2 1.2 --contour 0.3 --normal x', '--vectors tubes --vector-array v --normal z',
             '--seeds boundary --threshold -0.5 0.6', '--seeds hotspot --origin 0.1 0.2 0.05', '--iso 0.25']
    for ranks in (1, 2, 3, 4):
        for options in plans:
            words = shlex.split(options)
            yield Case('ranks', [
                Step(['vprobe-mpi', 'slice', 'case.pvtu', *words, '-o', 'cut.vtp', '--stats', '-'], ranks),
                Step(['vprobe-mpi', 'render', 'case.pvtu', *words, *PICTURE, '-o', 'cut.png'], ranks)], files)
        yield Case('ranks', [
            Step(['vprobe-mpi', 'slice', 'case.pvtu', '--explain'], ranks),
            Step(['vprobe-mpi', 'slice', 'whole.vtu', 'demo:shell:8', 'demo:blob:8', '--explain'], ranks),
            Step(['vprobe-mpi', 'render', 'whole.vtu', 'demo:shell:8', 'demo:blob:8', *PICTURE, '--stats', 'stats.json'], ranks),
            Step(['vprobe-mpi', 'sweep', 'case.pvtu', '--path', 'rotate', *SWEEP, *PICTURE, '-o', '{frame}.png'], ranks),
            Step(['vprobe-mpi', 'profile', 'case.pvtu', '--planes', '3', '--json', '-'], ranks),
            Step(['vprobe-mpi', 'slice', 'none.vtu'], ranks)], files)


def asked_of_faces(source, classify):
    """Plans as a face program reads them."""
    lines = []
    for plan in demo_plans():
        settings = plan.settings()
        if plan.source != source or settings is None:
            continue
        asked = dict(settings).get('classify', 'cpu').strip(',')
        if asked != classify:
            continue
        lines.append(f'plan {shlex.join(plan.options)}')
        lines += [f'set {key} {value}' for key, value in settings if key not in ('classify', 'size')]
        lines += ['ask', 'draw'] if plan.draws else ['ask']
    return '\n'.join(lines).encode() + b'\n'


def face_cases(program):
    """program: the words that start one."""
    for source in DEMOS:
        for classify in ('cpu', 'gpu'):
            yield Case('faces', [Step([*program, 'plans.txt', source, classify])], {'plans.txt': asked_of_faces(source, classify)})


def window_cases():
    plans = [plan for plan in demo_plans() if plan.settings() is not None][::len(DEMOS) + 1]
    lines = []
    for number, action in enumerate((None, *STEPS)):
        lines += [f'do {action}'] * (action is not None) + ['wait', f'save-state {number}.json']
        if number % 3 == 0:
            lines += [f'save-slice {number}.vtp', f'save-picture 120 80 {number}.png', 'wait']
    script = '\n'.join([*lines, 'quit', '']).encode()
    for plan in plans[:WINDOW_PLANS]:
        yield Case('view', [Step(['vprobe', 'view', plan.source, *plan.options, '--commands', 'script', '--stats', '-',
                                  '--size', '640x400'], window=True)], {'script': script})


def example_cases(files):
    """The programs that docs/PYTHON.md quotes."""
    for file in files:
        yield Case('faces', [Step(['python', str(file)])])
