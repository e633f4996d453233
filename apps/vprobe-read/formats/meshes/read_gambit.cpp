// GAMBIT's neutral files, by a parser of our own: VTK's makes up values where a file ends early, and twists bricks.
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/text/text_cursor.h"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <unordered_map>
#include <vector>

namespace vp::reader::meshes
{

namespace
{

using GambitIds = std::unordered_map<std::int64_t, vtkIdType>;

struct GambitElement
{
	std::int64_t number;
	std::int64_t nodes;
	int type;
};

// By the numbers of the GAMBIT User's Guide, appendix C. Those with more nodes have some in the middles of edges.
constexpr GambitElement kGambitElements[] = {{1, 2, VTK_LINE},       {2, 4, VTK_QUAD},  {3, 3, VTK_TRIANGLE},
                                             {4, 8, VTK_HEXAHEDRON}, {5, 6, VTK_WEDGE}, {6, 4, VTK_TETRA},
                                             {7, 5, VTK_PYRAMID}};

struct GambitCounts
{
	std::size_t nodes;
	std::size_t elements;
	std::size_t groups;
	std::int64_t dimensions;
};

// Twice the area of the plane figure a, b, c, d: near zero where its sides cross.
double gambitFaceArea(vtkPoints* points, vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d)
{
	double at[4][3];
	for (int i = 0; i < 4; ++i)
		points->GetPoint(std::array{a, b, c, d}[static_cast<std::size_t>(i)], at[i]);
	double u[3], v[3], normal[3];
	vtkMath::Subtract(at[2], at[0], u);
	vtkMath::Subtract(at[3], at[1], v);
	vtkMath::Cross(u, v, normal);
	return vtkMath::Norm(normal);
}

// The description numbers the corners of a brick and of a pyramid's base row by row; other programs write them around
// the face, as VTK has them. Whichever gives a face that does not cross itself. A wedge's base is seen from inside,
// where VTK has the one that is seen from outside first.
void goAroundFaces(vtkPoints* points, int type, std::array<vtkIdType, 8>& corners)
{
	if (type == VTK_WEDGE)
		std::swap_ranges(corners.begin(), corners.begin() + 3, corners.begin() + 3);
	if (type != VTK_HEXAHEDRON && type != VTK_PYRAMID)
		return;
	const double around = gambitFaceArea(points, corners[0], corners[1], corners[2], corners[3]);
	const double by_rows = gambitFaceArea(points, corners[0], corners[1], corners[3], corners[2]);
	if (by_rows <= around)
		return;
	std::swap(corners[2], corners[3]);
	if (type == VTK_HEXAHEDRON)
		std::swap(corners[6], corners[7]);
}

GambitCounts readGambitCounts(text::Cursor& at)
{
	while (!at.peekLine().starts_with("NUMNP"))
		at.line();
	at.line();
	GambitCounts counts = {};
	counts.nodes = at.count(4);
	counts.elements = at.count(6);
	counts.groups = at.count(10);
	at.integer(); // boundary conditions
	counts.dimensions = at.integer();
	at.integer(); // components of velocities
	if (counts.dimensions != 3)
		throw Refusal(fmt::format("nothing to slice: a GAMBIT mesh of {} dimensions", counts.dimensions));
	return counts;
}

void endGambitSection(text::Cursor& at)
{
	if (at.word() != "ENDOFSECTION")
		throw damaged("a section is longer than it announces");
}

// The heading of a section, and the version behind it.
void startGambitSection(text::Cursor& at, std::string_view heading)
{
	while (!at.peekLine().starts_with(heading))
		at.line();
	at.peekLine();
	at.line();
}

void readGambitNodes(text::Cursor& at, std::size_t count, vtkPoints* points, GambitIds& ids)
{
	startGambitSection(at, "NODAL COORDINATES");
	points->SetDataTypeToDouble();
	for (std::size_t n = 0; n < count; ++n)
	{
		if (!ids.emplace(at.integer(), static_cast<vtkIdType>(n)).second)
			throw damaged("a node occurs twice");
		const double x = at.real();
		const double y = at.real();
		points->InsertNextPoint(x, y, at.real());
	}
	endGambitSection(at);
}

void readGambitElements(text::Cursor& at, std::size_t count, const GambitIds& nodes, vtkUnstructuredGrid* grid,
                        GambitIds& ids)
{
	startGambitSection(at, "ELEMENTS/CELLS");
	grid->Allocate(static_cast<vtkIdType>(count));
	for (std::size_t e = 0; e < count; ++e)
	{
		if (!ids.emplace(at.integer(), static_cast<vtkIdType>(e)).second)
			throw damaged("an element occurs twice");
		const auto kind = std::ranges::find(kGambitElements, at.integer(), &GambitElement::number);
		if (kind == std::end(kGambitElements))
			throw damaged(fmt::format("element {} has a type that there is not", e));
		if (const std::int64_t listed = at.integer(); listed != kind->nodes)
			throw Refusal(fmt::format("an element of {} nodes, where only those of {} are read; save it with linear "
			                          "elements",
			                          listed, kind->nodes));
		std::array<vtkIdType, 8> corners = {};
		for (std::int64_t i = 0; i < kind->nodes; ++i)
		{
			const auto found = nodes.find(at.integer());
			if (found == nodes.end())
				throw damaged(fmt::format("element {} has a node that is not there", e));
			corners[static_cast<std::size_t>(i)] = found->second;
		}
		goAroundFaces(grid->GetPoints(), kind->type, corners);
		grid->InsertNextCell(kind->type, kind->nodes, corners.data());
	}
	endGambitSection(at);
}

std::int64_t gambitNumber(text::Cursor& at, std::string_view word)
{
	if (at.word() != word)
		throw damaged(fmt::format("a group without {}", word));
	return at.integer();
}

int gambitSmallNumber(text::Cursor& at, std::string_view word)
{
	const std::int64_t number = gambitNumber(at, word);
	if (number < 0 || number > std::numeric_limits<int>::max())
		throw damaged(fmt::format("a group with {} {}", word, number));
	return static_cast<int>(number);
}

// Returns how many of its elements are in an earlier group too.
std::size_t readGambitGroup(text::Cursor& at, const GambitIds& elements, std::vector<bool>& seen, vtkIntArray* material,
                            vtkIntArray* group)
{
	startGambitSection(at, "ELEMENT GROUP");
	const int number = gambitSmallNumber(at, "GROUP:");
	const std::size_t count = at.checkedCount(gambitNumber(at, "ELEMENTS:"), 2);
	const int kind = gambitSmallNumber(at, "MATERIAL:");
	const std::size_t flags = at.checkedCount(gambitNumber(at, "NFLAGS:"), 2);
	at.line();
	at.line(); // its name
	for (std::size_t f = 0; f < flags; ++f)
		at.integer();
	std::size_t repeated = 0;
	for (std::size_t e = 0; e < count; ++e)
	{
		const auto found = elements.find(at.integer());
		if (found == elements.end())
			throw damaged("a group has an element that is not there");
		if (seen[static_cast<std::size_t>(found->second)])
		{
			++repeated;
			continue;
		}
		seen[static_cast<std::size_t>(found->second)] = true;
		material->SetValue(found->second, kind);
		group->SetValue(found->second, number);
	}
	endGambitSection(at);
	return repeated;
}

// Only boundary conditions may follow: sections that are not announced would be missing without a word.
void refuseMoreGroups(text::Cursor& at)
{
	while (!at.atEnd())
		if (at.line().starts_with("ELEMENT GROUP"))
			throw damaged("it has more groups than it announces");
}

} // namespace

void readGambit(const Request& request, manifest::Writer& manifest)
{
	const MappedText file(request.file);
	text::Cursor at(file.text());
	const GambitCounts counts = readGambitCounts(at);
	endGambitSection(at);
	vtkNew<vtkPoints> points;
	vtkNew<vtkUnstructuredGrid> grid;
	grid->SetPoints(points);
	GambitIds nodes, elements;
	readGambitNodes(at, counts.nodes, points, nodes);
	readGambitElements(at, counts.elements, nodes, grid, elements);
	// VTK's name, and the number of the group.
	for (const char* name : {"Material Type", "Group"})
	{
		vtkNew<vtkIntArray> array;
		array->SetName(name);
		array->SetNumberOfTuples(static_cast<vtkIdType>(counts.elements));
		array->Fill(0);
		grid->GetCellData()->AddArray(array);
	}
	const auto array = [&](int index) { return vtkIntArray::SafeDownCast(grid->GetCellData()->GetArray(index)); };
	std::vector<bool> seen(counts.elements);
	std::size_t repeated = 0;
	for (std::size_t g = 0; g < counts.groups; ++g)
		repeated += readGambitGroup(at, elements, seen, array(0), array(1));
	refuseMoreGroups(at);
	if (repeated > 0)
		manifest.warn(fmt::format("{} of its elements are in several groups; the first one is shown", repeated));
	manifest.add(grid);
}

} // namespace vp::reader::meshes
