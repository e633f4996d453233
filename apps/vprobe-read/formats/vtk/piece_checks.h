#pragma once

#include "vprobe-read/quick/xml_arrays.h"

#include <string_view>

namespace vp::reader::vtk
{

// An index of pieces and its pieces must say the same. All these throw a Refusal. source: a piece's file, as the index
// spells it.

[[noreturn]] void refusePieceWithoutFile();
// types: those of the files, such as PUnstructuredGrid and UnstructuredGrid.
void refuseOtherKind(std::string_view type_of_index, std::string_view type_of_piece, std::string_view source);
// VTK's reader would return uninitialized memory for a missing array.
void refuseMissingFields(const quick::Fields& of_index, const quick::Fields& of_piece, std::string_view source);

} // namespace vp::reader::vtk
