"""Small files that stand for those which command lines name: myfile.vtu, case.pvtu, points.txt."""
import math


def hexahedra(n, layers):
    """A box of n x n x n hexahedra over [-1, 1]^3, warped a little; of it, these layers. As an XML unstructured grid."""
    side = n + 1
    first, end = layers
    places = [(2 * i / n - 1, 2 * j / n - 1, 2 * k / n - 1)
              for k in range(first, end + 1) for j in range(side) for i in range(side)]
    points = [(x, y, z + 0.2 * math.sin(2 * x) * math.cos(y)) for x, y, z in places]
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    cells = [[((k + c) * side + j + b) * side + i + a for a, b, c in corners]
             for k in range(end - first) for j in range(n) for i in range(n)]

    def array(kind, name, values, components=1):
        words = ' '.join(repr(value) for value in values)
        return f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}" format="ascii">{words}</DataArray>\n'

    scalar = [math.sin(3 * x) * math.cos(2 * y) + z * z for x, y, z in points]
    vector = [value for x, y, z in points for value in (y, -x, 0.3)]
    return ('<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian"><UnstructuredGrid>\n'
            f'<Piece NumberOfPoints="{len(points)}" NumberOfCells="{len(cells)}">\n<PointData>\n'
            + array('Float64', 's', scalar) + array('Float64', 'p', [value / 2 for value in scalar])
            + array('Float64', 'v', vector, 3) + '</PointData>\n<CellData>\n'
            + array('Int32', 'c', range(first * n * n, end * n * n)) + '</CellData>\n<Points>\n'
            + array('Float64', 'Points', [value for point in points for value in point], 3) + '</Points>\n<Cells>\n'
            + array('Int64', 'connectivity', [corner for cell in cells for corner in cell])
            + array('Int64', 'offsets', range(8, 8 * len(cells) + 8, 8)) + array('UInt8', 'types', [12] * len(cells))
            + '</Cells>\n</Piece>\n</UnstructuredGrid></VTKFile>\n').encode()


def in_pieces(n, pieces, name):
    """{file: bytes} of such a box in pieces."""
    bounds = [n * piece // pieces for piece in range(pieces + 1)]
    files = {f'{name}_{piece}.vtu': hexahedra(n, bounds[piece:piece + 2]) for piece in range(pieces)}
    sources = ''.join(f'<Piece Source="{file}"/>' for file in files)
    arrays = ''.join(f'<PDataArray type="Float64" Name="{array}" NumberOfComponents="{components}"/>'
                     for array, components in (('s', 1), ('p', 1), ('v', 3)))
    files[f'{name}.pvtu'] = (
        '<VTKFile type="PUnstructuredGrid" version="1.0" byte_order="LittleEndian"><PUnstructuredGrid GhostLevel="0">'
        f'<PPointData>{arrays}</PPointData><PCellData><PDataArray type="Int32" Name="c"/></PCellData>'
        '<PPoints><PDataArray type="Float64" Name="Points" NumberOfComponents="3"/></PPoints>'
        f'{sources}</PUnstructuredGrid></VTKFile>\n').encode()
    return files


def stand_ins():
    """By the name in a command line: the files that it needs."""
    whole = hexahedra(6, (0, 6))
    pieces = in_pieces(6, 3, 'piece')
    return {
        'myfile.vtu': {'myfile.vtu': whole}, 'grid.vtu': {'grid.vtu': whole}, 'flow.vtu': {'flow.vtu': whole},
        'case.pvtu': in_pieces(6, 4, 'case'),
        'piece_*.vtu': {name: data for name, data in pieces.items() if name.endswith('.vtu')},
        'points.txt': {'points.txt': b'0.1 0.2 0.3\n1.5 1 0.5\n9 9 9\n'},
        'yesterday.json': {'yesterday.json': b'{"input": {"files": ["demo:blob:8"]}, "probe": {"normal": [1, 2, 3]}}\n'},
    }
