#include "picture/sheet_values.h"

#include "cut/polygon_generations.h"
#include "mesh/mesh_values.h"

namespace vp::picture
{

render::SheetValues sheetValues(const grid::BlockSet& blocks, const cut::SheetCut& sheet, const mesh::SheetMesh& mesh,
                                bool by_generation)
{
	if (by_generation)
		return {{}, cut::polygonGenerations(sheet, mesh)};
	if (!sheet.field)
		return {};
	if (sheet.field->association == grid::Association::cell)
		return {{}, mesh::polygonValues(blocks, mesh, sheet.field->inEach(blocks), sheet.field->component)};
	const RawVector<double> values =
	    mesh::vertexValues(blocks, mesh, sheet.field->inEach(blocks), sheet.field->component);
	return {{values.begin(), values.end()}, {}};
}

ShownPolygons shownPolygons(const grid::BlockSet& blocks, const cut::SheetCut& sheet, const session::SheetStats& stats,
                            bool by_generation)
{
	if (stats.parts && !by_generation)
		return {stats.parts->mesh, {{}, stats.parts->values}};
	const mesh::SheetMesh& mesh = stats.shown && !by_generation ? *stats.shown
	                              : stats.crinkle               ? *stats.crinkle
	                                                            : stats.mesh;
	return {mesh, sheetValues(blocks, sheet, mesh, by_generation)};
}

} // namespace vp::picture
