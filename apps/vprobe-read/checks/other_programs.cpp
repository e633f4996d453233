#include "other_programs.h"

#include "file_head.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>

namespace vp::reader::checks
{

namespace
{

namespace fs = std::filesystem;

// A format that meshio reads and this program does not.
struct OtherMesh
{
	std::string_view ending;
	std::string_view what;
	std::string_view sign; // in the first bytes, where the ending alone says too little
};

constexpr std::array kOtherMeshes = {
    OtherMesh{".su2", "an SU2 mesh", ""},         OtherMesh{".bdf", "a Nastran file", ""},
    OtherMesh{".nas", "a Nastran file", ""},      OtherMesh{".fem", "a Nastran file", ""},
    OtherMesh{".mesh", "a Medit mesh", ""},       OtherMesh{".meshb", "a Medit mesh", ""},
    OtherMesh{".vol", "a Netgen mesh", "mesh3d"}, OtherMesh{".vol.gz", "a Netgen mesh", "\x1f\x8b"},
    OtherMesh{".inp", "an Abaqus file", "*"},     OtherMesh{".ele", "a TetGen mesh", ""},
    OtherMesh{".node", "a TetGen mesh", ""},      OtherMesh{".f3grid", "a FLAC3D grid", ""},
    OtherMesh{".mdpa", "a Kratos mesh", ""},      OtherMesh{".post", "a Permas file", ""},
    OtherMesh{".dato", "a Permas file", ""},      OtherMesh{".ugrid", "a UGRID mesh", ""},
    OtherMesh{".h5m", "a MOAB mesh", ""},
};

void refuseOtherMeshes(const FileHead& head)
{
	for (const OtherMesh& mesh : kOtherMeshes)
		if (head.ends({mesh.ending}) && (mesh.sign.empty() || head.has(std::string(mesh.sign).c_str())))
			throw Refusal(fmt::format("{}, which is not read; meshio convert {} {}.vtu makes a file that is", mesh.what,
			                          fs::path(head.file()).filename().string(),
			                          fs::path(head.file()).stem().string()));
	if (head.ends({".unv"}))
		throw Refusal("an I-deas universal file, which is not read; gmsh -save -format msh2 makes a .msh of it");
	if (head.ends({".cdb"}))
		throw Refusal("an Ansys archive, which is not read; PyMAPDL or its reader (mapdl-archive) saves it as .vtk");
}

} // namespace

void refuseOtherPrograms(const FileHead& head)
{
	if (!head.isFolder())
		refuseOtherMeshes(head);
}

} // namespace vp::reader::checks
