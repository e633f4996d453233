#include "cells_by_faces.h"

#include "cell_of_faces.h"
#include "grown_cells.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace vp::reader::cells
{

namespace
{

// Lists the faces of all cells, one cell after the other.
struct FacesByCell
{
	explicit FacesByCell(const CellsByFaces& mesh) : starts(mesh.cells + 1)
	{
		const auto each = [&](const auto& take)
		{
			for (const auto& side : {mesh.first, mesh.second})
				for (std::size_t face = 0; face < side.size(); ++face)
					if (side[face] >= 0)
						take(static_cast<std::size_t>(side[face]), face);
		};
		each([&](std::size_t cell, std::size_t) { ++starts[cell + 1]; });
		for (std::size_t cell = 0; cell < mesh.cells; ++cell)
			starts[cell + 1] += starts[cell];
		faces.resize(starts.back());
		std::vector<std::size_t> at = starts;
		each([&](std::size_t cell, std::size_t face) { faces[at[cell]++] = face; });
	}

	std::vector<std::size_t> starts, faces;
};

} // namespace

void addCellsByFaces(GrownCells& grown, const CellsByFaces& mesh)
{
	const FacesByCell of(mesh);
	std::vector<FaceCorners> faces;
	for (std::size_t cell = 0; cell < mesh.cells; ++cell)
	{
		const std::size_t count = of.starts[cell + 1] - of.starts[cell];
		if (count < 4)
			throw damaged(fmt::format("cell {} has {} faces", cell, count));
		faces.resize(count);
		for (std::size_t i = 0; i < count; ++i)
		{
			const std::size_t face = of.faces[of.starts[cell] + i];
			const auto begin = mesh.corners.begin() + mesh.starts[face];
			const auto end = mesh.corners.begin() + mesh.starts[face + 1];
			if (end - begin < 3)
				throw damaged(fmt::format("face {} has {} corners", face, end - begin));
			faces[i].assign(begin, end);
			if (mesh.first[face] != static_cast<std::int64_t>(cell))
				std::reverse(faces[i].begin(), faces[i].end());
		}
		addCellOfFaces(grown, faces);
	}
}

} // namespace vp::reader::cells
