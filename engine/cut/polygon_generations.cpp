#include "cut/polygon_generations.h"

#include <limits>
#include <unordered_map>

namespace vp::cut
{

std::vector<double> polygonGenerations(const SheetCut& sheet, const mesh::SheetMesh& mesh)
{
	std::vector<std::unordered_map<CellId, double>> of_block(sheet.cuts.size());
	for (std::size_t b = 0; b < sheet.cuts.size(); ++b)
	{
		if (sheet.cuts[b].hasSpans())
			continue; // in no generations
		const find::CellCut& cut = sheet.cuts[b].cells();
		for (std::size_t g = 0; g < cut.generations(); ++g)
			for (std::uint32_t i = cut.generation_starts[g]; i < cut.generation_starts[g + 1]; ++i)
				of_block[b].emplace(cut.cells[i], static_cast<double>(g));
	}
	std::vector<double> generations;
	generations.reserve(mesh.polygons());
	const std::size_t cut_polygons = mesh.polygons() - mesh.boundary_polygons;
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		const mesh::BlockCell& from = mesh.polygon_cells[p];
		if (const find::BlockCut& cut = sheet.cuts[from.block]; p < cut_polygons && cut.hasSpans() && cut.steps() == 1)
		{
			generations.push_back(0.0); // a device classified all cells at once
			continue;
		}
		const auto found = of_block[from.block].find(from.cell);
		generations.push_back(found == of_block[from.block].end() ? std::numeric_limits<double>::quiet_NaN()
		                                                          : found->second);
	}
	return generations;
}

} // namespace vp::cut
