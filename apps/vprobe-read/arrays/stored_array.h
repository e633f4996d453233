#pragma once

#include "stored_place.h"
#include "value_image.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/request.h"

#include <vtkSmartPointer.h>

#include <string>
#include <string_view>

namespace vp::reader::arrays
{

// Returns the place of the values of a layout in one piece.
StoredPlace storedRows(const std::string& file, std::uint64_t offset, const ValueLayout& layout);

// Returns an array whose values stay in their file. It may be described, and has no values that could be read.
vtkSmartPointer<vtkDataArray> storedArray(const ValueLayout& layout, const std::string& name, StoredPlace place);

// Returns arrayOf() the bytes, which are a part of a mapped file; or a storedArray() if the request lets them stay
// there.
vtkSmartPointer<vtkDataArray> arrayInFile(const Request& request, const MappedText& file, std::string_view bytes,
                                          const ValueLayout& layout, const std::string& name);

// Returns the place of an array that storedArray() has made, or null.
const StoredPlace* storedPlaceOf(vtkDataArray* array);

} // namespace vp::reader::arrays
