#include "picture/sheet_values.h"

#include "cut/polygon_generations.h"
#include "mesh/mesh_values.h"

#include <limits>

namespace vp::picture
{

namespace
{

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

render::SheetValues sheetValues(const grid::BlockSet& blocks, const cut::SheetCut& sheet, const mesh::SheetMesh& mesh,
                                bool by_generation)
{
	if (by_generation)
		return {{}, cut::polygonGenerations(sheet, mesh)};
	if (!sheet.field)
		return {};
	if (sheet.field->association == grid::Association::cell)
		return {{}, polygonValues(blocks, mesh, *sheet.field)};
	const RawVector<double> values =
	    mesh::vertexValues(blocks, mesh, sheet.field->inEach(blocks), sheet.field->component);
	return {{values.begin(), values.end()}, {}};
}

} // namespace vp::picture
