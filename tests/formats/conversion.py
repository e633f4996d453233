"""What `vprobe convert` writes gives the same figures as what it was made from."""
import os
import pathlib
import subprocess

from against import VPROBE, Missing, compare, info, lattice, mixed_mesh, need, nrrd, vprobe


def reread(path, out, *options):
    """What was converted gives the same figures as what it was made from."""
    vprobe('convert', path, '-o', out, *options)
    arrays = [f'{a["association"]}:{a["name"]}' for a in info(path)['arrays'][:1]]
    compare(out, path, [(a, a) for a in arrays], tolerance=1e-6)


def convert(folder):
    meshio, numpy = need('meshio'), need('numpy')
    mesh = folder / 'mesh.msh'
    meshio.write(mesh, mixed_mesh(meshio, numpy), file_format='gmsh22')
    for ending in ('vtu', 'vtm', 'vtkhdf'):
        reread(mesh, folder / f'mesh.{ending}')
    image = nrrd(folder, lattice(numpy))
    for ending in ('vti', 'vtm', 'vtkhdf'):
        reread(image, folder / f'image.{ending}')
    vprobe('convert', mesh, '-o', folder / 'one.vtu', '--array', 'f')
    assert [a['name'] for a in info(folder / 'one.vtu')['arrays']] == ['f']
    for out, why in (('mesh.vti', 'is written as .vtu'), ('mesh.stl', 'is written as one of')):
        done = subprocess.run([VPROBE, 'convert', mesh, '-o', folder / out], capture_output=True, encoding='utf-8')
        assert done.returncode in (1, 2, 4) and why in done.stderr, done
        assert not (folder / out).exists()
    # A set takes the place of another, and leaves none of its pieces behind.
    pieces = len(list((folder / 'mesh').iterdir()))
    reread(mesh, folder / 'mesh.vtm')
    assert len(list((folder / 'mesh').iterdir())) == pieces


REFERENCE_SETS = """voxel/ironProt/ironProt.vtk voxel/HeadMRVolume/HeadMRVolume.mhd uniform/carotid/carotid.vtk
rectilinear/RectGrid2/RectGrid2.vtk structured/bluntfin/bluntfinxyz.bin structured/SampleStructGrid/SampleStructGrid.vtk
structured/office/office.binary.vtk multiblock/multi_bin/multi-bin-C.xyz unstructured/hexa/hexa.vtk
unstructured/uGridEx/uGridEx.vtk unstructured/disk_out_ref/disk_out_ref.ex2 unstructured/post_tets/post.vtk
unstructured/box_hybrid/box_hybrid_mesh.vtu polyhedral/pebi3d/pebi3d_with_properties.vtu time/mug/mug.e
voxel/headsq/headsq/quarter.nhdr multiblock/5blocks_struc/5blocks-struc.cgns multiblock/sqnz/sqnz_s.adf.cgns
polyhedral/ensight_nfaced/TEST_bin.case polyhedral/flange/flange.foam
amr/HierarchicalBox/HierarchicalBoxDataset.v1.1.vthb amr/chombo3d/chombo3d.vtm time/can_hdf/can_1.hdf
formats/cavity_foam/case.foam formats/office_ensight/office_bin.case higher-order/notch_disp/notch_disp.vtu""".split()


def convert_reference_sets(folder):
    if 'VPROBE_DATA' not in os.environ:
        raise Missing('VPROBE_DATA')
    for number, name in enumerate(REFERENCE_SETS):
        path = pathlib.Path(os.environ['VPROBE_DATA']) / name
        place = folder / str(number)
        place.mkdir()
        # Beside the link to the set, so that nothing is written there.
        (place / 'set').symlink_to(path.parent)
        link, out = place / 'set' / path.name, place / 'out.vtm'
        try:
            reread(link, out)
        except AssertionError as error:
            raise AssertionError(f'{name}: {error}') from None


CASES = [convert, convert_reference_sets]
