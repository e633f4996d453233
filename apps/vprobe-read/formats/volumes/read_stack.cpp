// A volume in slices of any format that has pictures of two dimensions, a file each. Where the files say where their
// pictures lie, the slices lie there; others lie one after the other, in the order in which they are given.
#include "vprobe-read/base/read_files.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace vp::reader::volumes
{

namespace
{

// Part of a distance by which two lengths may differ that are meant to be the same: as many digits as floats have.
constexpr double kSameLength = 1e-5;

struct FlatPicture
{
	std::string file; // its name without folder
	vtkSmartPointer<vtkImageData> image;
	std::array<double, 3> first{}; // place of its first value along its own axes
};

FlatPicture readPicture(const Request& request, const std::string& file, manifest::Writer& manifest)
{
	Request alone = request;
	alone.file = file;
	alone.slices.clear();
	alone.is_slice = true;
	const auto found = manifest.collect([&] { formats::readAnyFormat(alone, manifest); });
	FlatPicture picture{std::filesystem::path(file).filename().string(),
	                    found.size() == 1 ? vtkImageData::SafeDownCast(found[0]) : nullptr};
	if (!picture.image)
		throw Refusal(fmt::format("{} is no picture on an even grid; a stack is made of such", picture.file));
	const int* points = picture.image->GetDimensions();
	if (points[0] < 2 || points[1] < 2 || points[2] != 1)
		throw Refusal(fmt::format("{} has {} x {} x {} points, and a slice has one along z; leave `inputs` out",
		                          picture.file, points[0], points[1], points[2]));
	vtkImageData& image = *picture.image;
	for (int axis = 0; axis < 3; ++axis)
	{
		for (int i = 0; i < 3; ++i)
			picture.first[axis] += image.GetDirectionMatrix()->GetElement(i, axis) * image.GetOrigin()[i];
		picture.first[axis] += image.GetExtent()[2 * axis] * image.GetSpacing()[axis];
	}
	return picture;
}

bool areSame(double a, double b, double scale)
{
	return std::abs(a - b) <= kSameLength * std::abs(scale);
}

// Throws a Refusal unless two pictures may be slices of one volume.
void checkAlike(const FlatPicture& first, const FlatPicture& other)
{
	vtkImageData &a = *first.image, &b = *other.image;
	bool same = true;
	for (int axis = 0; axis < 2; ++axis)
		same = same && a.GetDimensions()[axis] == b.GetDimensions()[axis] &&
		       areSame(a.GetSpacing()[axis], b.GetSpacing()[axis], a.GetSpacing()[axis]);
	for (int i = 0; i < 9; ++i)
		same = same && areSame(a.GetDirectionMatrix()->GetElement(i / 3, i % 3),
		                       b.GetDirectionMatrix()->GetElement(i / 3, i % 3), 1.0);
	if (!same)
		throw Refusal(fmt::format("{} has another size or direction than {}; keep the slices of one volume together",
		                          other.file, first.file));
	for (int axis = 0; axis < 2; ++axis)
		if (!areSame(first.first[axis], other.first[axis], a.GetSpacing()[axis] * a.GetDimensions()[axis]))
			throw Refusal(fmt::format("{} lies beside {}, not above it; `inputs` blocks puts parts of a whole together",
			                          other.file, first.file));
}

// The places of the slices along their normal, in ascending order. Returns those of even distance as one step.
struct SlicePlaces
{
	std::vector<double> places;
	bool are_even = true;
	double step = 1.0;
};

SlicePlaces sortByPlace(std::vector<FlatPicture>& pictures)
{
	const auto place = [](const FlatPicture& picture) { return picture.first[2]; };
	const double spacing = pictures.front().image->GetSpacing()[2];
	SlicePlaces found;
	found.step = spacing > 0.0 ? spacing : 1.0;
	const bool say_nothing =
	    std::all_of(pictures.begin(), pictures.end(),
	                [&](const FlatPicture& picture) { return place(picture) == place(pictures.front()); });
	for (std::size_t i = 0; say_nothing && i < pictures.size(); ++i)
		found.places.push_back(place(pictures.front()) + static_cast<double>(i) * found.step);
	if (say_nothing)
		return found;
	std::stable_sort(pictures.begin(), pictures.end(),
	                 [&](const FlatPicture& a, const FlatPicture& b) { return place(a) < place(b); });
	for (const FlatPicture& picture : pictures)
		found.places.push_back(place(picture));
	const double whole = found.places.back() - found.places.front();
	found.step = whole / static_cast<double>(pictures.size() - 1);
	for (std::size_t i = 1; i < pictures.size(); ++i)
	{
		const double step = found.places[i] - found.places[i - 1];
		if (areSame(step, 0.0, found.step))
			throw Refusal(fmt::format("{} and {} lie in one place; leave one of them out", pictures[i - 1].file,
			                          pictures[i].file));
		found.are_even = found.are_even && std::abs(step - found.step) <= 1e-3 * found.step;
	}
	return found;
}

// Adds the point arrays that all pictures have, one behind the other.
void addArrays(const std::vector<FlatPicture>& pictures, vtkDataSet* volume, manifest::Writer& manifest)
{
	vtkPointData* first = pictures.front().image->GetPointData();
	for (int number = 0; number < first->GetNumberOfArrays(); ++number)
	{
		vtkDataArray* model = first->GetArray(number);
		if (!model)
			continue;
		const std::string name = model->GetName() ? model->GetName() : "";
		const auto array = vtkSmartPointer<vtkDataArray>::Take(model->NewInstance());
		array->SetName(name.c_str());
		array->CopyInformation(model->GetInformation());
		array->SetNumberOfComponents(model->GetNumberOfComponents());
		array->SetNumberOfTuples(volume->GetNumberOfPoints());
		vtkIdType at = 0;
		for (const FlatPicture& picture : pictures)
		{
			// Some formats name the array after the file.
			vtkPointData* arrays = picture.image->GetPointData();
			vtkDataArray* values = first->GetNumberOfArrays() == 1 && arrays->GetNumberOfArrays() == 1
			                           ? arrays->GetArray(0)
			                           : arrays->GetArray(name.c_str());
			if (!values || values->GetDataType() != model->GetDataType() ||
			    values->GetNumberOfComponents() != model->GetNumberOfComponents())
				throw Refusal(fmt::format("{} has no array {} of the type that {} has; keep the slices of one volume "
				                          "together",
				                          picture.file, name, pictures.front().file));
			array->InsertTuples(at, values->GetNumberOfTuples(), 0, values);
			at += values->GetNumberOfTuples();
		}
		volume->GetPointData()->AddArray(array);
	}
	if (pictures.front().image->GetCellData()->GetNumberOfArrays() > 0)
		manifest.warn("values of the cells of pictures are left out, since cells of a volume lie between two of them");
}

vtkSmartPointer<vtkDataSet> volumeOf(vtkImageData* picture, const SlicePlaces& slices)
{
	const int* points = picture->GetDimensions();
	const int layers = static_cast<int>(slices.places.size());
	vtkMatrix3x3* direction = picture->GetDirectionMatrix();
	if (slices.are_even)
	{
		// The pictures' origin counts from the subscript 0.
		auto volume = vtkSmartPointer<vtkImageData>::New();
		const int* extent = picture->GetExtent();
		std::array<double, 3> place;
		picture->TransformIndexToPhysicalPoint(extent[0], extent[2], extent[4], place.data());
		volume->SetDimensions(points[0], points[1], layers);
		volume->SetSpacing(picture->GetSpacing()[0], picture->GetSpacing()[1], slices.step);
		volume->SetOrigin(place.data());
		volume->SetDirectionMatrix(direction);
		return volume;
	}
	if (!direction->IsIdentity())
		throw Refusal("the slices are not evenly far apart, and oblique; resample them, or leave out those between");
	auto volume = vtkSmartPointer<vtkRectilinearGrid>::New();
	volume->SetDimensions(points[0], points[1], layers);
	for (int axis = 0; axis < 3; ++axis)
	{
		vtkNew<vtkDoubleArray> places;
		for (int i = 0; i < (axis == 2 ? layers : points[axis]); ++i)
			places->InsertNextValue(axis == 2 ? slices.places[i]
			                                  : picture->GetOrigin()[axis] +
			                                        picture->GetSpacing()[axis] * (picture->GetExtent()[2 * axis] + i));
		if (axis == 0)
			volume->SetXCoordinates(places);
		else if (axis == 1)
			volume->SetYCoordinates(places);
		else
			volume->SetZCoordinates(places);
	}
	return volume;
}

} // namespace

void readStack(const Request& request, manifest::Writer& manifest)
{
	std::vector<FlatPicture> pictures;
	for (const std::string& file : request.slices)
	{
		pictures.push_back(readPicture(request, file, manifest));
		checkAlike(pictures.front(), pictures.back());
	}
	if (pictures.size() < 2)
		throw Refusal("nothing to slice: one picture; a volume has two slices or more");
	const SlicePlaces slices = sortByPlace(pictures);
	const vtkSmartPointer<vtkDataSet> volume = volumeOf(pictures.front().image, slices);
	addArrays(pictures, volume, manifest);
	manifest.offerTimes({});
	manifest.addLone(volume);
}

} // namespace vp::reader::volumes
