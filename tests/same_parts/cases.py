"""What is run: steps, and cases of them."""
import dataclasses
import shlex


@dataclasses.dataclass
class Step:
    """A command. Its first word names the program: vprobe, vprobe-mpi, face or python."""
    words: list
    ranks: int = 0         # of vprobe-mpi
    window: bool = False   # needs a desktop
    note: str = ''         # what the words do not tell

    def __str__(self):
        mpiexec = f'mpiexec -n {self.ranks} ' if self.ranks else ''
        return f'{mpiexec}{shlex.join(self.words)}{self.note and f"  ({self.note})"}'


@dataclasses.dataclass
class Case:
    """Steps that run in one folder, one after the other."""
    room: str
    steps: list
    files: dict = dataclasses.field(default_factory=dict)  # by name: the bytes that lie there at the start


@dataclasses.dataclass
class LeftOut:
    """A command that cannot run here."""
    room: str
    command: str
    reason: str
