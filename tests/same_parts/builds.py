"""Where a build has its programs."""
import pathlib


class Build:
    """A build folder, its bin folder, or a copy of either. What is not there is None."""

    def __init__(self, name, folder):
        self.name = name
        folder = pathlib.Path(folder).resolve()
        self.bin = next((each for each in (folder / 'bin', folder) if (each / 'vprobe').is_file()), None)
        if self.bin is None:
            raise FileNotFoundError(f'{folder}: no bin/vprobe, no vprobe')
        self.root = self.bin.parent
        self.vprobe = self.bin / 'vprobe'
        self.mpi = self._file('bin/vprobe-mpi')
        self.python = self._file('python/vprobe/__init__.py') and self.root / 'python'
        self.library = self._library()

    def _file(self, name):
        path = self.root / name
        return path if path.is_file() else None

    def _library(self):
        """The folder of libvprobe.so."""
        for folder in ('bin', 'lib', 'engine', 'python/vprobe'):
            if any((self.root / folder).glob('libvprobe.so*')):
                return self.root / folder
        return None

    def test_program(self, name):
        """A program of the tests, which lies beside vprobe."""
        return self._file(f'bin/{name}')
