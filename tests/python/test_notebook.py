"""A notebook whose cells are run, as a user runs them."""
import pytest

pytestmark = pytest.mark.gpu
nbformat = pytest.importorskip('nbformat', reason='no nbformat')
nbclient = pytest.importorskip('nbclient', reason='no nbclient')
pytest.importorskip('ipykernel', reason='no ipykernel')

CELLS = [
    "import vprobe\ndata = vprobe.open('demo:shell:16')",
    "data.render(normal=(.3, .5, .8), size=(160, 100), samples=1)",
    "data",
    "view = data.view(size=(160, 100), samples=1)\nview",
    "before = view.picture.value\nview.elevation.value = 20.0\nview.picture.value != before",
]


def test_cells_show_pictures_and_sliders_move_them():
    import vprobe
    try:
        vprobe.open('demo:shell:8').render(size=(16, 16), samples=1)
    except vprobe.DeviceError as error:
        pytest.skip(str(error))
    book = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(cell) for cell in CELLS])
    client = nbclient.NotebookClient(book, timeout=120, kernel_name='python3')
    client.comm_open_handlers.clear()  # it keeps the state of newer widgets than 6.0, and trips over these
    client.execute()
    shown = [cell.outputs[-1] if cell.outputs else None for cell in book.cells]
    assert shown[0] is None
    assert shown[1].data['image/png'] and shown[1].data['text/plain'] == '<vprobe.Image 160 x 100 pixels>'
    assert shown[2].data['text/plain'] == '<vprobe.Dataset demo:shell:16: curvilinear, 4096 cells, s, v>'
    try:
        import ipywidgets  # noqa: F401
    except ImportError:
        assert shown[3].data['image/png']
        return
    assert 'application/vnd.jupyter.widget-view+json' in shown[3].data
    assert shown[4].data['text/plain'] == 'True'
