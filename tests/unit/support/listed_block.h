#pragma once

#include "test_grids.h"

namespace vp::test
{

/// The unstructured grid of a block as a list, cells and points by the numbers that they have there, with the fields of
/// addTestFields() alone. Id: of 32 or 64 bits.
template <class Id = std::int64_t>
grid::Block listedBlock(const grid::Block& block)
{
	const auto& grid = std::get<grid::UnstructuredGrid>(block.grid);
	constexpr std::uint8_t kTypes[] = {grid::kTetra, grid::kPyramid, grid::kWedge, grid::kHexahedron,
	                                   grid::kPolyhedron};
	std::vector<std::uint8_t> types;
	std::vector<std::int64_t> offsets{0};
	std::vector<Id> ids;
	std::vector<std::int64_t> face_offsets{0};
	std::vector<std::int64_t> face_stream;
	for (CellId c = 0; c < grid.cellCount(); ++c)
	{
		types.push_back(kTypes[static_cast<std::size_t>(grid.shape(c))]);
		if (grid.shape(c) == grid::CellShape::polyhedron)
		{
			grid::CellFaces faces;
			grid.cellFaces(c, faces);
			face_stream.push_back(faces.size());
			for (int f = 0; f < faces.size(); ++f)
			{
				face_stream.push_back(static_cast<std::int64_t>(faces[f].size()));
				face_stream.insert(face_stream.end(), faces[f].begin(), faces[f].end());
			}
		}
		else
			for (const PointId p : grid.cellPoints(c))
				ids.push_back(static_cast<Id>(p));
		offsets.push_back(static_cast<std::int64_t>(ids.size()));
		face_offsets.push_back(static_cast<std::int64_t>(face_stream.size()));
	}
	grid::CellList list;
	list.types = std::move(types);
	list.offsets = std::move(offsets);
	list.connectivity = std::move(ids);
	if (!face_stream.empty())
	{
		list.face_offsets = std::move(face_offsets);
		list.face_stream = std::move(face_stream);
	}
	grid::Block listed;
	listed.name = block.name;
	listed.grid = grid::UnstructuredGrid::listed(grid.coordinates(), std::move(list));
	addTestFields(listed);
	finishBlock(listed);
	return listed;
}

} // namespace vp::test
