#include "slice/host_records.h"

namespace vp::slice
{

namespace
{

std::vector<shared::PolygonRecord> allOf(const MeshRecords& records)
{
	std::vector<shared::PolygonRecord> all(records.count());
	records.write(0, all);
	return all;
}

} // namespace

std::vector<shared::PolygonRecord> recordsFromMesh(const grid::BlockSet& blocks, const probe::Sheet& sheet,
                                                   const SheetMesh& mesh, const std::optional<FieldChoice>& field)
{
	return allOf(MeshRecords(blocks, sheet, mesh, field));
}

std::vector<shared::PolygonRecord> recordsFromMesh(const probe::Sheet& sheet, const SheetMesh& mesh,
                                                   std::span<const double> polygon_values)
{
	return allOf(MeshRecords(sheet, mesh, polygon_values));
}

traverse::LaneCut walkedCells(const traverse::LaneCut& cut)
{
	traverse::LaneCut walked;
	for (std::size_t i = 0; i < cut.cells.size(); ++i)
		if (cut.words[i] & shared::kWordWalk && cut.words[i] & shared::kWordCut)
		{
			walked.cells.push_back(cut.cells[i]);
			walked.words.push_back(cut.words[i]);
		}
	walked.cut_cells = walked.cells.size();
	return walked;
}

} // namespace vp::slice
