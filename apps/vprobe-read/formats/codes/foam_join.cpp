#include "foam_join.h"

#include "vprobe-read/base/refusal.h"

#include "base/union_find.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <string>

namespace vp::reader::codes
{

namespace
{

constexpr std::int64_t kNone = -1;

bool isBetweenParts(const FoamPatch& patch)
{
	return patch.type.starts_with("processor") && patch.cyclic.empty();
}

// The name of its patch in the whole.
const std::string& nameInWhole(const FoamPatch& patch)
{
	return patch.cyclic.empty() ? patch.name : patch.cyclic;
}

double distance(const double* a, const double* b)
{
	return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// The last digits of a text may differ.
double lastDigitsOf(const double* place)
{
	return 1e-5 * std::max({std::abs(place[0]), std::abs(place[1]), std::abs(place[2])});
}

// Corners are one if they differ by less: a thousandth of the face, and the last digits.
double tolerance(const FoamMesh& mesh, std::span<const std::int64_t> corners)
{
	double size = 0.0;
	const double* first = mesh.points.at(static_cast<std::size_t>(corners[0]));
	for (const std::int64_t corner : corners)
		size = std::max(size, distance(first, mesh.points.at(static_cast<std::size_t>(corner))));
	return 1e-3 * size + lastDigitsOf(first);
}

class Join
{
public:
	Join(FoamRegion& region, std::vector<FoamNumbers> told)
	    : region_(region), parts_(region.parts), told_(std::move(told))
	{
		for (const FoamMesh& part : parts_)
		{
			first_points_.push_back(first_points_.back() + part.points.size());
			cells_ += part.cells;
		}
		if (first_points_.back() > std::numeric_limits<std::uint32_t>::max())
			throw Refusal("more than 4294967295 points in its parts; put it together with reconstructPar");
	}

	void make()
	{
		for (std::size_t p = 0; p < parts_.size(); ++p)
			checkPatches(p);
		UnionFind joined(first_points_.back());
		findPairs();
		for (const Pair& pair : pairs_)
			joinPoints(pair, joined);
		region_.has_numbers = fits(joined);
		if (region_.has_numbers)
			region_.numbers = std::move(told_);
		else
			count(joined);
		addPoints();
		addFacesInside();
		for (const Pair& pair : pairs_)
			addFacesBetween(pair);
		addPatches();
		region_.mesh.cells = cells_;
	}

private:
	// The faces between two parts, as patches of both.
	struct Pair
	{
		std::size_t a, b; // a before b
		const FoamPatch *patch_a, *patch_b;
	};

	// The patches of a part follow each other, behind the faces between its cells.
	void checkPatches(std::size_t p)
	{
		auto next = static_cast<std::int64_t>(parts_[p].neighbours.size());
		for (const FoamPatch& patch : parts_[p].patches)
		{
			if (patch.first != next)
				throw damaged(fmt::format("patch {} of processor {} does not follow the one before it", patch.name, p));
			next += patch.faces;
		}
		if (next != static_cast<std::int64_t>(parts_[p].faces.size()))
			throw damaged(fmt::format("the patches of processor {} do not have all faces of its boundary", p));
	}

	void findPairs()
	{
		std::map<std::pair<std::size_t, std::size_t>, std::vector<const FoamPatch*>> sides; // by part and part behind
		for (std::size_t p = 0; p < parts_.size(); ++p)
			for (const FoamPatch& patch : parts_[p].patches)
				if (isBetweenParts(patch) && patch.faces > 0)
					sides[{p, static_cast<std::size_t>(patch.part_behind)}].push_back(&patch);
		for (const auto& [key, patches] : sides)
		{
			const auto [a, b] = key;
			const auto other = sides.find({b, a});
			bool is_pair = a != b && other != sides.end() && other->second.size() == patches.size();
			for (std::size_t i = 0; is_pair && i < patches.size(); ++i)
			{
				is_pair = patches[i]->faces == other->second[i]->faces;
				if (a < b)
					pairs_.push_back({a, b, patches[i], other->second[i]});
			}
			if (!is_pair)
				throw damaged(fmt::format("the parts of processors {} and {} do not have the same faces between them",
				                          std::int64_t(a), patches[0]->part_behind));
		}
	}

	// Both sides name the corners of a face from the same one on, in opposite directions.
	void joinPoints(const Pair& pair, UnionFind& joined)
	{
		const FoamMesh &a = parts_[pair.a], &b = parts_[pair.b];
		for (std::int64_t i = 0; i < pair.patch_a->faces; ++i)
		{
			const auto of_a = a.faces[static_cast<std::size_t>(pair.patch_a->first + i)];
			const auto of_b = b.faces[static_cast<std::size_t>(pair.patch_b->first + i)];
			const std::size_t n = of_a.size();
			bool is_one = n == of_b.size() && n > 0;
			const double near = is_one ? tolerance(a, of_a) : 0.0;
			for (std::size_t c = 0; is_one && c < n; ++c)
			{
				const auto point_a = static_cast<std::size_t>(of_a[c]),
				           point_b = static_cast<std::size_t>(of_b[(n - c) % n]);
				is_one = distance(a.points.at(point_a), b.points.at(point_b)) <= near;
				joined.join(static_cast<std::uint32_t>(first_points_[pair.a] + point_a),
				            static_cast<std::uint32_t>(first_points_[pair.b] + point_b));
			}
			if (!is_one)
				throw damaged(fmt::format("face {} between the parts of processors {} and {} has other corners in each",
				                          i, pair.a, pair.b));
		}
	}

	// Whether the numbers that the case tells are those of one whole, with points joined as the faces say.
	bool fits(UnionFind& joined) const
	{
		std::vector<bool> has_cell(cells_);
		std::vector<std::int64_t> point_of_number(first_points_.back(), kNone);
		std::size_t points = 0, end = 0;
		for (std::size_t p = 0; p < parts_.size(); ++p)
		{
			const FoamNumbers& numbers = told_[p];
			if (numbers.points.size() != parts_[p].points.size() || numbers.cells.size() != parts_[p].cells)
				return false;
			for (const std::int64_t cell : numbers.cells)
			{
				if (cell < 0 || static_cast<std::size_t>(cell) >= cells_ || has_cell[static_cast<std::size_t>(cell)])
					return false;
				has_cell[static_cast<std::size_t>(cell)] = true;
			}
			for (std::size_t i = 0; i < numbers.points.size(); ++i)
			{
				if (numbers.points[i] < 0 || static_cast<std::size_t>(numbers.points[i]) >= point_of_number.size())
					return false;
				const auto number = static_cast<std::size_t>(numbers.points[i]);
				const std::size_t point = first_points_[p] + i;
				end = std::max(end, number + 1);
				const std::size_t root = joined.root(static_cast<std::uint32_t>(point));
				if (point_of_number[number] == kNone)
				{
					point_of_number[number] = static_cast<std::int64_t>(point);
					++points;
				}
				else if (const auto other = static_cast<std::size_t>(point_of_number[number]);
				         joined.root(static_cast<std::uint32_t>(other)) != root && !areOne(other, point))
					return false;
				if (root != point && numberOf(root) != numbers.points[i])
					return false;
			}
		}
		return points == end;
	}

	// The part that a point is of, if all points are in a row.
	std::size_t partOf(std::size_t point) const
	{
		return static_cast<std::size_t>(std::upper_bound(first_points_.begin(), first_points_.end(), point) -
		                                first_points_.begin() - 1);
	}
	std::int64_t numberOf(std::size_t point) const
	{
		const std::size_t p = partOf(point);
		return told_[p].points[point - first_points_[p]];
	}
	// Whether two points lie in one place: parts that touch at an edge have no face to say so.
	bool areOne(std::size_t a, std::size_t b) const
	{
		const std::size_t p = partOf(a), q = partOf(b);
		const double* place = parts_[p].points.at(a - first_points_[p]);
		return distance(place, parts_[q].points.at(b - first_points_[q])) <= lastDigitsOf(place);
	}

	// Counts points and cells, one part after the other.
	void count(UnionFind& joined)
	{
		std::vector<std::int64_t> number_of_root(first_points_.back(), kNone);
		std::int64_t points = 0, cells = 0;
		for (std::size_t p = 0; p < parts_.size(); ++p)
		{
			FoamNumbers& numbers = region_.numbers.emplace_back();
			for (std::size_t i = 0; i < parts_[p].points.size(); ++i)
			{
				std::int64_t& number = number_of_root[joined.root(static_cast<std::uint32_t>(first_points_[p] + i))];
				if (number == kNone)
					number = points++;
				numbers.points.push_back(number);
			}
			for (std::size_t i = 0; i < parts_[p].cells; ++i)
				numbers.cells.push_back(cells++);
		}
	}

	void addPoints()
	{
		FoamMesh& whole = region_.mesh;
		whole.is_double = std::ranges::any_of(parts_, &FoamMesh::is_double);
		whole.points.components = 3;
		std::int64_t end = 0;
		for (const FoamNumbers& numbers : region_.numbers)
			for (const std::int64_t number : numbers.points)
				end = std::max(end, number + 1);
		whole.points.numbers.resize(3 * static_cast<std::size_t>(end));
		for (std::size_t p = parts_.size(); p-- > 0;) // the first part that has a point places it
			for (std::size_t i = 0; i < parts_[p].points.size(); ++i)
				std::copy_n(parts_[p].points.at(i), 3, whole.points.numbers.begin() + 3 * region_.numbers[p].points[i]);
	}

	void addFace(std::size_t part, std::int64_t face)
	{
		FoamMesh& whole = region_.mesh;
		for (const std::int64_t corner : parts_[part].faces[static_cast<std::size_t>(face)])
			whole.faces.corners.push_back(region_.numbers[part].points[static_cast<std::size_t>(corner)]);
		whole.faces.starts.push_back(static_cast<std::int64_t>(whole.faces.corners.size()));
		whole.owners.push_back(cellOf(part, parts_[part].owners[static_cast<std::size_t>(face)]));
	}
	std::int64_t cellOf(std::size_t part, std::int64_t cell) const
	{
		return region_.numbers[part].cells[static_cast<std::size_t>(cell)];
	}

	void addFacesInside()
	{
		for (std::size_t p = 0; p < parts_.size(); ++p)
			for (std::size_t face = 0; face < parts_[p].neighbours.size(); ++face)
			{
				addFace(p, static_cast<std::int64_t>(face));
				region_.mesh.neighbours.push_back(cellOf(p, parts_[p].neighbours[face]));
			}
	}

	void addFacesBetween(const Pair& pair)
	{
		for (std::int64_t i = 0; i < pair.patch_a->faces; ++i)
		{
			addFace(pair.a, pair.patch_a->first + i);
			const auto behind = static_cast<std::size_t>(pair.patch_b->first + i);
			region_.mesh.neighbours.push_back(cellOf(pair.b, parts_[pair.b].owners[behind]));
		}
	}

	void addPatches()
	{
		std::map<std::string, std::size_t> places;
		for (std::size_t p = 0; p < parts_.size(); ++p)
			for (std::size_t i = 0; i < parts_[p].patches.size(); ++i)
			{
				const FoamPatch& patch = parts_[p].patches[i];
				if (isBetweenParts(patch))
					continue;
				const auto [place, is_new] = places.emplace(nameInWhole(patch), region_.mesh.patches.size());
				if (is_new)
				{
					region_.mesh.patches.push_back({nameInWhole(patch), patch.type, patch.groups, 0, 0, kNone, ""});
					region_.patches.emplace_back();
				}
				region_.patches[place->second].push_back({p, i});
			}
		for (std::size_t w = 0; w < region_.patches.size(); ++w)
		{
			FoamPatch& whole = region_.mesh.patches[w];
			whole.first = static_cast<std::int64_t>(region_.mesh.faces.size());
			for (const auto [p, i] : region_.patches[w])
			{
				const FoamPatch& patch = parts_[p].patches[i];
				for (std::int64_t face = patch.first; face < patch.first + patch.faces; ++face)
					addFace(p, face);
				whole.faces += patch.faces;
			}
		}
	}

	FoamRegion& region_;
	std::vector<FoamMesh>& parts_;
	std::vector<FoamNumbers> told_;
	std::vector<std::size_t> first_points_ = {0}; // where the points of each part begin, all in a row
	std::vector<Pair> pairs_;
	std::size_t cells_ = 0;
};

} // namespace

FoamRegion joinFoamParts(std::vector<FoamMesh> parts, std::vector<FoamNumbers> numbers)
{
	FoamRegion region;
	region.parts = std::move(parts);
	Join(region, std::move(numbers)).make();
	for (FoamMesh& part : region.parts)
	{
		part.faces = {};
		part.owners = part.neighbours = {};
	}
	return region;
}

} // namespace vp::reader::codes
