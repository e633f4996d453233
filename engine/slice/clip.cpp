#include "slice/clip.h"

#include "slice/key_numbers.h"

#include <algorithm>
#include <unordered_map>

namespace vp::slice
{

namespace
{

// Clips a mesh at one side of a window after the other.
class Clipper
{
public:
	Clipper(const probe::Sheet& content, Corners corners, SheetMesh& mesh)
	    : content_(content), corners_(corners), mesh_(mesh)
	{
	}

	void clip()
	{
		const probe::Window& window = *content_.window;
		clipAt(content_.xAxis(), window.x0);
		clipAt(-content_.xAxis(), -window.x1);
		clipAt(content_.up, window.y0);
		clipAt(-content_.up, -window.y1);
		dropUnusedVertices(mesh_);
	}

private:
	// Keeps what lies at least `least` along the axis.
	void clipAt(const Vec3& axis, double least)
	{
		beyond_.clear();
		for (const Vec3& p : mesh_.positions)
			beyond_.push_back(glm::dot(p - content_.origin, axis) - least);
		if (std::ranges::all_of(beyond_, [](double d) { return d >= 0.0; }))
			return;
		const std::size_t first_new = mesh_.positions.size();
		KeyNumbers cuts(16);
		RawVector<std::uint32_t> starts{0};
		RawVector<std::uint32_t> vertices;
		std::size_t kept = 0;
		const std::size_t of_cells = mesh_.polygons() - mesh_.boundary_polygons;
		for (std::size_t p = 0; p < mesh_.polygons(); ++p)
		{
			const std::size_t begin = vertices.size();
			const bool has_corner = clipPolygon(mesh_.polygon(p), cuts, vertices);
			if (vertices.size() - begin < 3 || (has_corner && corners_ == Corners::skip))
			{
				vertices.resize(begin);
				mesh_.boundary_polygons -= p >= of_cells;
				continue;
			}
			mesh_.polygon_cells[kept++] = mesh_.polygon_cells[p];
			starts.push_back(static_cast<std::uint32_t>(vertices.size()));
		}
		mesh_.polygon_cells.resize(kept);
		mesh_.polygon_starts = std::move(starts);
		mesh_.polygon_vertices = std::move(vertices);
		pairAcrossSeams(cuts, first_new);
	}

	// Returns whether a corner of the window became a vertex: an edge of the rim was cut.
	bool clipPolygon(std::span<const std::uint32_t> polygon, KeyNumbers& cuts, RawVector<std::uint32_t>& clipped)
	{
		bool has_corner = false;
		const std::size_t begin = clipped.size();
		const auto add = [&](std::uint32_t v)
		{
			if (clipped.size() == begin || clipped.back() != v)
				clipped.push_back(v);
		};
		std::uint32_t previous = polygon.back();
		for (const std::uint32_t v : polygon)
		{
			// A vertex on the side itself is its own cut.
			if ((beyond_[previous] < 0.0 && beyond_[v] > 0.0) || (beyond_[previous] > 0.0 && beyond_[v] < 0.0))
			{
				add(cutOf(std::min(previous, v), std::max(previous, v), cuts));
				has_corner = has_corner || (isOnRim(previous) && isOnRim(v));
			}
			if (beyond_[v] >= 0.0)
				add(v);
			previous = v;
		}
		while (clipped.size() > begin + 1 && clipped.back() == clipped[begin])
			clipped.pop_back();
		return has_corner;
	}

	bool isOnRim(std::uint32_t v) const { return v >= mesh_.edges.size(); }

	// The vertex where the edge between two crosses the side, always interpolated from the lower.
	std::uint32_t cutOf(std::uint32_t lower, std::uint32_t higher, KeyNumbers& cuts)
	{
		const auto next = static_cast<std::uint32_t>(mesh_.positions.size());
		const auto [number, is_new] = cuts.find(std::uint64_t(lower) << 32 | higher, next);
		if (is_new)
		{
			const double t = beyond_[lower] / (beyond_[lower] - beyond_[higher]);
			mesh_.positions.push_back(mesh_.positions[lower] + t * (mesh_.positions[higher] - mesh_.positions[lower]));
			addShares(lower, 1.0 - t);
			addShares(higher, t);
			mesh_.rim_starts.push_back(static_cast<std::uint32_t>(mesh_.rim_shares.size()));
			ends_.emplace_back(lower, higher);
		}
		return number;
	}
	void addShares(std::uint32_t v, double weight)
	{
		if (!isOnRim(v))
		{
			const EdgePoint& edge = mesh_.edges[v];
			// An end without a part does not bring its NaN.
			if (edge.t != 1.0)
				mesh_.rim_shares.push_back({edge.block, edge.lower, weight * (1.0 - edge.t)});
			if (edge.t != 0.0)
				mesh_.rim_shares.push_back({edge.block, edge.higher, weight * edge.t});
			return;
		}
		const std::size_t rim = v - mesh_.edges.size();
		for (std::uint32_t s = mesh_.rim_starts[rim]; s < mesh_.rim_starts[rim + 1]; ++s)
		{
			PointShare share = mesh_.rim_shares[s];
			share.weight *= weight;
			mesh_.rim_shares.push_back(share);
		}
	}

	// Where an edge lies on another across a seam, and both are cut, the cuts are a pair as their ends are.
	void pairAcrossSeams(KeyNumbers& cuts, std::size_t first_new)
	{
		if (mesh_.seam_pairs.empty())
			return;
		std::unordered_multimap<std::uint32_t, std::uint32_t> partners;
		for (const auto& [v, w] : mesh_.seam_pairs)
		{
			partners.emplace(v, w);
			partners.emplace(w, v);
		}
		const auto made = static_cast<std::uint32_t>(mesh_.positions.size());
		for (auto v = static_cast<std::uint32_t>(first_new); v < made; ++v)
		{
			const auto& [a, b] = ends_[v - mesh_.edges.size()];
			const auto [a_begin, a_end] = partners.equal_range(a);
			const auto [b_begin, b_end] = partners.equal_range(b);
			for (auto other_a = a_begin; other_a != a_end; ++other_a)
				for (auto other_b = b_begin; other_b != b_end; ++other_b)
				{
					const auto [lower, higher] = std::minmax(other_a->second, other_b->second);
					const auto found = cuts.find(std::uint64_t(lower) << 32 | higher, made);
					if (!found.is_new && found.number > v && found.number < made)
						mesh_.seam_pairs.emplace_back(v, found.number);
				}
		}
	}

	const probe::Sheet& content_;
	Corners corners_;
	SheetMesh& mesh_;
	std::vector<double> beyond_;                                // per vertex: how far it lies within the side
	std::vector<std::pair<std::uint32_t, std::uint32_t>> ends_; // per rim vertex: the edge it cuts
};

} // namespace

void clipToWindow(const probe::Sheet& content, Corners corners, SheetMesh& mesh)
{
	Clipper(content, corners, mesh).clip();
}

} // namespace vp::slice
