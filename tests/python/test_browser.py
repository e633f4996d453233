"""A notebook in headless Chromium: a slider is dragged, and the picture follows. Only at length (VPROBE_LONG)."""
import os
import shutil
import subprocess
import sys
import time

import pytest

pytestmark = pytest.mark.gpu
if not os.environ.get('VPROBE_LONG'):
    pytest.skip('takes a browser; VPROBE_LONG runs it', allow_module_level=True)
webdriver = pytest.importorskip('selenium.webdriver', reason='no selenium')
nbformat = pytest.importorskip('nbformat', reason='no nbformat')
for program in ('chromium', 'chromedriver', 'jupyter-notebook'):
    if not shutil.which(program):
        pytest.skip(f'no {program}', allow_module_level=True)

CELL = "import vprobe\nvprobe.open('demo:shell:16').view(size=(320, 200), samples=1)"
PICTURE = 'return [...document.querySelectorAll(".output_area img, .widget-area img, .jupyter-widgets img")].map(i => i.src)'


@pytest.fixture
def address(tmp_path):
    """A server of notebooks with one in it."""
    book = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(CELL)], metadata={
        'kernelspec': {'name': 'python3', 'display_name': 'Python 3', 'language': 'python'}})
    nbformat.write(book, tmp_path / 'view.ipynb')
    port = 18000 + os.getpid() % 10000
    server = subprocess.Popen(
        [sys.executable, '-m', 'notebook', '--no-browser', '--allow-root', f'--port={port}', '--ip=127.0.0.1',
         '--NotebookApp.token=', '--NotebookApp.password=', f'--notebook-dir={tmp_path}'],
        stdout=subprocess.DEVNULL, stderr=open(tmp_path / 'server.log', 'wb'),
        env={**os.environ, 'JUPYTER_RUNTIME_DIR': str(tmp_path / 'runtime')})
    try:
        wait(lambda: 'is running at' in (tmp_path / 'server.log').read_text() or server.poll() is not None, 60)
        assert server.poll() is None, (tmp_path / 'server.log').read_text()
        yield f'http://127.0.0.1:{port}/notebooks/view.ipynb'
    finally:
        server.terminate()
        server.wait()


@pytest.fixture
def browser():
    options = webdriver.ChromeOptions()
    for argument in ('--headless=new', '--no-sandbox', '--disable-gpu', '--disable-dev-shm-usage', '--window-size=1000,1000'):
        options.add_argument(argument)
    options.binary_location = shutil.which('chromium')
    from selenium.webdriver.chrome.service import Service
    driver = webdriver.Chrome(service=Service(shutil.which('chromedriver')), options=options)
    yield driver
    driver.quit()


def wait(ready, seconds):
    end = time.monotonic() + seconds
    while not ready():
        assert time.monotonic() < end, 'waited in vain'
        time.sleep(.2)


def test_the_picture_follows_a_slider(browser, address, tmp_path):
    browser.get(address)
    wait(lambda: browser.execute_script(
        'return window.Jupyter && Jupyter.notebook && Jupyter.notebook.kernel && Jupyter.notebook.kernel.is_connected()'),
         60)
    browser.execute_script('Jupyter.notebook.execute_all_cells()')
    wait(lambda: browser.execute_script(PICTURE), 60)
    before = browser.execute_script(PICTURE)[0]
    handle = browser.find_elements('css selector', '.ui-slider-handle')[0]
    webdriver.ActionChains(browser).click_and_hold(handle).move_by_offset(20, 0).perform()
    wait(lambda: browser.execute_script(PICTURE)[0] != before, 20)  # while the button is still down
    webdriver.ActionChains(browser).release().perform()
    shot = os.environ.get('VPROBE_SHOT')
    if shot:
        browser.save_screenshot(shot)
