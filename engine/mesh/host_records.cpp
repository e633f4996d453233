#include "mesh/host_records.h"

namespace vp::mesh
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
                                                   const SheetMesh& mesh, const std::optional<grid::FieldChoice>& field)
{
	return allOf(MeshRecords(blocks, sheet, mesh, field));
}

std::vector<shared::PolygonRecord> recordsFromMesh(const probe::Sheet& sheet, const SheetMesh& mesh,
                                                   std::span<const double> polygon_values)
{
	return allOf(MeshRecords(sheet, mesh, polygon_values));
}

} // namespace vp::mesh
