#include "cell_of_faces.h"

#include "grown_cells.h"
#include "read/cell_types.h"

#include <vtkCellType.h>

#include <algorithm>

namespace vp::reader::cells
{

namespace
{

bool holdsCorner(const FaceCorners& face, vtkIdType corner)
{
	return std::find(face.begin(), face.end(), corner) != face.end();
}

// Returns the corner at the other end of the edge that leaves `base` at a corner. Returns -1 unless there is exactly
// one.
vtkIdType cornerOver(std::span<const FaceCorners> faces, const FaceCorners& base, vtkIdType corner)
{
	vtkIdType found = -1;
	for (const FaceCorners& face : faces)
	{
		const auto at = std::find(face.begin(), face.end(), corner);
		if (&face == &base || at == face.end())
			continue;
		const auto after = at + 1 == face.end() ? face.begin() : at + 1;
		const auto before = at == face.begin() ? face.end() - 1 : at - 1;
		for (const vtkIdType other : {*after, *before})
			if (!holdsCorner(base, other))
			{
				if (found >= 0 && found != other)
					return -1;
				found = other;
			}
	}
	return found;
}

// Returns VTK's type for a cell with so many corners, triangles and quads, or 0 if there is none.
int solidTypeOf(std::size_t corners, std::size_t triangles, std::size_t quads, std::size_t faces)
{
	if (triangles + quads != faces)
		return 0;
	if (corners == 4 && triangles == 4 && quads == 0)
		return VTK_TETRA;
	if (corners == 5 && triangles == 4 && quads == 1)
		return VTK_PYRAMID;
	if (corners == 6 && triangles == 2 && quads == 3)
		return VTK_WEDGE;
	return corners == 8 && triangles == 0 && quads == 6 ? VTK_HEXAHEDRON : 0;
}

// Returns the corners in VTK's order: a base, seen from inside, then the corners over it. Returns an empty list if the
// faces do not fit.
std::vector<vtkIdType> cornersInOrder(int type, std::span<const FaceCorners> faces, std::span<const vtkIdType> all)
{
	const std::size_t wanted = type == VTK_PYRAMID || type == VTK_HEXAHEDRON ? 4 : 3;
	const auto base = std::ranges::find_if(faces, [&](const FaceCorners& f) { return f.size() == wanted; });
	std::vector<vtkIdType> corners(base->rbegin(), base->rend());
	if (type == VTK_TETRA || type == VTK_PYRAMID)
	{
		for (const vtkIdType corner : all)
			if (!holdsCorner(*base, corner))
				corners.push_back(corner);
	}
	else
		for (std::size_t i = 0; i < wanted; ++i)
			corners.push_back(cornerOver(faces, *base, corners[i]));
	std::vector<vtkIdType> sorted = corners;
	std::ranges::sort(sorted);
	if (!std::ranges::equal(sorted, all))
		corners.clear();
	return corners;
}

} // namespace

void addCellOfFaces(GrownCells& cells, std::span<const FaceCorners> faces)
{
	std::vector<vtkIdType> all; // each once, ascending
	std::size_t triangles = 0, quads = 0;
	for (const FaceCorners& face : faces)
	{
		all.insert(all.end(), face.begin(), face.end());
		triangles += face.size() == 3;
		quads += face.size() == 4;
	}
	std::ranges::sort(all);
	all.erase(std::unique(all.begin(), all.end()), all.end());
	if (const int type = solidTypeOf(all.size(), triangles, quads, faces.size()))
		if (const std::vector<vtkIdType> corners = cornersInOrder(type, faces, all); !corners.empty())
		{
			for (const vtkIdType corner : corners)
				cells.addPoint(corner);
			cells.endCell(static_cast<std::uint8_t>(type));
			return;
		}
	std::vector<vtkIdType> stream = {static_cast<vtkIdType>(faces.size())};
	for (const FaceCorners& face : faces)
	{
		stream.push_back(static_cast<vtkIdType>(face.size()));
		stream.insert(stream.end(), face.begin(), face.end());
	}
	for (const vtkIdType corner : all)
		cells.addPoint(corner);
	cells.addFaces(stream);
	cells.endCell(read::kPolyhedron);
}

} // namespace vp::reader::cells
