"""Puts into the wheel what the project's own build makes: the module, the core library, and what reads files."""
import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py

root = pathlib.Path(__file__).resolve().parents[2]
if not (root / 'CMakeLists.txt').exists():
    sys.exit('build the wheel in the source tree: python3 -m build --wheel --no-isolation apps/python')
build = pathlib.Path(os.environ.get('VPROBE_BUILD', root / 'build/release'))
scratch = root / 'build/wheel'
scratch.mkdir(parents=True, exist_ok=True)


class Binary(Distribution):
    """A wheel for this Python and this machine."""

    def has_ext_modules(self):
        return True


class Build(build_py):
    """Adds the binaries, without what is for debugging."""

    def run(self):
        super().run()
        if not (build / 'build.ninja').exists():
            subprocess.run(['cmake', '--preset', 'release', '-DVPROBE_TESTS=OFF', '-DVPROBE_BENCH=OFF',
                            f'-DPython_EXECUTABLE={sys.executable}'], cwd=root, check=True)
        subprocess.run(['cmake', '--build', build, '--target', 'python_core'], check=True)
        made = build / 'python/vprobe'
        binaries = [*made.glob('_core.*.so'), made / 'libvprobe.so.0', build / 'bin/vprobe-read',
                    build / 'bin/vprobe-read-more']
        for binary in binaries:
            target = pathlib.Path(self.build_lib) / 'vprobe' / binary.name
            shutil.copy(binary, target)
            subprocess.run(['strip', '--strip-unneeded', target], check=True)


version = re.search(r'VolumeProbes VERSION ([\d.]+)', (root / 'CMakeLists.txt').read_text(encoding='utf-8')).group(1)
setup(version=version, packages=['vprobe'], package_data={'vprobe': ['*.pyi', 'py.typed']}, distclass=Binary,
      cmdclass={'build_py': Build},
      options={'build': {'build_base': str(scratch)}, 'egg_info': {'egg_base': str(scratch)}})
