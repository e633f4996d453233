#!/usr/bin/env python3
"""Stands for vprobe in tests/cli: runs AFTER and then BEFORE, on the same files and in the surroundings that the test has
made. The test sees AFTER.

VPROBE_SAME_BUILDS has the two programs, VPROBE_SAME_SOCKET leads to command_tests.py, which puts files back in between and
compares. That cannot be done here: a test may have limited the size of files, or closed streams.
"""
import os
import pickle
import signal
import socket
import stat
import subprocess
import sys

STREAMS = (0, 1, 2)


def is_open(stream):
    try:
        os.fstat(stream)
        return True
    except OSError:
        return False


class Surroundings:
    """What the test has made for the program, and Python would change."""

    def __init__(self):
        self.closed = [stream for stream in STREAMS if not is_open(stream)]
        for _ in self.closed:  # or what we open would take the number
            os.open(os.devnull, os.O_RDWR)

    def hand_over(self):
        """In the child, before it becomes the program. Python ignores SIGXFSZ, as tests with limited files do."""
        signal.signal(signal.SIGPIPE, signal.SIG_DFL)
        for stream in self.closed:
            os.close(stream)

    def pipe(self, stream):
        """None where what is written cannot be looked at: a closed stream, /dev/full."""
        is_device = stat.S_ISCHR(os.fstat(stream).st_mode)
        return None if is_device or stream in self.closed else subprocess.PIPE


def regular_files():
    """The files that streams go to: they are the test's, not the program's."""
    return [os.readlink(f'/proc/self/fd/{stream}') for stream in STREAMS if stat.S_ISREG(os.fstat(stream).st_mode)]


def run(program, around):
    """The exit code, standard output and standard error, as far as they can be looked at."""
    if stat.S_ISREG(os.fstat(0).st_mode):
        os.lseek(0, 0, os.SEEK_SET)
    process = subprocess.Popen(['vprobe', *sys.argv[1:]], executable=program, restore_signals=False,
                               preexec_fn=around.hand_over, stdout=around.pipe(1), stderr=around.pipe(2))

    def end(number, _):  # how far it came is chance: nothing to compare
        process.send_signal(number)
        leave(process.wait(), *[stream and stream.read() for stream in (process.stdout, process.stderr)])

    signal.signal(signal.SIGINT, end)
    out, err = process.communicate()
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    return process.returncode, out, err


def leave(code, out, err):
    """Ends as the program did."""
    for stream, data in ((1, out), (2, err)):
        while data:
            data = data[os.write(stream, data):]
    if code < 0:
        signal.signal(-code, signal.SIG_DFL)
        os.kill(os.getpid(), -code)
    os._exit(code)


def main():
    around = Surroundings()
    before, after = os.environ['VPROBE_SAME_BUILDS'].split(':')
    with socket.socket(socket.AF_UNIX) as connection:
        connection.connect(os.environ['VPROBE_SAME_SOCKET'])
        with connection.makefile('rwb') as line:
            def tell(what):
                """Returns when the other side has done its part."""
                pickle.dump(what, line)
                line.flush()
                pickle.load(line)
            tell((sys.argv[1:], regular_files()))
            new = run(after, around)
            tell(new)
            tell(run(before, around))
    leave(*new)


main()
