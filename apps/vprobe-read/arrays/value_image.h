#pragma once

#include "grid/field.h"

#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

class vtkDataArray;
class vtkImageData;

namespace vp::reader::arrays
{

// Describes how plain values lie in bytes: components run fastest, then x, y, z.
struct ValueLayout
{
	std::array<std::uint32_t, 3> points{0, 0, 0};
	std::uint32_t components = 1;
	grid::NumberType type = grid::NumberType::uint8;
	bool is_big_endian = false;

	std::uint64_t valueCount() const;
	// Throws a Refusal if the product is too large.
	std::uint64_t byteCount() const;
};

// Returns the type of numbers that VTK calls so, or nothing for other types: strings, bits and variants.
std::optional<grid::NumberType> numberTypeOfVtk(int type);
int vtkTypeOf(grid::NumberType type);

// Returns the units in the way that VTK's files store them, or null.
const char* unitsOf(vtkDataArray* array);

// Says whether an array gets room for its values.
enum class Room
{
	made,
	none
};
vtkSmartPointer<vtkDataArray> emptyArray(const ValueLayout& layout, const std::string& name, Room room = Room::made);

// Throws a Refusal unless `bytes` are as many as the layout says.
vtkSmartPointer<vtkDataArray> arrayOf(std::string_view bytes, const ValueLayout& layout, const std::string& name);

// An image with the array as its values, of distance 1 from the origin.
vtkSmartPointer<vtkImageData> imageOf(vtkDataArray* array, const std::array<std::uint32_t, 3>& points);

} // namespace vp::reader::arrays
