#include "piece_checks.h"

#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

namespace vp::reader::vtk
{

void refusePieceWithoutFile()
{
	throw Refusal("one of its <Piece> elements names no file; give it the attribute Source");
}

void refuseOtherKind(std::string_view type_of_index, std::string_view type_of_piece, std::string_view source)
{
	const std::string_view wanted = type_of_index.substr(1);
	if (type_of_piece != wanted)
		throw Refusal(
		    fmt::format("its piece {} is no {}, as the index says; name a file of that kind", source, wanted));
}

void refuseMissingFields(const quick::Fields& of_index, const quick::Fields& of_piece, std::string_view source)
{
	for (const auto& [name, kind] : of_index)
		if (!of_piece.contains(name))
			throw Refusal(fmt::format("its piece {} has no {}, which the index names; write it there", source, name));
}

} // namespace vp::reader::vtk
