"""A desktop of our own for windows: Xvfb with a window manager that gives windows no frame."""
import os
import shutil
import subprocess
import time

NEEDED = ('Xvfb', 'openbox', 'xdotool')
SETTINGS = """<?xml version="1.0"?>
<openbox_config xmlns="http://openbox.org/3.4/rc">
  <applications><application class="*"><decor>no</decor><focus>yes</focus>
    <position force="yes"><x>0</x><y>0</y></position></application></applications>
</openbox_config>
"""
SECONDS_TO_START = 20


def missing():
    """The programs that a desktop needs and that are not there."""
    return [name for name in NEEDED if not shutil.which(name)]


class Desktop:
    def __init__(self, scratch, environment):
        (scratch / 'openbox.xml').write_text(SETTINGS)
        readable, writable = os.pipe()
        self.screen = subprocess.Popen(
            ['Xvfb', '-displayfd', str(writable), '-screen', '0', '1400x900x24', '-nolisten', 'tcp', '-noreset'],
            env=environment, pass_fds=[writable], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(writable)
        with os.fdopen(readable) as ready:
            self.name = ':' + ready.readline().strip()
        environment = environment | {'DISPLAY': self.name}
        self.manager = subprocess.Popen(['openbox', '--config-file', str(scratch / 'openbox.xml')], env=environment,
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        # A window that is opened while the manager starts may wait for ever to be told that it is seen (GLFW 3.3).
        end = time.monotonic() + SECONDS_TO_START
        while subprocess.run(['xdotool', 'get_num_desktops'], env=environment, capture_output=True).returncode:
            if time.monotonic() > end:
                self.close()
                raise RuntimeError('openbox does not manage windows')
            time.sleep(0.1)

    def close(self):
        for process in (self.manager, self.screen):
            process.terminate()
            process.wait()
