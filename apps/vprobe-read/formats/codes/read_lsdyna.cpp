// LS-DYNA's d3plot files, by a parser of our own: VTK 9.1's crashes if all states are in one file, writes past its
// memory at ids of nodes that are not there, and shows what lies in memory if a file is cut short. Solids and thick
// shells are read.
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/checks/lsdyna_words.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/time_choice.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <filesystem>
#include <map>

namespace vp::reader::codes
{

namespace
{

// A state: its file, and the word where it begins.
struct LsdynaState
{
	const checks::LsdynaWords* words;
	std::size_t at;
	double time() const { return words->real(at); }
};

// d3plot, d3plot01, d3plot02 ... The mesh is in the first, states follow in it and in the others.
class LsdynaFamily
{
public:
	explicit LsdynaFamily(const std::string& file)
	    : first_(file), words_{checks::LsdynaWords(first_.text())}, control_(words_.front())
	{
		if (control_.geometryWords() > words_.front().count())
			throw damaged("it ends within its mesh");
		findStates(words_.front(), behindTitles());
		for (int number = 1; number < 1000; ++number)
		{
			const std::string name = fmt::format("{}{:02}", file, number);
			std::error_code ignored;
			if (!std::filesystem::is_regular_file(name, ignored))
				break;
			const MappedText& text = others_.emplace_back(name);
			if (text.text().size() >= 64 * words_.front().width() && checks::LsdynaWords::isHead(text.text()))
				throw Refusal(fmt::format("{} has another mesh, since it was refined; that is not read", name));
			findStates(words_.emplace_back(text.text(), words_.front()), 0);
		}
	}

	const checks::LsdynaWords& mesh() const { return words_.front(); }
	const checks::LsdynaControl& control() const { return control_; }
	const std::vector<LsdynaState>& states() const { return states_; }

private:
	// Titles of parts may follow the mesh, behind a mark, up to another.
	std::size_t behindTitles() const
	{
		std::size_t at = control_.geometryWords();
		if (!mesh().isEnd(at))
			return at;
		constexpr std::int64_t kTitles = 90000, kContacts = 90002;
		++at;
		if (at >= mesh().count() || mesh().integer(at) < kTitles || mesh().integer(at) > kContacts)
			return mesh().count();
		while (at < mesh().count() && !mesh().isEnd(at))
			++at;
		return at + 1;
	}

	void findStates(const checks::LsdynaWords& words, std::size_t at)
	{
		const std::size_t size = control_.stateWords();
		for (; at < words.count() && !words.isEnd(at); at += size)
		{
			if (words.count() - at < size)
				throw damaged("it ends within a state");
			if (!states_.empty() && isZero(words, at, size))
				return; // room behind the last state
			states_.push_back({&words, at});
		}
	}

	static bool isZero(const checks::LsdynaWords& words, std::size_t at, std::size_t size)
	{
		for (const std::size_t end = at + size; at < end; ++at)
			if (words.integer(at) != 0)
				return false;
		return true;
	}

	MappedText first_;
	std::deque<MappedText> others_;
	std::deque<checks::LsdynaWords> words_;
	checks::LsdynaControl control_;
	std::vector<LsdynaState> states_;
};

// Repeated corners make wedges, pyramids and tetrahedra of a hexahedron.
void addLsdynaSolid(vtkUnstructuredGrid* grid, const std::array<vtkIdType, 8>& c)
{
	if (c[4] == c[3] && c[5] == c[3] && c[6] == c[3] && c[7] == c[3])
		grid->InsertNextCell(VTK_TETRA, 4, c.data());
	else if (c[5] == c[4] && c[6] == c[4] && c[7] == c[4])
		grid->InsertNextCell(VTK_PYRAMID, 5, c.data());
	else if (c[4] == c[5] && c[6] == c[7])
	{
		const std::array<vtkIdType, 6> wedge = {c[0], c[1], c[4], c[3], c[2], c[6]};
		grid->InsertNextCell(VTK_WEDGE, 6, wedge.data());
	}
	else
		grid->InsertNextCell(VTK_HEXAHEDRON, 8, c.data());
}

vtkSmartPointer<vtkUnstructuredGrid> lsdynaGrid(const LsdynaFamily& family)
{
	const checks::LsdynaControl& control = family.control();
	const checks::LsdynaWords& words = family.mesh();
	auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
	vtkNew<vtkIntArray> material;
	material->SetName("material");
	const auto addAll = [&](std::size_t at, std::int64_t count)
	{
		for (std::int64_t e = 0; e < count; ++e, at += 9)
		{
			std::array<vtkIdType, 8> corners;
			for (std::size_t i = 0; i < 8; ++i)
			{
				corners[i] = words.integer(at + i) - 1;
				if (corners[i] < 0 || corners[i] >= control.nodes)
					throw damaged(fmt::format("element {} has a node that is not there", e));
			}
			addLsdynaSolid(grid, corners);
			material->InsertNextValue(static_cast<int>(words.integer(at + 8)));
		}
	};
	grid->Allocate(control.solids + control.thick_shells);
	addAll(control.solidsAt(), control.solids);
	addAll(control.thickShellsAt(), control.thick_shells);
	grid->GetCellData()->AddArray(material);
	return grid;
}

// In the precision of the file.
vtkSmartPointer<vtkDataArray> emptyLsdynaArray(const checks::LsdynaWords& words)
{
	return vtkSmartPointer<vtkDataArray>::Take(
	    vtkDataArray::CreateDataArray(words.width() == sizeof(double) ? VTK_DOUBLE : VTK_FLOAT));
}

// An array of values that lie `step` words apart.
vtkSmartPointer<vtkDataArray> lsdynaArray(const checks::LsdynaWords& words, std::size_t at, std::size_t step,
                                          std::int64_t count, int components, const char* name)
{
	const auto array = emptyLsdynaArray(words);
	array->SetName(name);
	array->SetNumberOfComponents(components);
	array->SetNumberOfTuples(count);
	for (vtkIdType i = 0; i < count; ++i, at += step)
		for (int c = 0; c < components; ++c)
			array->SetComponent(i, c, words.real(at + static_cast<std::size_t>(c)));
	return array;
}

vtkSmartPointer<vtkPoints> lsdynaPoints(vtkDataArray* places)
{
	auto points = vtkSmartPointer<vtkPoints>::New();
	points->SetData(places);
	return points;
}

// Values at nodes follow each other kind by kind. The places are where the nodes have moved to, and come first. The
// manual counts the temperature before them, but LS-DYNA writes it behind them (issue 9 of lasso-python; VTK's reader).
void addLsdynaNodes(const checks::LsdynaControl& control, const LsdynaState& state, vtkUnstructuredGrid* grid,
                    manifest::Writer& manifest)
{
	const checks::LsdynaWords& words = *state.words;
	std::size_t at = state.at + control.nodesAt();
	const auto nodes = static_cast<std::size_t>(control.nodes);
	if (control.has_places != 0)
	{
		const auto moved = lsdynaArray(words, at, 3, control.nodes, 3, "places");
		const auto displacement = emptyLsdynaArray(words);
		displacement->DeepCopy(moved);
		displacement->SetName("displacement");
		for (vtkIdType i = 0; i < moved->GetNumberOfTuples(); ++i)
			for (int c = 0; c < 3; ++c)
				displacement->SetComponent(
				    i, c, moved->GetComponent(i, c) - grid->GetPoints()->GetData()->GetComponent(i, c));
		grid->SetPoints(lsdynaPoints(moved));
		grid->GetPointData()->AddArray(displacement);
		manifest.displacement().areInCoordinates();
		at += 3 * nodes;
	}
	const bool has_flux = control.temperatureWords() > 1;
	if (control.temperatureWords() == 1)
		grid->GetPointData()->AddArray(lsdynaArray(words, at, 1, control.nodes, 1, "temperature"));
	if (has_flux || control.massWords() > 0)
	{
		manifest.warn(fmt::format("{} is left out at nodes, since programs disagree about its order beside {}",
		                          has_flux ? "all but the displacement" : "velocity and acceleration",
		                          has_flux ? "heat flux" : "mass scaling"));
		return;
	}
	at += control.temperatureWords() * nodes;
	for (const auto& [is_there, name] :
	     {std::pair{control.has_velocities, "velocity"}, {control.has_accelerations, "acceleration"}})
		if (is_there != 0)
		{
			grid->GetPointData()->AddArray(lsdynaArray(words, at, 3, control.nodes, 3, name));
			at += 3 * nodes;
		}
}

// Six stresses, the plastic strain, then what the material remembers. Thick shells have three such layers of which the
// first, the middle one, is taken.
void addLsdynaCells(const checks::LsdynaControl& control, const LsdynaState& state, vtkUnstructuredGrid* grid,
                    manifest::Writer& manifest)
{
	const auto fill = [&](int first, int components, const std::string& name)
	{
		const auto all = emptyLsdynaArray(*state.words);
		all->SetName(name.c_str());
		all->SetNumberOfComponents(components);
		const auto append = [&](std::size_t at, std::int64_t count, std::int64_t width)
		{
			if (count > 0 && width >= first + components)
				all->InsertTuples(all->GetNumberOfTuples(), count, 0,
				                  lsdynaArray(*state.words, state.at + at + static_cast<std::size_t>(first),
				                              static_cast<std::size_t>(width), count, components, ""));
		};
		append(control.solidValuesAt(), control.solids, control.solid_values);
		append(control.thickValuesAt(), control.thick_shells, control.thick_values);
		if (all->GetNumberOfTuples() == grid->GetNumberOfCells())
			grid->GetCellData()->AddArray(all);
		else if (all->GetNumberOfTuples() > 0)
			manifest.warn(fmt::format("{} is left out, since not all elements have it", name));
	};
	fill(0, 6, "stress");
	fill(6, 1, "plastic strain");
	for (int more = 7; more < std::min<std::int64_t>(control.solid_values, 7 + 32) && control.thick_shells == 0; ++more)
		fill(more, 1, fmt::format("history {}", more - 6));
	if (control.solid_values > 7 + 32 || (control.solid_values > 7 && control.thick_shells > 0))
		manifest.warn("more values that its materials remember are left out");
}

void hideDeleted(const checks::LsdynaControl& control, const LsdynaState& state, vtkUnstructuredGrid* grid)
{
	if (control.deletion == checks::LsdynaControl::Deletion::none)
		return;
	vtkNew<vtkUnsignedCharArray> marks;
	marks->SetName(vtkDataSetAttributes::GhostArrayName());
	marks->SetNumberOfTuples(grid->GetNumberOfCells());
	const std::size_t at = state.at + control.deletionAt();
	const auto isGone = [&](vtkIdType index) { return state.words->real(at + static_cast<std::size_t>(index)) == 0.0; };
	for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
	{
		bool gone = control.deletion == checks::LsdynaControl::Deletion::elements && isGone(cell);
		vtkIdType count = 0;
		const vtkIdType* corners = nullptr;
		grid->GetCellPoints(cell, count, corners);
		for (vtkIdType i = 0; control.deletion == checks::LsdynaControl::Deletion::nodes && i < count; ++i)
			gone = gone || isGone(corners[i]);
		marks->SetValue(cell, gone ? vtkDataSetAttributes::HIDDENCELL : 0);
	}
	grid->GetCellData()->AddArray(marks);
}

} // namespace

void readLsdyna(const Request& request, manifest::Writer& manifest)
{
	const LsdynaFamily family(request.file);
	const checks::LsdynaControl& control = family.control();
	if (control.solids + control.thick_shells == 0)
		throw Refusal("nothing to slice: it holds neither solids nor thick shells");
	const auto grid = lsdynaGrid(family);
	grid->SetPoints(lsdynaPoints(lsdynaArray(family.mesh(), control.placesAt(), 3, control.nodes, 3, "places")));
	std::vector<double> times;
	for (const LsdynaState& state : family.states())
		times.push_back(state.time());
	if (const auto step = manifest::offerSteps(times, request, manifest))
	{
		const LsdynaState& state = family.states()[*step];
		addLsdynaNodes(control, state, grid, manifest);
		addLsdynaCells(control, state, grid, manifest);
		hideDeleted(control, state, grid);
	}
	if (control.shells > 0 || control.beams > 0)
		manifest.warn(fmt::format("{} shells and {} beams are left out", control.shells, control.beams));
	manifest.add(grid);
}

} // namespace vp::reader::codes
