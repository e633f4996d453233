#include "grid/patches.h"

#include "base/place_key.h"
#include "grid/block.h"

#include <algorithm>
#include <tuple>
#include <unordered_map>

namespace vp::grid
{

namespace
{

bool before(const Vec3& a, const Vec3& b)
{
	return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

// The places of a face's corners, each once, in an order of their own.
class Corners
{
public:
	void clear() { places_.clear(); }
	void add(const Vec3& place) { places_.push_back(place); }
	void finish()
	{
		std::ranges::sort(places_, before);
		places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
	}
	std::uint64_t key() const
	{
		std::uint64_t sum = places_.size();
		for (const Vec3& place : places_)
			sum += placeKey(place);
		return sum;
	}
	bool operator==(const Corners&) const = default;

private:
	std::vector<Vec3> places_;
};

class PatchFinder
{
public:
	explicit PatchFinder(std::span<const PatchPolygons> polygons) : polygons_(polygons)
	{
		Corners corners;
		for (std::uint32_t patch = 0; patch < polygons.size(); ++patch)
			for (std::size_t p = 0; p < polygons[patch].polygons(); ++p)
			{
				cornersOf(patch, p, corners);
				wanted_.emplace(corners.key(), Wanted{patch, p});
			}
	}

	std::vector<Patch> find(const BlockSet& blocks)
	{
		std::vector<Patch> patches;
		for (const PatchPolygons& polygons : polygons_)
			patches.push_back({polygons.name, {}, polygons.polygons()});
		for (std::uint32_t b = 0; b < blocks.blocks.size(); ++b)
			std::visit([&](const auto& grid) { addBlock(grid, b, blocks.blocks[b].boundary, patches); },
			           blocks.blocks[b].grid);
		return patches;
	}

private:
	struct Wanted
	{
		std::uint32_t patch;
		std::size_t polygon;
	};

	void cornersOf(std::uint32_t patch, std::size_t polygon, Corners& corners) const
	{
		const PatchPolygons& from = polygons_[patch];
		corners.clear();
		for (std::int64_t i = from.starts[polygon]; i < from.starts[polygon + 1]; ++i)
			corners.add(from.points[static_cast<std::size_t>(from.corners[static_cast<std::size_t>(i)])]);
		corners.finish();
	}

	template <Grid G>
	void addBlock(const G& grid, std::uint32_t block, const BoundaryIndex& boundary, std::vector<Patch>& patches)
	{
		CellFaces faces;
		Corners corners;
		Corners others;
		for (const BoundaryIndex::Face& face : boundary.faces)
		{
			grid.cellFaces(face.cell, faces);
			corners.clear();
			for (const PointId p : faces[static_cast<int>(face.face)])
				corners.add(grid.point(p));
			corners.finish();
			// A face may be in several patches; each of its polygons is found once.
			for (auto [at, end] = wanted_.equal_range(corners.key()); at != end;)
			{
				cornersOf(at->second.patch, at->second.polygon, others);
				if (!(others == corners))
				{
					++at;
					continue;
				}
				Patch& patch = patches[at->second.patch];
				patch.faces.push_back({block, face.cell, face.face});
				--patch.lost;
				at = wanted_.erase(at);
			}
		}
	}

	std::span<const PatchPolygons> polygons_;
	std::unordered_multimap<std::uint64_t, Wanted> wanted_;
};

} // namespace

std::vector<Patch> findPatches(const BlockSet& blocks, std::span<const PatchPolygons> polygons)
{
	if (polygons.empty())
		return {};
	return PatchFinder(polygons).find(blocks);
}

std::vector<Patch::Face> facesOfPatches(const BlockSet& blocks, const std::string& name, std::uint32_t block)
{
	std::vector<Patch::Face> faces;
	for (const Patch& patch : blocks.patches)
		if (patch.name == name)
			std::ranges::copy_if(patch.faces, std::back_inserter(faces),
			                     [&](const Patch::Face& face) { return face.block == block; });
	return faces;
}

} // namespace vp::grid
