#include "session/sheet_values.h"

#include "cut/polygon_generations.h"
#include "mesh/mesh_values.h"

#include <limits>

namespace vp::session
{

namespace
{

std::vector<double> vertexValues(const grid::BlockSet& blocks, const mesh::SheetMesh& mesh,
                                 const grid::FieldChoice& field)
{
	const std::vector<const grid::Field*> fields = field.inEach(blocks);
	std::vector<double> values;
	values.reserve(mesh.positions.size());
	for (std::size_t v = 0; v < mesh.positions.size(); ++v)
		values.push_back(mesh::vertexValue(blocks, mesh, v, fields, field.component));
	return values;
}

std::vector<double> polygonValues(const grid::BlockSet& blocks, const mesh::SheetMesh& mesh,
                                  const grid::FieldChoice& field)
{
	std::vector<double> values;
	values.reserve(mesh.polygons());
	for (const auto& [b, cell] : mesh.polygon_cells)
	{
		const grid::Field* of_block = field.in(blocks.blocks[b]);
		values.push_back(of_block ? mesh::cellValue(blocks.blocks[b], *of_block, field.component, cell)
		                          : std::numeric_limits<double>::quiet_NaN());
	}
	return values;
}

} // namespace

render::SheetValues sheetValues(const Session& session, const cut::SheetCut& sheet, const mesh::SheetMesh& mesh,
                                bool by_generation)
{
	if (by_generation)
		return {{}, cut::polygonGenerations(sheet, mesh)};
	if (!sheet.field)
		return {};
	if (sheet.field->association == grid::Association::cell)
		return {{}, polygonValues(session.blocks, mesh, *sheet.field)};
	return {vertexValues(session.blocks, mesh, *sheet.field), {}};
}

} // namespace vp::session
