#include "value_image.h"

#include "parts/part_bytes.h"
#include "vprobe-read/base/refusal.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkPointData.h>

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace vp::reader::arrays
{

using grid::NumberType;

namespace
{

constexpr int kVtkTypes[] = {VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,     VTK_UNSIGNED_SHORT,
                             VTK_INT,         VTK_UNSIGNED_INT,  VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG,
                             VTK_FLOAT,       VTK_DOUBLE};

} // namespace

int vtkTypeOf(NumberType type)
{
	return kVtkTypes[static_cast<std::size_t>(type)];
}

std::optional<NumberType> numberTypeOfVtk(int type)
{
	// They have 64 bits in every VTK that we are built against.
	static_assert(sizeof(vtkIdType) == 8 && sizeof(long) == 8);
	if (type == VTK_ID_TYPE || type == VTK_LONG)
		return NumberType::int64;
	if (type == VTK_UNSIGNED_LONG)
		return NumberType::uint64;
	if (type == VTK_CHAR)
		return NumberType::int8;
	const auto* found = std::ranges::find(kVtkTypes, type);
	return found == std::end(kVtkTypes) ? std::nullopt : std::optional(static_cast<NumberType>(found - kVtkTypes));
}

std::uint64_t ValueLayout::valueCount() const
{
	std::uint64_t count = components;
	for (const std::uint32_t side : points)
		if (__builtin_mul_overflow(count, side, &count) || count > std::uint64_t(1) << 48)
			throw damaged("it says that it has more values than there can be");
	return count;
}

std::uint64_t ValueLayout::byteCount() const
{
	return valueCount() * byteSize(type);
}

const char* unitsOf(vtkDataArray* array)
{
	return array->HasInformation() ? array->GetInformation()->Get(vtkDataArray::UNITS_LABEL()) : nullptr;
}

vtkSmartPointer<vtkDataArray> emptyArray(const ValueLayout& layout, const std::string& name, Room room)
{
	auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(vtkTypeOf(layout.type)));
	array->SetName(name.c_str());
	array->SetNumberOfComponents(static_cast<int>(layout.components));
	if (room == Room::made)
		array->SetNumberOfTuples(static_cast<vtkIdType>(layout.valueCount() / layout.components));
	return array;
}

vtkSmartPointer<vtkDataArray> arrayOf(std::string_view bytes, const ValueLayout& layout, const std::string& name)
{
	if (bytes.size() != layout.byteCount())
		throw damaged(fmt::format("{} bytes of values where {} are wanted", bytes.size(), layout.byteCount()));
	auto array = emptyArray(layout, name);
	char* at = static_cast<char*>(array->GetVoidPointer(0));
	bytes.copy(at, bytes.size()); // there may be none, and no place for them
	if (layout.is_big_endian && byteSize(layout.type) > 1)
		parts::swapNumbers(std::as_writable_bytes(std::span(at, bytes.size())), byteSize(layout.type));
	return array;
}

vtkSmartPointer<vtkImageData> imageOf(vtkDataArray* array, const std::array<std::uint32_t, 3>& points)
{
	auto image = vtkSmartPointer<vtkImageData>::New();
	image->SetDimensions(static_cast<int>(points[0]), static_cast<int>(points[1]), static_cast<int>(points[2]));
	image->GetPointData()->SetScalars(array);
	return image;
}

} // namespace vp::reader::arrays
