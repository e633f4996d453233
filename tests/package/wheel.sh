#!/usr/bin/env bash
# Makes the wheel of a build, installs it into a new virtual environment, and cuts with it: numpy arrays, a file, and
# VTK's data sets where there are such.
# usage: wheel.sh BUILD_FOLDER SCRATCH_FOLDER PYTHON
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
build=$1 scratch=$2 python=$3
for module in build setuptools wheel venv ensurepip; do
	"$python" -c "import $module" 2>/dev/null || { echo "no $module for $python, so no wheel"; exit 77; }
done
rm -rf "$scratch"
mkdir -p "$scratch"
VPROBE_BUILD=$build "$python" -m build --wheel --no-isolation --outdir "$scratch" "$here/../../apps/python" \
	>"$scratch/build.log" 2>&1 || { cat "$scratch/build.log"; exit 1; }
wheel=$(basename "$scratch"/*.whl)
[[ $wheel == vprobe-*-linux_x86_64.whl ]] || { echo "$wheel has another name than it should"; exit 1; }
"$python" -m venv --system-site-packages "$scratch/venv"
"$scratch/venv/bin/pip" install --quiet --no-index --no-deps "$scratch/$wheel"
cat >"$scratch/ramp.vti" <<'END'
<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian">
<ImageData WholeExtent="0 1 0 1 0 1" Origin="0 0 0" Spacing="1 1 1"><Piece Extent="0 1 0 1 0 1">
<PointData><DataArray type="Float32" Name="p" format="ascii">0 1 0 1 0 1 0 1</DataArray></PointData>
</Piece></ImageData></VTKFile>
END
cat >"$scratch/use.py" <<'END'
import pathlib, numpy, vprobe
folder = pathlib.Path(vprobe.__file__).parent
assert 'venv' in folder.parts, folder
mapped = {line.split()[-1] for line in open('/proc/self/maps') if 'libvprobe' in line}
assert mapped == {str(folder / 'libvprobe.so.0')}, mapped
z, y, x = numpy.mgrid[0:5, 0:5, 0:5].astype(float)
assert vprobe.image({'p': x}).slice(normal='x').mean == 2
assert abs(vprobe.open('ramp.vti').slice(normal='x').mean - .5) < 1e-6
try:
    from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
except ImportError:
    pass
else:
    source = vtkRTAnalyticSource()
    source.Update()
    assert vprobe.wrap(source.GetOutput()).slice().area == 400
print(vprobe.__version__)
END
(cd "$scratch" && env -u PYTHONPATH -u LD_LIBRARY_PATH venv/bin/python use.py)
