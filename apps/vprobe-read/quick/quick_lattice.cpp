#include "quick_lattice.h"

#include "base/ids.h"
#include "quick_file.h"
#include "vprobe-read/base/is_one_of.h"

#include <algorithm>

namespace vp::reader::quick
{

namespace
{

// Returns true if the quick reader can read some layers of an array alone, and if it hides no cells.
bool comesApart(const text::XmlElement& array)
{
	return isOneOf(array.attribute("format"), {"appended", "binary"}) &&
	       !isOneOf(array.attribute("Name"), {"vtkGhostType", "vtkGhostLevels"});
}

} // namespace

std::array<std::uint64_t, 3> latticePoints(const text::XmlElement& data, const text::XmlElement& piece)
{
	const auto extent = numbersIn<std::int32_t, 6>(data.attribute("WholeExtent"));
	if (numbersIn<std::int32_t, 6>(piece.attribute("Extent")) != extent)
		throw arrays::NotQuick();
	std::array<std::uint64_t, 3> points;
	std::uint64_t all = 1;
	for (std::size_t axis = 0; axis < 3; ++axis)
	{
		const std::int64_t count = std::int64_t(extent[2 * axis + 1]) - extent[2 * axis] + 1;
		if (count < 2 || count >= kMaxBlockIds)
			throw arrays::NotQuick();
		points[axis] = static_cast<std::uint64_t>(count);
		all *= points[axis];
		if (all >= kMaxBlockIds)
			throw arrays::NotQuick();
	}
	return points;
}

std::optional<Lattice> quickLattice(const std::string& path)
{
	try
	{
		const File file(path);
		const char* kind = file.type() == "ImageData"         ? "image"
		                   : file.type() == "RectilinearGrid" ? "rectilinear"
		                   : file.type() == "StructuredGrid"  ? "curvilinear"
		                                                      : nullptr;
		if (!kind)
			return std::nullopt;
		const text::XmlElement& piece = onlyChild(file.data(), "Piece");
		for (const text::XmlElement& set : piece.children)
			if (!std::ranges::all_of(set.children, comesApart))
				return std::nullopt;
		const text::XmlElement& data = file.data();
		if (data.has("Direction") &&
		    numbersIn<double, 9>(data.attribute("Direction")) != std::array<double, 9>{1, 0, 0, 0, 1, 0, 0, 0, 1})
			return std::nullopt; // a turned image
		return Lattice{kind, latticePoints(data, piece)};
	}
	catch (const arrays::NotQuick&)
	{
		return std::nullopt;
	}
}

} // namespace vp::reader::quick
