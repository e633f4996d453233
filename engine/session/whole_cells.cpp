#include "session/whole_cells.h"

#include "base/place_key.h"
#include "session/border_faces.h"
#include "session/hanging_borders.h"
#include "session/rim_vertices.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace vp::session
{

namespace
{

/// A polygon that is a face without a neighbor in this rank.
struct LoneFace
{
	int rank = 0;
	std::uint32_t polygon = 0;
	std::vector<Vec3> corners{}; // each place once
	double tolerance = 0.0;      // of a corner
	double most = 0.0;           // which no tolerance may pass

	Vec3 center() const
	{
		Vec3 sum(0.0);
		for (const Vec3& corner : corners)
			sum += corner;
		return sum / static_cast<double>(corners.size());
	}
	bool liesOn(const LoneFace& other) const
	{
		const double apart = std::min({std::max(tolerance, other.tolerance), most, other.most});
		return corners.size() == other.corners.size() &&
		       std::ranges::all_of(corners,
		                           [&](const Vec3& p)
		                           {
			                           return std::ranges::any_of(
			                               other.corners, [&](const Vec3& q) { return glm::length(p - q) <= apart; });
		                           });
	}
};

/// The boxes of other ranks.
class Others
{
public:
	Others(const Team& team, const std::vector<Box>& boxes)
	{
		Box all;
		for (const Box& box : boxes)
			all.include(box);
		constexpr double kRounding = 1e-6; // of places against the bounds of their cells
		for (int rank = 0; rank < team.size(); ++rank)
			if (Box box = boxes[static_cast<std::size_t>(rank)]; rank != team.rank() && !box.empty())
			{
				box.lo -= kRounding * all.diagonal();
				box.hi += kRounding * all.diagonal();
				boxes_.push_back(box);
			}
	}

	bool meet(const Vec3& lo, const Vec3& hi) const
	{
		return std::ranges::any_of(
		    boxes_, [&](const Box& box)
		    { return glm::all(glm::lessThanEqual(lo, box.hi)) && glm::all(glm::lessThanEqual(box.lo, hi)); });
	}

private:
	std::vector<Box> boxes_;
};

template <grid::Grid G>
double storedUlp(const G& grid)
{
	if constexpr (requires { grid.coordinates().isDouble(); })
		if (!grid.coordinates().isDouble())
			return std::numeric_limits<float>::epsilon();
	return std::numeric_limits<double>::epsilon();
}

double shortestSide(std::span<const Vec3> corners)
{
	double shortest = std::numeric_limits<double>::infinity();
	Vec3 before = corners.back();
	for (const Vec3& corner : corners)
		if (const double length = glm::length(corner - std::exchange(before, corner)); length > 0.0)
			shortest = std::min(shortest, length);
	return shortest;
}

/// As grid/interfaces.h has it.
void setTolerance(double ulp, double shortest_of_cell, LoneFace& face)
{
	constexpr double kOfEdge = 1e-6;
	constexpr double kMaxOfAnEdge = 0.25;
	const double edge = shortestSide(face.corners);
	double greatest = 0.0;
	for (const Vec3& corner : face.corners)
		greatest = std::max({greatest, std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)});
	face.tolerance = std::max(kOfEdge * edge, std::min(4.0 * ulp * greatest, kMaxOfAnEdge * edge));
	face.most = kMaxOfAnEdge * shortest_of_cell;
}

/// Finds the faces of cells that polygons are.
template <grid::Grid G>
class FacesOfPolygons
{
public:
	FacesOfPolygons(const G& grid, const grid::BlockSeams* seams) : grid_(grid), seams_(seams) {}

	/// Nothing if there is a cell across in this rank.
	std::optional<LoneFace> loneFace(const mesh::SheetMesh& mesh, std::uint32_t polygon)
	{
		const CellId cell = mesh.polygon_cells[polygon].cell;
		grid_.cellFaces(cell, faces_);
		double shortest = std::numeric_limits<double>::infinity();
		double nearest = std::numeric_limits<double>::infinity();
		int number = 0;
		LoneFace lone;
		for (int f = 0; f < faces_.size(); ++f)
		{
			cornersOf(f);
			shortest = std::min(shortest, shortestSide(corners_));
			// Vertices that were joined may lie a rounding off the points.
			double farthest = 0.0;
			for (const std::uint32_t v : mesh.polygon(polygon))
			{
				double distance = std::numeric_limits<double>::infinity();
				for (const Vec3& corner : corners_)
					distance = std::min(distance, glm::length(corner - mesh.positions[v]));
				farthest = std::max(farthest, distance);
			}
			if (corners_.size() < 3 || !(farthest < nearest))
				continue;
			nearest = farthest;
			number = f;
			lone.corners = corners_;
		}
		if (lone.corners.empty() || hasNeighbor(cell, number))
			return std::nullopt;
		lone.polygon = polygon;
		setTolerance(storedUlp(grid_), shortest, lone);
		return lone;
	}

private:
	void cornersOf(int face)
	{
		corners_.clear();
		for (const PointId p : faces_[face])
			if (const Vec3 corner = grid_.point(p); std::ranges::find(corners_, corner) == corners_.end())
				corners_.push_back(corner);
	}
	bool hasNeighbor(CellId cell, int face) const
	{
		bool has = seams_ && !seams_->of(cell, static_cast<std::uint32_t>(face)).empty();
		grid_.forEachNeighbor(cell, face, [&](CellId) { has = true; });
		return has;
	}

	const G& grid_;
	const grid::BlockSeams* seams_;
	grid::CellFaces faces_;
	std::vector<Vec3> corners_;
};

std::vector<LoneFace> loneFaces(const grid::BlockSet& blocks, const Others& others, const mesh::SheetMesh& mesh)
{
	std::vector<LoneFace> faces;
	for (std::uint32_t p = 0; p < mesh.polygons(); ++p)
	{
		Box box;
		for (const std::uint32_t v : mesh.polygon(p))
			box.include(mesh.positions[v]);
		if (!others.meet(box.lo, box.hi))
			continue;
		const std::uint32_t block = mesh.polygon_cells[p].block;
		std::optional<LoneFace> face = std::visit(
		    [&](const auto& grid) { return FacesOfPolygons(grid, blocks.interfaces.of(block)).loneFace(mesh, p); },
		    blocks.blocks[block].grid);
		if (face)
			faces.push_back(std::move(*face));
	}
	return faces;
}

void put(MessageWriter& to, const LoneFace& face)
{
	to.put(face.polygon);
	to.put(face.tolerance);
	to.put(face.most);
	to.putAll(face.corners);
}

LoneFace takeFace(MessageReader& from, int rank)
{
	LoneFace face;
	face.rank = rank;
	face.polygon = from.get<std::uint32_t>();
	face.tolerance = from.get<double>();
	face.most = from.get<double>();
	face.corners = from.getAll<Vec3>();
	return face;
}

/// Brings faces together in bins of a lattice over space. Returns the polygons whose face lies on one of another rank.
std::vector<std::uint32_t> facesOnOthers(Team& team, const std::vector<Box>& boxes, const std::vector<LoneFace>& faces)
{
	double side = 0.0;
	for (const LoneFace& face : faces)
		for (const Vec3& corner : face.corners)
			side = std::max(side, 2.0 * glm::length(corner - face.center()));
	sumOverAll(team, side, [](double& greatest, double other) { greatest = std::max(greatest, other); });
	if (!(side > 0.0))
		return {};
	const auto binAt = [&](const Vec3& place)
	{
		const Vec3 cell(std::floor(place.x / side), std::floor(place.y / side), std::floor(place.z / side));
		return std::pair(placeKey(cell), side * (cell + 0.5));
	};
	Neighborhood near(team, boxes, side); // the middle of a bin lies no farther from the faces in it
	for (const LoneFace& face : faces)
	{
		std::map<std::uint64_t, Vec3> bins;
		for (int corner = 0; corner < 8; ++corner)
		{
			const Vec3 way(corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 1.0 : -1.0);
			bins.insert(binAt(face.center() + 2.0 * face.tolerance * way));
		}
		for (const auto& [bin, place] : bins)
		{
			MessageWriter& message = near.messageFor(place);
			message.put(bin);
			put(message, face);
		}
	}
	std::map<std::uint64_t, std::vector<LoneFace>> bins;
	const std::vector<Bytes> came = near.exchange();
	for (std::size_t rank = 0; rank < came.size(); ++rank)
		for (MessageReader reader(came[rank]); !reader.atEnd();)
		{
			const auto bin = reader.get<std::uint64_t>();
			bins[bin].push_back(takeFace(reader, static_cast<int>(rank)));
		}
	for (const auto& [bin, some] : bins)
		for (std::size_t i = 0; i < some.size(); ++i)
			for (std::size_t j = 0; j < i; ++j)
				if (some[i].rank != some[j].rank && some[i].liesOn(some[j]))
					for (const LoneFace* face : {&some[i], &some[j]})
						near.messageFor(face->rank).put(face->polygon);
	std::vector<std::uint32_t> polygons;
	for (const Bytes& answer : near.exchange())
		for (MessageReader reader(answer); !reader.atEnd();)
			polygons.push_back(reader.get<std::uint32_t>());
	std::ranges::sort(polygons);
	polygons.erase(std::unique(polygons.begin(), polygons.end()), polygons.end());
	return polygons;
}

/// Whether faces that lie on none of another rank meet some of another size.
bool hang(Team& team, const std::vector<Box>& boxes, const std::vector<LoneFace>& faces,
          const std::vector<std::uint32_t>& on_others, const mesh::SheetMesh& mesh)
{
	mesh::SheetMesh lone;
	lone.positions = mesh.positions;
	lone.polygon_starts.push_back(0);
	std::vector<RimVertex> corners;
	for (const LoneFace& face : faces)
	{
		if (std::ranges::binary_search(on_others, face.polygon))
			continue;
		for (const std::uint32_t v : mesh.polygon(face.polygon))
			lone.polygon_vertices.push_back(v);
		lone.polygon_starts.push_back(static_cast<std::uint32_t>(lone.polygon_vertices.size()));
		lone.polygon_cells.push_back(mesh.polygon_cells[face.polygon]);
		for (const Vec3& place : face.corners)
		{
			RimVertex& corner = corners.emplace_back();
			corner.place = place;
			corner.near = std::min(face.tolerance, face.most);
		}
	}
	return hangsBetweenRanks(team, boxes, lone, corners);
}

} // namespace

Borders joinWholeCells(Team& team, const grid::BlockSet& blocks, std::span<const std::uint32_t> whole,
                       mesh::SheetMesh& crinkle)
{
	Borders borders;
	const std::vector<Box> boxes = boxesOf(team, blocks);
	const Others others(team, boxes);
	const std::vector<LoneFace> faces = loneFaces(blocks, others, crinkle);
	const std::vector<std::uint32_t> on_others = facesOnOthers(team, boxes, faces);
	borders.hangs = hang(team, boxes, faces, on_others, crinkle);
	borders.faces_elsewhere = on_others.size();

	// Where rounding has parted places, those are one that are corners of faces on each other.
	const auto nameOf = [&](std::uint32_t v) { return std::uint64_t(crinkle.edges[v].block) << 32 | crinkle.edges[v].lower; };
	std::unordered_map<std::uint64_t, double> near;
	for (const LoneFace& face : faces)
		if (std::ranges::binary_search(on_others, face.polygon))
			for (const std::uint32_t v : crinkle.polygon(face.polygon))
			{
				double& of_vertex = near[nameOf(v)];
				of_vertex = std::max(of_vertex, std::min(face.tolerance, face.most));
			}
	if (!on_others.empty())
		dropPolygons(on_others, crinkle);
	std::vector<RimVertex> own;
	for (std::uint32_t v = 0; v < crinkle.positions.size(); ++v)
	{
		if (!others.meet(crinkle.positions[v], crinkle.positions[v]))
			continue;
		RimVertex& vertex = own.emplace_back(gridVertex(blocks, whole, crinkle, v));
		if (const auto found = near.find(nameOf(v)); found != near.end())
			vertex.near = found->second;
	}
	shareVertices(team, boxes, own, borders);
	return borders;
}

} // namespace vp::session
