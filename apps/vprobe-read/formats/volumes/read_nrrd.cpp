// NRRD through teem, whose format it is: VTK 9.1 reads no header with several data files, and no directions.
#include "base/real_text.h"
#include "nrrd_axes.h"
#include "nrrd_file.h"
#include "vprobe-read/arrays/stored_array.h"
#include "vprobe-read/arrays/value_image.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/cells/structured_blocks.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/time_choice.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

namespace vp::reader::volumes
{

namespace
{

// The order that VTK wants: components run fastest, then space; time comes last.
std::vector<unsigned> wantedOrder(const NrrdAxes& axes)
{
	std::vector<unsigned> order = axes.components;
	order.insert(order.end(), axes.space.begin(), axes.space.end());
	if (axes.time)
		order.push_back(*axes.time);
	return order;
}

// Puts the axes in this order.
void orderAxes(NrrdPointer& nrrd, NrrdAxes& axes)
{
	std::vector<unsigned> order = wantedOrder(axes);
	if (!std::is_sorted(order.begin(), order.end()))
	{
		NrrdPointer permuted(nrrdNew());
		if (nrrdAxesPermute(permuted.get(), nrrd.get(), order.data()))
			throw damaged(biffReason());
		std::swap(permuted->content, nrrd->content); // teem says there what it did
		nrrd = std::move(permuted);
	}
	unsigned next = 0;
	for (unsigned& axis : axes.components)
		axis = next++;
	for (unsigned& axis : axes.space)
		axis = next++;
	if (axes.time)
		axes.time = next;
}

// A picture without directions gets a third axis of one sample.
void addFlatAxis(NrrdPointer& nrrd)
{
	int open = 0, space = 0;
	for (unsigned i = 0; i < nrrd->dim; ++i)
	{
		open += nrrd->axis[i].kind == nrrdKindUnknown;
		space += nrrd->axis[i].kind == nrrdKindDomain || nrrd->axis[i].kind == nrrdKindSpace;
	}
	if (nrrd->spaceDim > 0 || open + space != 2)
		return;
	NrrdPointer with_axis(nrrdNew());
	if (nrrdAxesInsert(with_axis.get(), nrrd.get(), nrrd->dim))
		throw damaged(biffReason());
	std::swap(with_axis->content, nrrd->content); // teem says there what it did
	with_axis->axis[nrrd->dim].kind = space > 0 ? nrrdKindSpace : nrrdKindUnknown;
	nrrd = std::move(with_axis);
}

arrays::ValueLayout layoutOf(const Nrrd& nrrd, const NrrdAxes& axes)
{
	arrays::ValueLayout layout;
	layout.type = typeOfNrrd(nrrd.type);
	for (std::size_t a = 0; a < 3; ++a)
	{
		if (nrrd.axis[axes.space[a]].size > 1u << 30)
			throw damaged("an axis of more samples than there can be");
		layout.points[a] = static_cast<std::uint32_t>(nrrd.axis[axes.space[a]].size);
	}
	std::size_t components = 1;
	for (const unsigned axis : axes.components)
		components *= nrrd.axis[axis].size;
	layout.components = static_cast<std::uint32_t>(components);
	return layout;
}

std::string nameOfNrrd(const Nrrd& nrrd)
{
	return nrrd.content && *nrrd.content ? nrrd.content : "NRRD";
}

std::optional<std::string> nrrdKey(Nrrd& nrrd, const std::string& key)
{
	char* found = nrrdKeyValueGet(&nrrd, key.c_str());
	const std::optional<std::string> value = found ? std::optional<std::string>(found) : std::nullopt;
	std::free(found);
	return value;
}

// As 3D Slicer writes them: "file.seg.nrrd", with keys for each segment.
bool isSegmentation(Nrrd& nrrd, const std::string& file)
{
	if (std::filesystem::path(file).stem().extension() == ".seg")
		return true;
	return nrrdKey(nrrd, "Segment0_ID").has_value();
}

// The names of 3D Slicer's segments, by their values. Segments of two layers may have one value; such have no name.
std::vector<std::pair<double, std::string>> segmentNames(Nrrd& nrrd)
{
	std::map<double, std::string> names;
	std::set<double> taken;
	for (int segment = 0; nrrdKey(nrrd, fmt::format("Segment{}_ID", segment)); ++segment)
	{
		const auto value = nrrdKey(nrrd, fmt::format("Segment{}_LabelValue", segment));
		const std::optional<double> number = value ? parseReal(*value) : std::nullopt;
		const auto name = nrrdKey(nrrd, fmt::format("Segment{}_Name", segment));
		if (!number || !std::isfinite(*number))
			continue;
		if (!taken.insert(*number).second)
			names.erase(*number);
		else if (name && !name->empty())
			names[*number] = *name;
	}
	return {names.begin(), names.end()};
}

// Returns the header of a file whose values may stay where they are.
std::optional<NrrdHead> nrrdInFile(const Request& request)
{
	std::optional<NrrdHead> head =
	    request.is_slice || request.stays_above == ~std::uint64_t(0) ? std::nullopt : plainNrrd(request.file);
	if (!head)
		return std::nullopt;
	const NrrdAxes axes = nrrdAxes(*head->nrrd);
	const std::vector<unsigned> order = wantedOrder(axes);
	vtkNew<vtkMatrix3x3> direction;
	direction->DeepCopy(nrrdPlace(*head->nrrd, axes).direction.data());
	const bool stays = std::is_sorted(order.begin(), order.end()) && cells::isAxisAligned(direction) &&
	                   request.leaves(layoutOf(*head->nrrd, axes).byteCount());
	return stays ? std::move(head) : std::nullopt;
}

// The values of one time.
vtkSmartPointer<vtkDataArray> valuesOfNrrd(Nrrd& nrrd, const arrays::ValueLayout& layout, bool has_times,
                                           std::size_t step)
{
	const std::string name = nameOfNrrd(nrrd);
	const auto values = arrays::emptyArray(layout, name, has_times ? arrays::Room::made : arrays::Room::none);
	if (!has_times)
		// From now on they belong to the array, which may be kept for longer. teem has them from malloc().
		values->SetVoidArray(std::exchange(nrrd.data, nullptr), static_cast<vtkIdType>(layout.valueCount()), 0,
		                     vtkAbstractArray::VTK_DATA_ARRAY_FREE);
	else
		std::copy_n(static_cast<const char*>(nrrd.data) + step * layout.byteCount(), layout.byteCount(),
		            static_cast<char*>(values->GetVoidPointer(0)));
	return values;
}

} // namespace

void readNrrd(const Request& request, manifest::Writer& manifest)
{
	std::optional<NrrdHead> head = nrrdInFile(request);
	NrrdPointer nrrd = head ? std::move(head->nrrd) : loadNrrd(request.file);
	if (request.is_slice)
		addFlatAxis(nrrd);
	NrrdAxes axes = nrrdAxes(*nrrd);
	orderAxes(nrrd, axes);
	arrays::ValueLayout layout = layoutOf(*nrrd, axes);
	manifest::StepsInTime times = manifest::stepsInTime(nrrdTimes(*nrrd, axes), manifest);
	manifest::chooseIfAny(times.times, request);
	const std::size_t step = times.times.empty() ? 0 : times.steps[manifest::chooseStep(times.times, request)];

	vtkSmartPointer<vtkDataArray> values;
	if (head)
	{
		layout.is_big_endian = head->is_big_endian;
		const std::uint64_t begin = head->offset + step * layout.byteCount();
		values = arrays::storedArray(layout, nameOfNrrd(*nrrd), arrays::storedRows(head->file, begin, layout));
	}
	else
		values = valuesOfNrrd(*nrrd, layout, !times.times.empty(), step);
	const auto image = arrays::imageOf(values, layout.points);
	const NrrdPlace place = nrrdPlace(*nrrd, axes);
	image->SetOrigin(place.origin.data());
	image->SetSpacing(place.spacing.data());
	image->SetDirectionMatrix(place.direction.data());
	if (!place.note.empty())
		manifest.warn(place.note);
	manifest.setLengthUnits(place.length_units);
	manifest.setImaging({place.orientation, true, isSegmentation(*nrrd, request.file), {}, segmentNames(*nrrd)});
	manifest.setTimeUnits(nrrdTimeUnits(*nrrd, axes));
	manifest.addLone(image);
	manifest.offerTimes(std::move(times.times));
}

} // namespace vp::reader::volumes
