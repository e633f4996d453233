"""Grids of cells that vprobe converts, as VTK reads them back."""
from common import run


def grid_of(path, folder, *options):
    """The grid of a file of one block, and what was said."""
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
    out = folder / 'out.vtu'
    done = run('convert', path, '-o', out, *options)
    assert done.returncode == 0, done.stderr
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(out))
    reader.Update()
    out.unlink()
    return reader.GetOutput(), done.stderr


def points_of(grid):
    from vtkmodules.util.numpy_support import vtk_to_numpy
    return vtk_to_numpy(grid.GetPoints().GetData()).copy()


def cells_of(grid):
    """The corners of each cell."""
    return [frozenset(grid.GetCell(i).GetPointIds().GetId(c) for c in range(grid.GetCell(i).GetNumberOfPoints()))
            for i in range(grid.GetNumberOfCells())]


def arrays_of(fields):
    """The arrays of points or cells by their names; one row for each of them."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    arrays = {}
    for i in range(fields.GetNumberOfArrays()):
        values = vtk_to_numpy(fields.GetArray(i)).copy()
        arrays[fields.GetArrayName(i)] = values.reshape(len(values), -1)
    return arrays
