#include "plain_arrays.h"

#include "quick_file.h"

namespace vp::reader::quick
{

std::optional<std::vector<arrays::PlainArray>> plainArrays(const std::string& path)
try
{
	const File file(path);
	const text::XmlElement& piece = onlyChild(file.data(), "Piece");
	if (file.type() != "UnstructuredGrid")
		return std::nullopt;
	std::vector<arrays::PlainArray> plain;
	for (const text::XmlElement& section : piece.children)
	{
		const bool on_points = section.name == "PointData";
		if (!on_points && section.name != "CellData")
			continue;
		const std::uint64_t tuples =
		    numbersIn<std::uint64_t, 1>(piece.attribute(on_points ? "NumberOfPoints" : "NumberOfCells"))[0];
		for (const text::XmlElement& array : section.children)
		{
			const ArrayKind kind(array);
			if (tuples > ~std::uint64_t(0) / kind.tupleBytes())
				return std::nullopt;
			if (const auto offset = file.open(array, tuples * kind.tupleBytes())->placeInFile())
				plain.push_back(
				    {on_points, std::string(array.attribute("Name")), kind.type, kind.components, {*offset}});
		}
	}
	return plain;
}
catch (const arrays::NotQuick&)
{
	return std::nullopt;
}

} // namespace vp::reader::quick
