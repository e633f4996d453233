#include "displacement.h"

#include "vprobe-read/base/is_one_of.h"
#include "vprobe-read/base/refusal.h"

#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <string_view>
#include <vector>

namespace vp::reader::manifest
{

namespace
{

// code_aster lists rotations behind the displacements of nodes that beams and shells share.
constexpr int kWithRotations = 6;

std::string inSmallLetters(std::string_view text)
{
	std::string small(text);
	std::transform(small.begin(), small.end(), small.begin(), [](unsigned char c) { return std::tolower(c); });
	return small;
}

// The words of a name: what letters and digits stand together.
std::vector<std::string> wordsOf(std::string_view name)
{
	std::vector<std::string> words(1);
	for (const char c : inSmallLetters(name))
		if (std::isalnum(static_cast<unsigned char>(c)))
			words.back() += c;
		else if (!words.back().empty())
			words.emplace_back();
	return words;
}

bool namesDisplacement(std::string_view name)
{
	const std::string small = inSmallLetters(name);
	if (small.find("displ") != small.npos || small.find("deplac") != small.npos)
		return true;
	return std::ranges::any_of(wordsOf(name),
	                           [](std::string_view word) {
		                           return word.starts_with("depl") || word == "dis" ||
		                                  (word.starts_with("disp") && !word.starts_with("dispers"));
	                           });
}

bool namesStress(std::string_view name)
{
	if (isOneOf(std::string(name), {"S", "E", "LE", "PE", "PEEQ", "RF", "sigma", "epsilon", "sig", "eps"}))
		return true;
	return std::ranges::any_of(wordsOf(name),
	                           [](std::string_view word)
	                           {
		                           return word.starts_with("stress") || word.starts_with("strain") || word == "mises" ||
		                                  word.starts_with("sief") || word.starts_with("sigm") ||
		                                  word.starts_with("epsi");
	                           });
}

bool namesFluid(std::string_view name)
{
	return isOneOf(std::string(name), {"p", "p_rgh", "P", "phi", "nut", "k", "omega", "pressure", "Pressure"});
}

// True if the arrays are those of a solid, whose U is a displacement, and not of a fluid, whose U is a velocity.
bool isSolid(vtkDataSet* data)
{
	bool has_stress = false;
	for (vtkDataSetAttributes* fields : {static_cast<vtkDataSetAttributes*>(data->GetPointData()),
	                                     static_cast<vtkDataSetAttributes*>(data->GetCellData())})
		for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
		{
			const char* name = fields->GetArrayName(i);
			if (name && namesFluid(name))
				return false;
			has_stress |= name && namesStress(name);
		}
	return has_stress;
}

bool isVector(vtkDataArray* array, bool named)
{
	return array && array->GetName() &&
	       (array->GetNumberOfComponents() == 3 || (named && array->GetNumberOfComponents() == kWithRotations));
}

} // namespace

Displacement::Displacement(const std::string& text, bool keeps_places)
    : is_on_(!text.empty()), keeps_places_(keeps_places), factor_(std::strtod(text.c_str(), nullptr))
{
	if (const auto blank = text.find(' '); blank != text.npos)
		name_ = text.substr(blank + 1);
}

// The named one; or the first whose name says so; or U or D of a solid.
vtkDataArray* Displacement::arrayOf(vtkDataSet* data)
{
	vtkPointData* fields = data->GetPointData();
	vtkDataArray* found = nullptr;
	for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
	{
		vtkDataArray* array = fields->GetArray(i);
		const std::string name = array && array->GetName() ? array->GetName() : "";
		const bool is_named = name_.empty() ? namesDisplacement(name) : name == name_;
		if (!isVector(array, is_named))
			continue;
		vectors_.insert(name);
		if (!is_named)
			continue;
		candidates_.insert(name);
		if (!found)
			found = array;
	}
	for (const char* name : {"U", "u", "D"})
		if (vtkDataArray* array = fields->GetArray(name);
		    !found && name_.empty() && isVector(array, false) && isSolid(data))
			found = array;
	return found;
}

vtkSmartPointer<vtkDataSet> Displacement::moved(vtkDataSet* data)
{
	if (!is_on_ || pauses_ > 0 || data->GetNumberOfCells() == 0)
		return data;
	++seen_;
	vtkDataArray* moves = arrayOf(data);
	if (!moves || moves->GetNumberOfTuples() != data->GetNumberOfPoints())
		return data;
	++moved_;
	const double factor = is_in_coordinates_ ? factor_ - 1.0 : factor_;
	vtkNew<vtkDoubleArray> places;
	places->SetNumberOfComponents(3);
	places->SetNumberOfTuples(data->GetNumberOfPoints());
	for (vtkIdType p = 0; p < data->GetNumberOfPoints(); ++p)
	{
		std::array<double, 3> was;
		data->GetPoint(p, was.data());
		std::array<double, 3> place = was;
		for (int axis = 0; axis < 3; ++axis)
			place[static_cast<std::size_t>(axis)] += factor * moves->GetComponent(p, axis);
		places->SetTuple(p, place.data());
		if (keeps_places_)
			places_.emplace(was, place);
	}
	vtkNew<vtkPoints> points;
	points->SetData(places);
	vtkSmartPointer<vtkPointSet> made;
	std::array<int, 3> lattice = {0, 0, 0};
	if (auto* image = vtkImageData::SafeDownCast(data))
		image->GetDimensions(lattice.data());
	else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(data))
		rectilinear->GetDimensions(lattice.data());
	if (lattice[0] > 0)
	{
		const auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
		grid->SetDimensions(lattice.data());
		grid->GetPointData()->ShallowCopy(data->GetPointData());
		grid->GetCellData()->ShallowCopy(data->GetCellData());
		grid->GetFieldData()->ShallowCopy(data->GetFieldData());
		made = grid;
	}
	else
	{
		made = vtkSmartPointer<vtkPointSet>::Take(vtkPointSet::SafeDownCast(data->NewInstance()));
		made->ShallowCopy(data);
	}
	made->SetPoints(points);
	return made;
}

vtkSmartPointer<vtkPointSet> Displacement::movedPatch(vtkPointSet* patch) const
{
	if (places_.empty())
		return patch;
	vtkNew<vtkDoubleArray> places;
	places->SetNumberOfComponents(3);
	places->SetNumberOfTuples(patch->GetNumberOfPoints());
	for (vtkIdType p = 0; p < patch->GetNumberOfPoints(); ++p)
	{
		std::array<double, 3> place;
		patch->GetPoint(p, place.data());
		if (const auto known = places_.find(place); known != places_.end())
			place = known->second;
		places->SetTuple(p, place.data());
	}
	vtkNew<vtkPoints> points;
	points->SetData(places);
	const auto made = vtkSmartPointer<vtkPointSet>::Take(patch->NewInstance());
	made->ShallowCopy(patch);
	made->SetPoints(points);
	return made;
}

std::string Displacement::note() const
{
	if (!is_on_ || seen_ == 0)
		return {};
	if (moved_ == 0 && vectors_.empty())
		throw Refusal("`displace`: no array of its points has three components, so nothing says how they move; leave "
		              "the setting out");
	if (moved_ == 0 && !name_.empty())
		throw Refusal(fmt::format("`displace_by` {}: there is no such vector at its points; there are: {}", name_,
		                          fmt::join(vectors_, ", ")));
	if (moved_ == 0)
		throw Refusal(fmt::format("`displace`: no vector at its points has the name of a displacement; choose one by "
		                          "`displace_by`: {}",
		                          fmt::join(vectors_, ", ")));
	if (moved_ < seen_)
		return fmt::format("{} of its {} blocks have no displacements, and stay where they are", seen_ - moved_, seen_);
	if (candidates_.size() > 1)
		return fmt::format(
		    "several vectors have names of displacements ({}); the first of each block moves its points, "
		    "or the one that `displace_by` names",
		    fmt::join(candidates_, ", "));
	return {};
}

} // namespace vp::reader::manifest
