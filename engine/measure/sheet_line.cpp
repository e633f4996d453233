#include "measure/sheet_line.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vp::measure
{

namespace
{

// Nearer to the line than this part of the mesh's extent a vertex lies on it.
constexpr double kOnLine = 1e-12;

class LineWalk
{
public:
	LineWalk(const mesh::SheetMesh& mesh, std::span<const glm::dvec2> points, const glm::dvec2& a, const glm::dvec2& b)
	    : mesh_(mesh), off_(points.size()), along_(points.size())
	{
		const glm::dvec2 way = b - a;
		const double length = glm::length(way);
		double extent = length;
		for (const glm::dvec2& p : points)
			extent = std::max(extent, glm::length(p - a));
		for (std::size_t v = 0; v < points.size(); ++v)
		{
			const glm::dvec2 from = points[v] - a;
			off_[v] = (way.x * from.y - way.y * from.x) / length;
			if (std::abs(off_[v]) <= kOnLine * extent)
				off_[v] = 0.0;
			along_[v] = glm::dot(from, way) / (length * length);
		}
	}

	std::vector<LinePiece> pieces() const
	{
		std::vector<LinePiece> found;
		for (std::size_t p = 0; p < mesh_.polygons(); ++p)
			add(
			    p, [](double off) { return off >= 0.0; }, found);
		sort(found);
		// Pieces that the line only touches from the other side, at the rim of the slice.
		std::vector<LinePiece> touched;
		for (std::size_t p = 0; p < mesh_.polygons(); ++p)
			if (std::ranges::any_of(mesh_.polygon(p), [&](std::uint32_t v) { return off_[v] == 0.0; }))
				add(
				    p, [](double off) { return off > 0.0; }, touched);
		std::vector<LinePiece> all = withoutOverlap(found);
		std::erase_if(touched, [&](const LinePiece& piece) { return isCovered(0.5 * (piece.from + piece.to), all); });
		all.insert(all.end(), touched.begin(), touched.end());
		sort(all);
		return withoutOverlap(all);
	}

private:
	static void sort(std::vector<LinePiece>& pieces)
	{
		std::ranges::stable_sort(pieces, {}, [](const LinePiece& piece) { return piece.enter.t; });
	}

	template <class Above>
	void add(std::size_t p, const Above& above, std::vector<LinePiece>& pieces) const
	{
		const auto polygon = mesh_.polygon(p);
		std::vector<SideCrossing> crossings;
		for (std::size_t i = 0; i < polygon.size(); ++i)
		{
			std::uint32_t a = polygon[i];
			std::uint32_t b = polygon[(i + 1) % polygon.size()];
			if (above(off_[a]) == above(off_[b]))
				continue;
			if (off_[a] < off_[b])
				std::swap(a, b);
			const double part = off_[a] / (off_[a] - off_[b]); // the same from the polygon beyond
			crossings.push_back({a, b, part, along_[a] + part * (along_[b] - along_[a])});
		}
		std::ranges::sort(crossings, {}, &SideCrossing::t);
		for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
		{
			LinePiece piece{static_cast<std::uint32_t>(p), std::max(0.0, crossings[i].t),
			                std::min(1.0, crossings[i + 1].t), crossings[i], crossings[i + 1]};
			if (piece.to > piece.from)
				pieces.push_back(piece);
		}
	}

	static std::vector<LinePiece> withoutOverlap(const std::vector<LinePiece>& sorted)
	{
		std::vector<LinePiece> kept;
		for (LinePiece piece : sorted)
		{
			if (!kept.empty() && piece.to <= kept.back().to + kLineGap)
				if (piece.from < kept.back().to - kLineGap || piece.to <= kept.back().to)
					continue;
			if (!kept.empty() && piece.from < kept.back().to)
				piece.from = kept.back().to;
			kept.push_back(piece);
		}
		return kept;
	}

	static bool isCovered(double t, const std::vector<LinePiece>& sorted)
	{
		const auto after = std::ranges::upper_bound(sorted, t, {}, &LinePiece::from);
		return after != sorted.begin() && std::prev(after)->to >= t;
	}

	const mesh::SheetMesh& mesh_;
	std::vector<double> off_;   // per vertex: its distance to the left of the line
	std::vector<double> along_; // per vertex: its place along the line, 0 to 1
};

} // namespace

std::vector<LinePiece> alongLine(const mesh::SheetMesh& mesh, std::span<const glm::dvec2> points, const glm::dvec2& a,
                                 const glm::dvec2& b)
{
	return LineWalk(mesh, points, a, b).pieces();
}

} // namespace vp::measure
