"""Small files that stand for a user's own in docs/TOURS.md: python3 tour_files.py FOLDER.

Needs numpy, netCDF4, nibabel and tifffile (python3-numpy, python3-netcdf4, python3-nibabel, python3-tifffile).
"""
import pathlib
import sys

import netCDF4
import nibabel
import numpy
import tifffile


def image_xml(dimensions, spacing, arrays):
    """An image of VTK in text. Arrays of points: values with x running slowest, or vectors as a last axis."""
    extent = ' '.join(f'0 {n - 1}' for n in dimensions)
    text = ['<?xml version="1.0"?>\n<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian">',
            f'<ImageData WholeExtent="{extent}" Origin="0 0 0" Spacing="{spacing} {spacing} {spacing}">',
            f'<Piece Extent="{extent}"><PointData>']
    for name, values in arrays.items():
        components = values.shape[3] if values.ndim == 4 else 1
        flat = values.reshape(*dimensions, components).transpose(2, 1, 0, 3).ravel()
        text.append(f'<DataArray type="Float32" Name="{name}" NumberOfComponents="{components}" format="ascii">')
        text.append(' '.join(f'{value:.5g}' for value in flat))
        text.append('</DataArray>')
    text.append('</PointData></Piece></ImageData></VTKFile>\n')
    return '\n'.join(text)


def flow(folder):
    """A vortex in a channel that drifts along x: flow_0.vti to flow_4.vti, and flow_other.vti of a second run."""
    dimensions = (33, 17, 17)
    x, y, z = numpy.meshgrid(*(0.125 * numpy.arange(n) for n in dimensions), indexing='ij')

    def step(center, strength):
        around_x, around_y = x - center, y - 1.0
        swirl = strength * numpy.exp(-4.0 * (around_x**2 + around_y**2))
        profile = 1.0 - (y - 1.0) ** 2 * 0.8
        u = numpy.stack([profile - swirl * around_y, swirl * around_x, 0.1 * numpy.sin(numpy.pi * z)], axis=-1)
        return {'p': 2.0 - 0.4 * x - 0.5 * swirl, 'U': u}

    for time in range(5):
        (folder / f'flow_{time}.vti').write_text(image_xml(dimensions, 0.125, step(0.8 + 0.6 * time, 2.0)))
    (folder / 'flow_other.vti').write_text(image_xml(dimensions, 0.125, step(3.2, 1.6)))


def beam(folder):
    """A bent beam of hexahedra with a side set, at three times: beam.e of Exodus."""
    n = (16, 4, 4)
    points = numpy.stack(numpy.meshgrid(*(numpy.arange(k + 1) * 0.25 for k in n), indexing='ij'), axis=-1)
    ids = 1 + numpy.arange(points.shape[0] * points.shape[1] * points.shape[2]).reshape(points.shape[:3])
    low, high = slice(None, -1), slice(1, None)
    corners = [ids[a, b, c].ravel() for a, b, c in ((low, low, low), (high, low, low), (high, high, low),
                                                    (low, high, low), (low, low, high), (high, low, high),
                                                    (high, high, high), (low, high, high))]
    cells = numpy.stack(corners, axis=1)
    flat = points.reshape(-1, 3)
    x, z = flat[:, 0], flat[:, 2] - 0.5
    file = netCDF4.Dataset(folder / 'beam.e', 'w', format='NETCDF3_64BIT_OFFSET')
    file.api_version = file.version = numpy.float32(8.03)
    file.floating_point_word_size, file.file_size, file.title = numpy.int32(8), numpy.int32(1), 'beam'
    names = ['dispx', 'dispy', 'dispz', 'bending', 'shear']
    sides = numpy.flatnonzero(flat[cells[:, 0] - 1, 0] == 0.0) + 1
    for name, size in (('len_string', 33), ('len_name', 33), ('time_step', None), ('num_dim', 3),
                       ('num_nodes', len(flat)), ('num_elem', len(cells)), ('num_el_blk', 1),
                       ('num_el_in_blk1', len(cells)), ('num_nod_per_el1', 8), ('num_nod_var', len(names)),
                       ('num_side_sets', 1), ('num_side_ss1', len(sides))):
        file.createDimension(name, size)

    def put(name, kind, dimensions, values):
        file.createVariable(name, kind, dimensions)[:] = values
        return file[name]

    def texts(words):
        return numpy.array([list(word.ljust(33, '\0')) for word in words], 'S1')

    put('eb_status', 'i4', ('num_el_blk',), 1)
    put('eb_prop1', 'i4', ('num_el_blk',), 1).setncattr('name', 'ID')
    put('ss_status', 'i4', ('num_side_sets',), 1)
    put('ss_prop1', 'i4', ('num_side_sets',), 1).setncattr('name', 'ID')
    put('ss_names', 'S1', ('num_side_sets', 'len_name'), texts(['clamp']))
    put('elem_ss1', 'i4', ('num_side_ss1',), sides)
    put('side_ss1', 'i4', ('num_side_ss1',), 4)
    for axis, name in enumerate('xyz'):
        put(f'coord{name}', 'f8', ('num_nodes',), flat[:, axis])
    put('connect1', 'i4', ('num_el_in_blk1', 'num_nod_per_el1'), cells).setncattr('elem_type', 'HEX8')
    put('name_nod_var', 'S1', ('num_nod_var', 'len_name'), texts(names))
    put('time_whole', 'f8', ('time_step',), [0.0, 0.5, 1.0])
    for number, name in enumerate(names):
        variable = file.createVariable(f'vals_nod_var{number + 1}', 'f8', ('time_step', 'num_nodes'))
        for step, load in enumerate((0.0, 0.5, 1.0)):
            bend = 0.02 * load
            value = {'dispx': -2.0 * bend * x * z, 'dispz': bend * x**2, 'bending': 200.0 * load * z * (4.0 - x),
                     'shear': 5.0 * load * (1.0 - 4.0 * z**2)}
            variable[step] = value.get(name, numpy.zeros(len(flat)))
    file.close()


def head(folder):
    """A scan, its segmentation, a stack of pictures and a raw volume of one head."""
    n = (48, 56, 40)
    i, j, k = numpy.meshgrid(*(numpy.arange(size) for size in n), indexing='ij')
    skull = numpy.sqrt(((i - 24) / 20) ** 2 + ((j - 28) / 25) ** 2 + ((k - 18) / 19) ** 2)
    tumor = numpy.sqrt((i - 15) ** 2 + (j - 34) ** 2 + (k - 20) ** 2) < 5
    noise = numpy.random.default_rng(1).normal(0.0, 8.0, n)
    values = numpy.where(skull > 1.0, -1000, numpy.where(skull > 0.88, 900, 40)) + numpy.where(tumor, 60, 0) + noise
    labels = numpy.where(skull > 1.0, 0, numpy.where(skull > 0.88, 1, 2))
    labels[tumor] = 3
    place = numpy.diag([4.0, 4.0, 4.5, 1.0])
    place[:3, 3] = -96, -112, -80
    nibabel.save(nibabel.Nifti1Image(values.astype(numpy.int16), place), folder / 'ct.nii')
    segmentation = nibabel.Nifti1Image(labels.astype(numpy.uint8), place)
    segmentation.header.set_intent('label')
    nibabel.save(segmentation, folder / 'labels.nii')
    pages = numpy.clip(values / 4 + 120, 0, 255).astype(numpy.uint8).transpose(2, 1, 0)
    tifffile.imwrite(folder / 'stack.tif', pages)
    (folder / 'volume.raw').write_bytes(pages.tobytes())


def make(folder):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    for part in (flow, beam, head):
        part(folder)


if __name__ == '__main__':
    make(sys.argv[1])
