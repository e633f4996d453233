#pragma once

#include "mesh/sheet_mesh.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vp::mesh
{

/// The polygons of a mesh as their cells have them: without the corners that joins have added. Figures are taken from
/// these, so a join changes none. The mesh must outlive it.
class OwnPolygons
{
public:
	explicit OwnPolygons(const SheetMesh& mesh) : starts_(mesh.polygon_starts), vertices_(mesh.polygon_vertices)
	{
		if (mesh.is_added.empty())
			return;
		kept_starts_.push_back(0);
		for (std::size_t p = 0; p < mesh.polygons(); ++p)
		{
			for (std::uint32_t corner = mesh.polygon_starts[p]; corner < mesh.polygon_starts[p + 1]; ++corner)
				if (!mesh.is_added[corner])
					kept_.push_back(mesh.polygon_vertices[corner]);
			kept_starts_.push_back(static_cast<std::uint32_t>(kept_.size()));
		}
		starts_ = kept_starts_;
		vertices_ = kept_;
		is_corner_.resize(mesh.positions.size());
		for (const std::uint32_t v : kept_)
			is_corner_[v] = 1;
	}
	OwnPolygons(const OwnPolygons&) = delete;
	OwnPolygons& operator=(const OwnPolygons&) = delete;

	std::span<const std::uint32_t> operator[](std::size_t polygon) const
	{
		return vertices_.subspan(starts_[polygon], starts_[polygon + 1] - starts_[polygon]);
	}
	/// Returns true if a polygon has the vertex as a corner of its own.
	bool isCorner(std::size_t vertex) const { return is_corner_.empty() || is_corner_[vertex] != 0; }

private:
	std::vector<std::uint32_t> kept_starts_;
	std::vector<std::uint32_t> kept_;
	std::vector<std::uint8_t> is_corner_;
	std::span<const std::uint32_t> starts_;
	std::span<const std::uint32_t> vertices_;
};

} // namespace vp::mesh
