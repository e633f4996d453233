"""Folders as they were, and what has changed in them."""
import os
import pathlib
import shutil
import stat


def regular_files(folder):
    """Every regular file below, as its path from there; links, pipes and the like are left out."""
    for where, _, names in os.walk(folder):
        for name in names:
            path = pathlib.Path(where, name)
            if stat.S_ISREG(path.lstat().st_mode):
                yield path.relative_to(folder)


def marks(folder):
    """What tells whether a file was written."""
    found = {}
    for name in regular_files(folder):
        is_now = (folder / name).stat()
        found[name] = (is_now.st_ino, is_now.st_size, is_now.st_mtime_ns)
    return found


def changed(folder, before):
    """{name: bytes} of the files that were written since, b'(gone)' of those that went."""
    now = marks(folder)
    files = {name: (folder / name).read_bytes() for name in now if now[name] != before.get(name)}
    files.update({name: b'(gone)' for name in before if name not in now})
    return {str(name): files[name] for name in sorted(files)}


def copy(folder, to):
    """Files, links and folders; times and modes are kept."""
    for where, names, files in os.walk(folder):
        there = pathlib.Path(to) / pathlib.Path(where).relative_to(folder)
        there.mkdir(parents=True, exist_ok=True)
        for name in [*names, *files]:
            path = pathlib.Path(where, name)
            mode = path.lstat().st_mode
            if stat.S_ISLNK(mode):
                (there / name).symlink_to(os.readlink(path))
            elif stat.S_ISREG(mode):
                shutil.copy2(path, there / name)


def restore(folder, copied, spared=()):
    """Makes a folder what its copy is, in place: somebody may stand in it. spared: files that stay as they are."""
    folder, copied = pathlib.Path(folder), pathlib.Path(copied)
    for where, names, files in os.walk(folder, topdown=False):
        twin = copied / pathlib.Path(where).relative_to(folder)
        for name in [*files, *(each for each in names if pathlib.Path(where, each).is_symlink())]:
            path = pathlib.Path(where, name)
            if path not in spared and stat.S_IFMT(path.lstat().st_mode) in (stat.S_IFREG, stat.S_IFLNK):
                path.unlink()
        for name in names:
            path = pathlib.Path(where, name)
            if not path.is_symlink() and not (twin / name).is_dir():
                shutil.rmtree(path)
    for where, names, files in os.walk(copied):
        there = folder / pathlib.Path(where).relative_to(copied)
        there.mkdir(exist_ok=True)
        for name in [*names, *files]:
            path = pathlib.Path(where, name)
            if path.is_symlink():
                (there / name).symlink_to(os.readlink(path))
            elif path.is_file() and there / name not in spared:
                shutil.copy2(path, there / name)
