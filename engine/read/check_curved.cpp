#include "read/check_curved.h"

#include "grid/curved/curved_types.h"
#include "read/check_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vp::read
{

namespace
{

// Returns true if there is a cell of this type, degree and number of nodes. degrees: null if the number of nodes tells.
bool isCellOf(std::uint8_t type, std::size_t nodes, const std::int32_t* degrees)
{
	if (grid::hasMiddles(type, nodes))
		return true;
	if (!degrees || grid::cornerShape(type) == grid::CellShape::tetrahedron)
		return grid::degreeOf(type, nodes).has_value();
	return grid::nodesOf(type, {degrees[0], degrees[1], degrees[2]}) == nodes;
}

} // namespace

void checkCurvedCells(const CellMesh& mesh)
{
	const std::size_t cells = mesh.cells.types.size();
	if (!mesh.degrees.empty() && mesh.degrees.size() != 3 * cells)
		throw Unusable(fmt::format("{} degrees for {} cells; each has three", mesh.degrees.size(), cells));
	if (!mesh.weights.empty() && mesh.weights.size() != mesh.points.size())
		throw Unusable(fmt::format("{} rational weights for {} points", mesh.weights.size(), mesh.points.size()));
	for (std::size_t c = 0; c < cells && !mesh.cells.offsets.empty(); ++c)
	{
		const std::uint8_t type = mesh.cells.types[c];
		if (!grid::hasDegrees(type))
			continue;
		const auto nodes = static_cast<std::size_t>(mesh.cells.offsets[c + 1] - mesh.cells.offsets[c]);
		if (!isCellOf(type, nodes, mesh.degrees.empty() ? nullptr : &mesh.degrees[3 * c]))
			throw Unusable(fmt::format("cell {} of type {} lists {} points, which are no cell of degrees up to {}", c,
			                           type, nodes, grid::kMaxDegree));
	}
	const auto bad = [](double weight) { return !(weight > 0.0) || !std::isfinite(weight); };
	if (const auto* at = std::find_if(mesh.weights.data(), mesh.weights.data() + mesh.weights.size(), bad);
	    at != mesh.weights.data() + mesh.weights.size())
		throw Unusable(
		    fmt::format("point {} has the rational weight {}; they have to be above 0", at - mesh.weights.data(), *at));
}

} // namespace vp::read
