// After "ANSYS Fluent User's Guide", appendix B: case and data file formats.
#include "fluent_case.h"

#include "fluent_sections.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/cells/cell_of_faces.h"
#include "vprobe-read/cells/grown_cells.h"

#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <unordered_map>

namespace vp::reader::codes
{

namespace
{

constexpr std::int64_t kInactiveCells = 32; // a type of zones: cells that were refined
constexpr std::int64_t kParentFaces = 31;   // faces that others take the place of
constexpr std::int64_t kMixedFaces = 0;
constexpr std::int64_t kPolygonalFaces = 5;
constexpr std::int64_t kMaxFluentCount = std::numeric_limits<std::int32_t>::max();

// The numbers of a section's head, with 0 for those that are not there.
std::vector<std::int64_t> fluentHead(const FluentSection& section)
{
	std::vector<std::int64_t> numbers = section.numbers(16);
	numbers.resize(std::max<std::size_t>(numbers.size(), 5), 0);
	if (numbers[1] < 0 || numbers[2] < 0 || numbers[2] > kMaxFluentCount)
		throw damaged(fmt::format("section {} counts from {} to {}", section.number, numbers[1], numbers[2]));
	return numbers;
}

std::int64_t fluentWhole(const FluentSection& section, text::Cursor& at)
{
	return section.is_binary ? at.binary<std::int32_t>() : hexadecimalWord(at);
}

double fluentReal(const FluentSection& section, text::Cursor& at)
{
	return !section.is_binary ? at.real() : section.number >= 3000 ? at.binary<double>() : at.binary<float>();
}

struct FluentRange
{
	std::int64_t first; // from 1
	std::int64_t last;
};

// The zones of a kind hold each of its numbers once: what one zone lacks would be missing without a word.
void refuseGaps(std::vector<FluentRange> zones, std::optional<std::int64_t> announced, const char* kind)
{
	std::ranges::sort(zones, {}, &FluentRange::first);
	std::int64_t next = 1;
	for (const FluentRange& zone : zones)
	{
		if (zone.first != next)
			throw damaged(fmt::format("its zones of {} do not go on from {} to {}", kind, next - 1, zone.first));
		next = zone.last + 1;
	}
	if (next - 1 != announced.value_or(next - 1))
		throw damaged(fmt::format("its zones have {} of {} {}", next - 1, *announced, kind));
}

class FluentCaseParser
{
public:
	explicit FluentCaseParser(std::string_view text) : sections_(text) {}

	FluentCase parse();

private:
	void read(const FluentSection& section);
	void readNodes(const FluentSection& section);
	void readCells(const FluentSection& section);
	void readFaces(const FluentSection& section);
	void readFace(const FluentSection& section, text::Cursor& at, std::int64_t kind);
	void readName(const FluentSection& section);
	void check() const;

	FluentSections sections_;
	FluentCase case_;
	std::int64_t nodes_ = 0;
	std::optional<std::int64_t> faces_; // some programs do not announce them
	std::vector<FluentRange> node_zones_, cell_zones_, face_zones_;
	std::unordered_map<std::int64_t, std::string> names_;
};

void FluentCaseParser::readNodes(const FluentSection& section)
{
	const auto head = fluentHead(section); // zone, first, last, type, dimensions
	if (head[0] == 0)
	{
		nodes_ = head[2];
		return;
	}
	if (head[2] < std::max<std::int64_t>(head[1], 1))
		return; // an empty zone
	if (section.body == 0)
		throw damaged("a zone of nodes without their places");
	text::Cursor at = sections_.bodyOf(section);
	const std::size_t width = !section.is_binary ? 2 : section.number >= 3000 ? 8 : 4;
	const std::size_t count = at.checkedCount(head[2] - head[1] + 1, 3 * width - 1);
	if (head[1] < 1 || head[2] > nodes_)
		throw damaged("a zone of nodes is not among the nodes");
	node_zones_.push_back({head[1], head[2]});
	if (const std::size_t all = 3 * sections_.checkedCount(nodes_, 3 * 2 - 1); case_.coordinates.size() < all)
		case_.coordinates.resize(all);
	const auto first = 3 * static_cast<std::size_t>(head[1] - 1);
	for (std::size_t i = 0; i < 3 * count; ++i)
		case_.coordinates[first + i] = fluentReal(section, at);
	sections_.endBody(section, at);
}

void FluentCaseParser::readCells(const FluentSection& section)
{
	const auto head = fluentHead(section); // zone, first, last, type, kind of element
	if (head[0] == 0)
		case_.cells = head[2];
	else if (head[1] < 1 || head[2] < head[1])
		throw damaged("a zone of cells that cannot be");
	else
	{
		cell_zones_.push_back({head[1], head[2]});
		if (head[3] != 0 && head[3] != kInactiveCells)
			case_.zones.push_back({head[0], "", head[1] - 1, head[2] - 1});
	}
	sections_.skip(section); // kinds of elements: the faces tell them too
}

void FluentCaseParser::readFace(const FluentSection& section, text::Cursor& at, std::int64_t kind)
{
	const bool counts = kind == kMixedFaces || kind == kPolygonalFaces;
	const std::int64_t corners = counts ? fluentWhole(section, at) : kind;
	if (corners < 2)
		throw damaged(fmt::format("a face of {} corners", corners));
	const std::size_t many = at.checkedCount(corners, section.is_binary ? 4 : 2);
	for (std::size_t i = 0; i < many; ++i)
	{
		const std::int64_t node = fluentWhole(section, at);
		if (node < 1 || node > nodes_)
			throw damaged(fmt::format("a face has the node {} of {}", node, nodes_));
		case_.corners.push_back(static_cast<std::int32_t>(node - 1));
	}
	std::array<std::int32_t, 2> sides;
	for (std::int32_t& side : sides)
	{
		const std::int64_t cell = fluentWhole(section, at);
		if (cell < 0 || cell > case_.cells)
			throw damaged(fmt::format("a face has the cell {} of {}", cell, case_.cells));
		side = static_cast<std::int32_t>(cell - 1);
	}
	case_.face_starts.push_back(case_.corners.size());
	case_.sides.push_back(sides);
}

void FluentCaseParser::readFaces(const FluentSection& section)
{
	const auto head = fluentHead(section); // zone, first, last, type, kind of face
	if (head[0] == 0)
	{
		faces_ = head[2];
		return;
	}
	if (head[2] < std::max<std::int64_t>(head[1], 1))
		return; // an empty zone
	if (section.body == 0)
		throw damaged("a zone of faces without their corners");
	face_zones_.push_back({head[1], head[2]});
	if (head[3] == kParentFaces)
	{
		sections_.skip(section);
		return;
	}
	text::Cursor at = sections_.bodyOf(section);
	const std::size_t count = at.checkedCount(head[2] - head[1] + 1, 8);
	for (std::size_t f = 0; f < count; ++f)
		readFace(section, at, head[4]);
	sections_.endBody(section, at);
}

// "(39 (ID TYPE NAME DOMAIN) ...)" with decimal numbers.
void FluentCaseParser::readName(const FluentSection& section)
{
	text::Cursor at(section.head);
	const std::int64_t id = at.integer();
	at.word();
	if (!at.atEnd())
		names_[id] = at.word();
}

void FluentCaseParser::read(const FluentSection& section)
{
	switch (section.kind())
	{
	case 2:
		if (section.numbers(10) != std::vector<std::int64_t>{3})
			throw Refusal("nothing to slice: a Fluent case of two dimensions");
		return;
	case 10:
		return readNodes(section);
	case 12:
		return readCells(section);
	case 13:
		return readFaces(section);
	case 39:
	case 45:
		return readName(section);
	default:
		sections_.skip(section);
	}
}

void FluentCaseParser::check() const
{
	refuseGaps(node_zones_, nodes_, "nodes");
	refuseGaps(cell_zones_, case_.cells, "cells");
	refuseGaps(face_zones_, faces_, "faces");
	if (case_.sides.empty())
		throw damaged("it has no faces");
}

FluentCase FluentCaseParser::parse()
{
	for (FluentSection section; sections_.next(section);)
		read(section);
	check();
	for (FluentZone& zone : case_.zones)
		zone.name = names_.contains(zone.id) ? names_[zone.id] : fmt::format("zone {}", zone.id);
	return std::move(case_);
}

// The faces of each of a zone's cells: numbers of faces one cell after the other, and where each cell begins.
struct FacesOfCells
{
	std::vector<std::size_t> starts;
	std::vector<std::int32_t> faces;

	FacesOfCells(const FluentCase& mesh, const FluentZone& zone)
	{
		const auto cells = static_cast<std::size_t>(zone.last - zone.first + 1);
		starts.assign(cells + 1, 0);
		const auto each = [&](auto&& use)
		{
			for (std::size_t f = 0; f < mesh.sides.size(); ++f)
				for (const std::int32_t side : mesh.sides[f])
					if (side >= zone.first && side <= zone.last)
						use(static_cast<std::size_t>(side - zone.first), static_cast<std::int32_t>(f));
		};
		each([&](std::size_t cell, std::int32_t) { ++starts[cell + 1]; });
		for (std::size_t c = 0; c < cells; ++c)
			starts[c + 1] += starts[c];
		faces.resize(starts.back());
		std::vector<std::size_t> next(starts.begin(), starts.end() - 1);
		each([&](std::size_t cell, std::int32_t face) { faces[next[cell]++] = face; });
	}
};

} // namespace

FluentCase parseFluentCase(std::string_view text)
{
	return FluentCaseParser(text).parse();
}

vtkSmartPointer<vtkUnstructuredGrid> fluentGrid(const FluentCase& mesh, const FluentZone& zone)
{
	const FacesOfCells of(mesh, zone);
	vtkNew<vtkPoints> points;
	points->SetDataTypeToDouble();
	std::vector<vtkIdType> new_ids(mesh.coordinates.size() / 3, -1);
	const auto pointOf = [&](std::int32_t node)
	{
		vtkIdType& id = new_ids[static_cast<std::size_t>(node)];
		if (id < 0)
			id = points->InsertNextPoint(mesh.coordinates.data() + 3 * static_cast<std::size_t>(node));
		return id;
	};
	cells::GrownCells cells;
	std::vector<cells::FaceCorners> faces;
	for (std::size_t c = 0; c + 1 < of.starts.size(); ++c)
	{
		faces.clear();
		for (std::size_t i = of.starts[c]; i < of.starts[c + 1]; ++i)
		{
			const auto face = static_cast<std::size_t>(of.faces[i]);
			cells::FaceCorners corners;
			for (std::size_t k = mesh.face_starts[face]; k < mesh.face_starts[face + 1]; ++k)
				corners.push_back(pointOf(mesh.corners[k]));
			// Seen with its corners counterclockwise, a face has its second cell behind it.
			if (mesh.sides[face][0] == zone.first + static_cast<std::int64_t>(c))
				std::reverse(corners.begin(), corners.end());
			faces.push_back(std::move(corners));
		}
		if (faces.size() < 4)
			throw damaged(fmt::format("cell {} has {} faces", zone.first + static_cast<std::int64_t>(c), faces.size()));
		cells::addCellOfFaces(cells, faces);
	}
	auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
	grid->SetPoints(points);
	cells.fill(grid);
	return grid;
}

} // namespace vp::reader::codes
