#include "stored_array.h"

#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkInformationIdTypeKey.h>

#include <deque>

namespace vp::reader::arrays
{

namespace
{

// Arrays keep this when data sets are copied.
vtkInformationIdTypeKey* placeKey()
{
	static auto* const key = new vtkInformationIdTypeKey("STORED_PLACE", "vprobe"); // VTK keeps all keys to the end
	return key;
}

std::deque<StoredPlace>& storedPlaces()
{
	static std::deque<StoredPlace> places;
	return places;
}

} // namespace

StoredPlace storedRows(const std::string& file, std::uint64_t offset, const ValueLayout& layout)
{
	return storedRows(file, offset, {layout.points[0], layout.points[1], layout.points[2]},
	                  layout.components * byteSize(layout.type), layout.is_big_endian && byteSize(layout.type) > 1);
}

vtkSmartPointer<vtkDataArray> storedArray(const ValueLayout& layout, const std::string& name, StoredPlace place)
{
	const auto array = emptyArray(layout, name, Room::none);
	// Nobody frees these values, and whoever looks at them ends the reader.
	array->SetVoidArray(reinterpret_cast<void*>(std::uintptr_t(64)), static_cast<vtkIdType>(layout.valueCount()), 1);
	storedPlaces().push_back(std::move(place));
	array->GetInformation()->Set(placeKey(), static_cast<vtkIdType>(storedPlaces().size() - 1));
	return array;
}

vtkSmartPointer<vtkDataArray> arrayInFile(const Request& request, const MappedText& file, std::string_view bytes,
                                          const ValueLayout& layout, const std::string& name)
{
	if (!request.leaves(bytes.size()) || bytes.size() != layout.byteCount())
		return arrayOf(bytes, layout, name);
	const auto begin = static_cast<std::uint64_t>(bytes.data() - file.text().data());
	return storedArray(layout, name, storedRows(request.file, begin, layout));
}

const StoredPlace* storedPlaceOf(vtkDataArray* array)
{
	if (!array->HasInformation() || !array->GetInformation()->Has(placeKey()))
		return nullptr;
	return &storedPlaces()[static_cast<std::size_t>(array->GetInformation()->Get(placeKey()))];
}

} // namespace vp::reader::arrays
