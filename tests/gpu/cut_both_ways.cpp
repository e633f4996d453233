#include "cut_both_ways.h"

#include "cases/case_table.h"
#include "classify/cpu_classifier.h"
#include "classify/gpu_planes.h"
#include "gpu/upload.h"
#include "mesh/mesh_values.h"
#include "mesh/sheet_mesh.h"

#include <map>

namespace vp::test
{

namespace
{

using PlaneInBlock = find::SheetInBlock<surface::Plane>;

// Seeds in every piece, some of them not cut.
std::vector<CellId> seedsOf(const grid::Block& block, const probe::Sheet& sheet)
{
	const std::vector<CellId> cut = scanCutCells(block, {sheet.origin, sheet.normal});
	std::vector<CellId> seeds{0, static_cast<CellId>(cellCount(block) - 1)};
	for (std::size_t i = 0; i < cut.size(); i += 11)
		seeds.push_back(cut[i]);
	return seeds;
}

std::vector<shared::PolygonRecord> download(const classify::SheetRecords::Page& page)
{
	std::vector<shared::PolygonRecord> records(page.count);
	EXPECT_TRUE(gpu::download(page.page->buffer, 0, std::as_writable_bytes(std::span(records))));
	return records;
}

// The values that a record should hold, in double precision.
struct ExpectedVertex
{
	PointId lower;
	PointId higher;
	double u;
	double v;
	double value;
};

class RecordChecker
{
public:
	RecordChecker(const grid::BlockSet& blocks, const std::optional<grid::FieldChoice>& field, bool singles)
	    : blocks_(blocks), field_(field), singles_(singles)
	{
	}

	void check(const probe::Sheet& sheet, std::uint32_t b, CellId cell, std::uint32_t code,
	           const shared::PolygonRecord& record)
	{
		const grid::Block& block = blocks_.blocks[b];
		ASSERT_EQ(record.cell, cell);
		if ((code & shared::kCodeWalk) || !(code & shared::kCodeCut))
		{
			ASSERT_EQ(record.vertices, 0u);
			return;
		}
		std::vector<ExpectedVertex> expected = expectedPolygon(sheet, b, cell, code);
		ASSERT_EQ(record.vertices, expected.size());
		// A float's rounding of positions and data of this size; in floats, what kMinDifferenceSingles leaves.
		const double size = block.bounds.diagonal() + glm::length(block.bounds.center() - sheet.origin);
		const double slack = singles_ ? 1e-3 * block.bounds.diagonal() + 1e-6 * size : 1e-6 * size;
		for (std::uint32_t i = 0; i < record.vertices; ++i)
		{
			expectOneVertexPerEdge({b, expected[i].lower, expected[i].higher},
			                       {record.uv[2 * i], record.uv[2 * i + 1]});
			EXPECT_NEAR(record.uv[2 * i], expected[i].u, slack);
			EXPECT_NEAR(record.uv[2 * i + 1], expected[i].v, slack);
			if (std::isnan(expected[i].value))
			{
				EXPECT_EQ(record.value[i], shared::kNanValue);
				continue;
			}
			// Slopes of the test data stay below 10.
			const double rounding = (singles_ ? 2e-2 : 3e-6) * (1.0 + std::abs(expected[i].value));
			EXPECT_NEAR(record.value[i], expected[i].value, rounding + (field_ ? 10.0 * slack : 0.0));
		}
	}

private:
	std::vector<ExpectedVertex> expectedPolygon(const probe::Sheet& sheet, std::uint32_t b, CellId cell,
	                                            std::uint32_t code) const
	{
		const grid::Block& block = blocks_.blocks[b];
		const grid::Field* values = field_ ? field_->in(block) : nullptr;
		const surface::Plane plane = sheet.plane();
		std::vector<ExpectedVertex> polygon;
		const auto trace = [&](const auto& grid)
		{
			const grid::CellPoints points = grid.cellPoints(cell);
			const cases::Case& entry = cases::caseTable(grid.shape(cell))[code & 0xFFu];
			for (int e = 0; e < entry.edges; ++e)
			{
				const PointId a = points.id[entry.edge[e][0]];
				const PointId c = points.id[entry.edge[e][1]];
				mesh::EdgePoint at{b, std::min(a, c), std::max(a, c), 0.0};
				const Vec3 low = grid.point(at.lower);
				const Vec3 high = grid.point(at.higher);
				at.t = plane.signedDistance(low) / (plane.signedDistance(low) - plane.signedDistance(high));
				const Vec3 from_origin = low + at.t * (high - low) - sheet.origin;
				double value = field_ ? std::numeric_limits<double>::quiet_NaN() : 0.0;
				if (values && values->association == grid::Association::point)
					value = mesh::interpolate(block, *values, field_->component, at);
				else if (values)
					value = mesh::cellValue(block, *values, field_->component, cell);
				polygon.push_back({at.lower, at.higher, glm::dot(from_origin, sheet.xAxis()),
				                   glm::dot(from_origin, sheet.up), value});
			}
		};
		std::visit(trace, block.grid);
		if (glm::dot(plane.normal(), sheet.normal) < 0.0)
			std::reverse(polygon.begin(), polygon.end());
		return polygon;
	}

	// To the last bit, or there would be cracks between polygons.
	void expectOneVertexPerEdge(const std::array<std::uint32_t, 3>& edge, const std::array<float, 2>& uv)
	{
		const auto& [at, is_new] = vertices_.try_emplace(edge, uv);
		EXPECT_EQ(at->second, uv);
	}

	const grid::BlockSet& blocks_;
	const std::optional<grid::FieldChoice>& field_;
	bool singles_;
	std::map<std::array<std::uint32_t, 3>, std::array<float, 2>> vertices_; // vertices of the sheet, by block and edge
};

} // namespace

CutBothWays cutBothWays(classify::GpuBlocks& blocks, std::span<const probe::Sheet> sheets,
                        const std::optional<grid::FieldChoice>& field, Timeline* timeline)
{
	const grid::BlockSet& set = blocks.blocks();
	std::vector<PlaneInBlock> lanes;
	std::vector<std::unique_ptr<find::VisitedMarks>> marks;
	for (std::uint32_t s = 0; s < sheets.size(); ++s)
		for (std::uint32_t b = 0; b < set.blocks.size(); ++b)
		{
			marks.push_back(std::make_unique<find::VisitedMarks>(cellCount(set.blocks[b])));
			lanes.push_back({&set.blocks[b], sheets[s].plane(), marks.back().get(), seedsOf(set.blocks[b], sheets[s])});
		}
	const auto traverse = [&](auto& classifier)
	{
		for (const auto& mark : marks)
			mark->beginCut();
		Result<std::vector<find::CellCut>> cuts =
		    find::breadthFirst<surface::Plane>(std::span<PlaneInBlock>(lanes), classifier);
		EXPECT_TRUE(cuts) << cuts.error().message;
		return std::move(*cuts);
	};

	CutBothWays cut;
	cut.singles = !blocks.usesDoubles();
	classify::CpuClassifier<surface::Plane> cpu(lanes);
	cut.cpu = traverse(cpu);
	const std::vector<std::optional<grid::FieldChoice>> fields(sheets.size(), field);
	Result<classify::PlanesOnGpu> planes = classify::planesOnGpu(blocks, sheets, fields);
	EXPECT_TRUE(planes) << planes.error().message;
	cut.records = planes->records;
	auto gpu = classify::GpuClassifier::create(
	    blocks, std::move(planes->sheets), [&](auto fronts) { return cpu.classify(fronts); }, timeline);
	EXPECT_TRUE(gpu) << gpu.error().message;
	cut.gpu = traverse(**gpu);
	gpu->reset(); // waits
	for (std::size_t lane = 0; lane < lanes.size(); ++lane)
		for (std::size_t i = 0; i < cut.gpu[lane].cells.size(); ++i)
		{
			const bool gpu_walks = cut.gpu[lane].codes[i] & shared::kCodeWalk;
			cut.walked += gpu_walks && !(cut.cpu[lane].codes[i] & shared::kCodeWalk);
			++cut.cells;
		}
	return cut;
}

void expectSameCells(const CutBothWays& cut)
{
	ASSERT_EQ(cut.gpu.size(), cut.cpu.size());
	for (std::size_t lane = 0; lane < cut.gpu.size(); ++lane)
	{
		const find::CellCut& gpu = cut.gpu[lane];
		const find::CellCut& cpu = cut.cpu[lane];
		ASSERT_EQ(gpu.cells, cpu.cells);
		EXPECT_EQ(gpu.cut_cells, cpu.cut_cells);
		EXPECT_EQ(gpu.generation_starts, cpu.generation_starts);
		for (std::size_t i = 0; i < gpu.cells.size(); ++i)
		{
			ASSERT_EQ(gpu.codes[i] & ~shared::kCodeWalk, cpu.codes[i] & ~shared::kCodeWalk) << "cell " << gpu.cells[i];
			// If the case table has no answer, the GPU has none either.
			ASSERT_TRUE(!(cpu.codes[i] & shared::kCodeWalk) || (gpu.codes[i] & shared::kCodeWalk))
			    << "cell " << gpu.cells[i];
		}
	}
}

void expectRecords(const grid::BlockSet& blocks, std::span<const probe::Sheet> sheets,
                   const std::optional<grid::FieldChoice>& field, const CutBothWays& cut)
{
	ASSERT_EQ(cut.records.size(), sheets.size());
	for (std::size_t s = 0; s < sheets.size(); ++s)
	{
		const classify::SheetRecords& records = *cut.records[s];
		std::vector<std::vector<shared::PolygonRecord>> pages;
		std::vector<std::vector<bool>> covered;
		for (const classify::SheetRecords::Page& page : records.pages)
		{
			pages.push_back(download(page));
			covered.emplace_back(page.count, false);
		}
		RecordChecker checker(blocks, field, cut.singles);
		std::map<std::uint32_t, std::size_t> next_cell; // per block
		for (const classify::SheetRecords::Run& run : records.runs)
		{
			const find::CellCut& lane = cut.gpu[s * blocks.blocks.size() + run.block];
			ASSERT_EQ(run.first_cell, next_cell[run.block]);
			next_cell[run.block] += run.count;
			for (std::uint32_t i = 0; i < run.count; ++i)
			{
				const std::size_t at = run.first_cell + i;
				ASSERT_LT(at, lane.cells.size());
				covered[run.page].at(run.first + i) = true;
				checker.check(sheets[s], run.block, lane.cells[at], lane.codes[at], pages[run.page].at(run.first + i));
				if (testing::Test::HasFatalFailure() || testing::Test::HasNonfatalFailure())
				{
					ADD_FAILURE() << "sheet " << s << ", block " << blocks.blocks[run.block].name << ", cell "
					              << lane.cells[at];
					return;
				}
			}
		}
		for (const auto& [block, count] : next_cell)
			EXPECT_EQ(count, cut.gpu[s * blocks.blocks.size() + block].cells.size());
		// The records between runs are drawn too, so they must be empty.
		for (std::size_t p = 0; p < pages.size(); ++p)
			for (std::size_t i = 0; i < pages[p].size(); ++i)
				EXPECT_TRUE(covered[p][i] || pages[p][i].vertices == 0) << "record " << i << " of page " << p;
	}
}

} // namespace vp::test
