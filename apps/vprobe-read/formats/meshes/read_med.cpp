// MED 3 and 4, the meshes and fields of Salome and Code_Aster, through HDF5 alone: Debian's libmedc brings an HDF5
// with MPI, which cannot be in one process with that of VTK.
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/hdf5/hdf5_file.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/time_choice.h"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

namespace vp::reader::meshes
{

namespace
{

constexpr std::size_t kMaxMedNodes = 27;

struct MedKind
{
	const char* name;
	int type;
	std::size_t nodes;
	std::size_t corners;
	std::array<std::size_t, 8> turned; // the corners of a cell that is seen in a mirror
};

constexpr std::array<std::size_t, 8> kTurnedTetra = {0, 2, 1, 3}, kTurnedPyramid = {0, 3, 2, 1, 4},
                                     kTurnedWedge = {0, 2, 1, 3, 5, 4}, kTurnedHexahedron = {0, 3, 2, 1, 4, 7, 6, 5};
constexpr MedKind kMedKinds[] = {{"TE4", VTK_TETRA, 4, 4, kTurnedTetra},
                                 {"PY5", VTK_PYRAMID, 5, 5, kTurnedPyramid},
                                 {"PE6", VTK_WEDGE, 6, 6, kTurnedWedge},
                                 {"HE8", VTK_HEXAHEDRON, 8, 8, kTurnedHexahedron},
                                 {"T10", VTK_QUADRATIC_TETRA, 10, 4, kTurnedTetra},
                                 {"P13", VTK_QUADRATIC_PYRAMID, 13, 5, kTurnedPyramid},
                                 {"P15", VTK_QUADRATIC_WEDGE, 15, 6, kTurnedWedge},
                                 {"P18", VTK_BIQUADRATIC_QUADRATIC_WEDGE, 18, 6, kTurnedWedge},
                                 {"H20", VTK_QUADRATIC_HEXAHEDRON, 20, 8, kTurnedHexahedron},
                                 {"H27", VTK_TRIQUADRATIC_HEXAHEDRON, 27, 8, kTurnedHexahedron}};

using MedNodes = std::array<vtkIdType, kMaxMedNodes>;

// The corners between which VTK's nodes in edges and faces lie. MED has the same order, but for the faces of H27.
std::vector<std::string_view> medBetween(std::size_t corners)
{
	switch (corners)
	{
	case 4:
		return {"01", "12", "02", "03", "13", "23"};
	case 5:
		return {"01", "12", "23", "03", "04", "14", "24", "34"};
	case 6:
		return {"01", "12", "02", "34", "45", "35", "03", "14", "25", "0134", "1245", "0235"};
	default:
		return {"01", "12", "23",   "03",   "45",   "56",   "67",   "47",   "04",      "15",
		        "26", "37", "0347", "1256", "0145", "2367", "0123", "4567", "01234567"};
	}
}

// For each node of a cell the one that takes its place in the mirror.
std::vector<std::size_t> medTurned(const MedKind& kind)
{
	std::vector<std::size_t> turned(kind.turned.begin(),
	                                kind.turned.begin() + static_cast<std::ptrdiff_t>(kind.corners));
	const std::vector<std::string_view> between = medBetween(kind.corners);
	for (std::size_t node = kind.corners; node < kind.nodes; ++node)
	{
		std::string mirrored;
		for (const char corner : between[node - kind.corners])
			mirrored += static_cast<char>('0' + kind.turned[static_cast<std::size_t>(corner - '0')]);
		std::sort(mirrored.begin(), mirrored.end());
		turned.push_back(kind.corners +
		                 static_cast<std::size_t>(std::ranges::find(between, mirrored) - between.begin()));
	}
	return turned;
}

// H27: MED lists the faces below, in front, on the right, behind, on the left, above; other programs write them in
// VTK's order. Their places tell.
void orderMedFaces(vtkPoints* points, MedNodes& nodes)
{
	constexpr std::size_t first = 20;
	constexpr std::array<std::size_t, 6> of_med = {4, 2, 1, 3, 0, 5};
	const std::vector<std::string_view> between = medBetween(8);
	MedNodes by_med = nodes;
	for (std::size_t face = 0; face < 6; ++face)
		by_med[first + face] = nodes[first + of_med[face]];
	const auto distance = [&](const MedNodes& listed)
	{
		double sum = 0.0;
		for (std::size_t face = 0; face < 6; ++face)
		{
			double at[3], corner[3];
			points->GetPoint(listed[first + face], at);
			for (const char c : between[first - 8 + face])
			{
				points->GetPoint(nodes[static_cast<std::size_t>(c - '0')], corner);
				for (int i = 0; i < 3; ++i)
					at[i] -= corner[i] / 4;
			}
			sum += vtkMath::Dot(at, at);
		}
		return sum;
	};
	if (!(distance(nodes) < distance(by_med)))
		nodes = by_med;
}

// Cells of one kind, behind each other in the grid.
struct MedCells
{
	std::string kind;
	vtkIdType first;
	vtkIdType count;
};

struct MedMesh
{
	std::string name;
	vtkNew<vtkUnstructuredGrid> grid;
	vtkIdType nodes = 0;
	std::vector<MedCells> cells;
};

// Positive where the tip lies on the side of the base from which its corners are counterclockwise.
double medVolume(vtkPoints* points, vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType tip)
{
	double at[4][3];
	points->GetPoint(a, at[0]);
	points->GetPoint(b, at[1]);
	points->GetPoint(c, at[2]);
	points->GetPoint(tip, at[3]);
	for (int i = 1; i < 4; ++i)
		vtkMath::Subtract(at[i], at[0], at[i]);
	return vtkMath::Determinant3x3(at[1], at[2], at[3]);
}

// MED's cells are mirrored by its description; not all programs do that, so their volumes tell.
void addMedCells(const hdf5::File& file, const std::string& group, const MedKind& kind, MedMesh& mesh)
{
	const std::vector<std::int64_t> nodes = file.integers(group + "/NOD");
	const std::size_t count = nodes.size() / kind.nodes;
	if (count * kind.nodes != nodes.size())
		throw damaged(fmt::format("{} has {} corners", group, nodes.size()));
	mesh.cells.push_back({kind.name, mesh.grid->GetNumberOfCells(), static_cast<vtkIdType>(count)});
	const std::size_t tip = kind.corners == 4 || kind.corners == 6 ? 3 : 4;
	const std::vector<std::size_t> mirror = medTurned(kind);
	for (std::size_t cell = 0; cell < count; ++cell)
	{
		MedNodes own = {};
		for (std::size_t i = 0; i < kind.nodes; ++i)
		{
			own[i] = nodes[i * count + cell] - 1; // all first nodes, then all second ones
			if (own[i] < 0 || own[i] >= mesh.nodes)
				throw damaged(fmt::format("{} has a node that is not there", group));
		}
		if (kind.nodes == 27)
			orderMedFaces(mesh.grid->GetPoints(), own);
		MedNodes turned = own;
		if (medVolume(mesh.grid->GetPoints(), own[0], own[1], own[2], own[tip]) < 0.0)
			for (std::size_t i = 0; i < kind.nodes; ++i)
				turned[i] = own[mirror[i]];
		mesh.grid->InsertNextCell(kind.type, static_cast<vtkIdType>(kind.nodes), turned.data());
	}
}

void readMedPoints(const hdf5::File& file, const std::string& group, MedMesh& mesh)
{
	const std::vector<double> places = file.reals(group + "/NOE/COO"); // all x, all y, all z
	if (places.size() % 3 != 0)
		throw damaged(fmt::format("{} coordinates in three dimensions", places.size()));
	mesh.nodes = static_cast<vtkIdType>(places.size() / 3);
	const auto count = static_cast<std::size_t>(mesh.nodes);
	vtkNew<vtkPoints> points;
	points->SetDataTypeToDouble();
	points->SetNumberOfPoints(mesh.nodes);
	for (std::size_t n = 0; n < count; ++n)
		points->SetPoint(static_cast<vtkIdType>(n), places[n], places[count + n], places[2 * count + n]);
	mesh.grid->SetPoints(points);
}

void readMedMesh(const hdf5::File& file, MedMesh& mesh, manifest::Writer& manifest)
{
	const std::string root = "/ENS_MAA/" + mesh.name;
	if (file.realOr(root, "ESP", 3) != 3)
		throw Refusal("nothing to slice: a mesh of fewer than three dimensions");
	const std::vector<std::string> steps = file.namesIn(root);
	if (steps.empty() || !file.has(root + "/" + steps[0] + "/MAI"))
		throw Refusal("a MED mesh without a list of cells, which is not read");
	const std::string group = root + "/" + steps[0];
	if (steps.size() > 1)
		manifest.warn(fmt::format("the mesh {} changes over time; its first state is shown", mesh.name));
	readMedPoints(file, group, mesh);
	std::vector<double> families;
	for (const MedKind& kind : kMedKinds)
		if (const std::string cells = group + "/MAI/" + kind.name; file.has(cells))
		{
			addMedCells(file, cells, kind, mesh);
			if (file.has(cells + "/FAM"))
				for (const std::int64_t family : file.integers(cells + "/FAM"))
					families.push_back(static_cast<double>(family));
			families.resize(static_cast<std::size_t>(mesh.grid->GetNumberOfCells()), 0.0);
		}
	vtkNew<vtkDoubleArray> family;
	family->SetName("family");
	for (const double number : families)
		family->InsertNextValue(number);
	mesh.grid->GetCellData()->AddArray(family);
	if (file.has(group + "/MAI/POE"))
		manifest.warn("cells of MED's kind POE are not shown");
}

// Returns the place of each component in an array of ours. A symmetric tensor is xx yy zz xy yz xz there; in the file
// the names of its components end with these letters, in any order, as code_aster's SIXX SIYY SIZZ SIXY SIXZ SIYZ.
std::vector<int> medPlaces(const hdf5::File& file, const std::string& field, std::size_t components)
{
	constexpr std::size_t kNameLength = 16;
	constexpr std::array<std::string_view, 6> tensor = {"XX", "YY", "ZZ", "XY", "YZ", "XZ"};
	std::vector<int> as_they_are(components), places;
	std::iota(as_they_are.begin(), as_they_are.end(), 0);
	const std::string names = components == tensor.size() ? file.textOr("/CHA/" + field, "NOM") : "";
	for (std::size_t c = 0; c < components && c * kNameLength < names.size(); ++c)
	{
		std::string name = names.substr(c * kNameLength, kNameLength);
		name.erase(name.find_last_not_of(std::string_view(" \0", 2)) + 1);
		const auto found = std::ranges::find_if(tensor, [&](std::string_view end) { return name.ends_with(end); });
		const auto place = static_cast<int>(found - tensor.begin());
		if (found != tensor.end() && std::ranges::find(places, place) == places.end())
			places.push_back(place);
	}
	return places.size() == components ? places : as_they_are;
}

// Copies values that lie component by component into a stretch of an array.
void fillMed(const hdf5::File& file, const std::string& field, const std::string& group, vtkDoubleArray* array,
             vtkIdType first, vtkIdType count, manifest::Writer& manifest)
{
	const std::vector<std::string> profiles = file.namesIn(group);
	if (profiles.size() != 1 || profiles[0] != "MED_NO_PROFILE_INTERNAL")
		return manifest.warn(fmt::format("{} has values of a part alone, which are left out", array->GetName()));
	const std::vector<double> values = file.reals(group + "/" + profiles[0] + "/CO");
	const auto tuples = static_cast<std::size_t>(count);
	const auto components = static_cast<std::size_t>(array->GetNumberOfComponents());
	if (values.size() != tuples * components)
	{
		if (components * tuples != 0 && values.size() % (components * tuples) == 0)
			return manifest.warn(fmt::format("{} has several values in a cell, which are left out", array->GetName()));
		throw damaged(fmt::format("{} has {} values for {}", group, values.size(), tuples * components));
	}
	const std::vector<int> places = medPlaces(file, field, components);
	for (std::size_t i = 0; i < tuples; ++i)
		for (std::size_t c = 0; c < components; ++c)
			array->SetTypedComponent(first + static_cast<vtkIdType>(i), places[c], values[c * tuples + i]);
}

vtkSmartPointer<vtkDoubleArray> medArray(const hdf5::File& file, const std::string& field, vtkIdType tuples)
{
	const double components = file.realOr("/CHA/" + field, "NCO", 1);
	if (!(components >= 1 && components <= 64))
		throw damaged(fmt::format("{} has {} components", field, components));
	auto array = vtkSmartPointer<vtkDoubleArray>::New();
	array->SetName(field.c_str());
	array->SetNumberOfComponents(static_cast<int>(components));
	array->SetNumberOfTuples(tuples);
	array->Fill(std::numeric_limits<double>::quiet_NaN());
	std::string units = file.textOr("/CHA/" + field, "UNI").substr(0, 16); // the first component has them
	units.erase(units.find_last_not_of(' ') + 1);
	if (!units.empty())
		array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), units.c_str());
	return array;
}

void addMedField(const hdf5::File& file, const std::string& field, const std::string& step, MedMesh& mesh,
                 manifest::Writer& manifest)
{
	const std::string group = "/CHA/" + field + "/" + step + "/";
	if (file.has(group + "NOE"))
	{
		const auto array = medArray(file, field, mesh.nodes);
		fillMed(file, field, group + "NOE", array, 0, mesh.nodes, manifest);
		mesh.grid->GetPointData()->AddArray(array);
	}
	if (std::ranges::any_of(mesh.cells, [&](const MedCells& cells) { return file.has(group + "NOE." + cells.kind); }))
		manifest.warn(fmt::format("{} has values at the nodes of each cell, which are left out", field));
	vtkSmartPointer<vtkDoubleArray> of_cells;
	for (const MedCells& cells : mesh.cells)
		if (const std::string part = group + "MAI." + cells.kind; file.has(part))
		{
			if (!of_cells)
				of_cells = medArray(file, field, mesh.grid->GetNumberOfCells());
			fillMed(file, field, part, of_cells, cells.first, cells.count, manifest);
		}
	if (of_cells)
		mesh.grid->GetCellData()->AddArray(of_cells);
}

} // namespace

void readMed(const Request& request, manifest::Writer& manifest)
{
	const hdf5::File file(request.file);
	const std::vector<std::string> fields = file.namesIn("/CHA");
	std::vector<std::vector<double>> lists; // the times of each field's steps
	for (const std::string& field : fields)
	{
		lists.emplace_back();
		for (const std::string& step : file.namesIn("/CHA/" + field))
			lists.back().push_back(file.realOr("/CHA/" + field + "/" + step, "PDT", 0.0));
	}
	std::vector<double> times = manifest::unitedTimes(lists);
	if (times.size() == 1)
		times.clear();
	const std::optional<manifest::TimeInList> time = manifest::chooseInLists(times, request);
	for (const std::string& name : file.namesIn("/ENS_MAA"))
	{
		MedMesh mesh;
		mesh.name = name;
		readMedMesh(file, mesh, manifest);
		for (std::size_t f = 0; f < fields.size(); ++f)
		{
			const std::string group = "/CHA/" + fields[f];
			std::string of = file.textOr(group, "MAI");
			of.erase(of.find_last_not_of(' ') + 1);
			const std::optional<std::size_t> place = time ? time->placeIn(lists[f]) : std::optional<std::size_t>(0);
			if ((of.empty() || of == name) && place && !lists[f].empty())
				addMedField(file, fields[f], file.namesIn(group)[*place], mesh, manifest);
		}
		manifest.setPrefix(name);
		manifest.add(mesh.grid);
	}
	manifest.offerTimes(std::move(times));
}

} // namespace vp::reader::meshes
