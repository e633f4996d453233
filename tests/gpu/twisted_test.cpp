#include "cut_both_ways.h"
#include "gpu_fixture.h"
#include "overlapping_sets.h"
#include "random_sets.h"
#include "tries.h"
#include "twisted_sets.h"

#include "cut/cutter.h"
#include "gpu/upload.h"

#include <map>

namespace vp::test
{

namespace
{

double areaOf(const shared::PolygonRecord& record)
{
	double twice = 0.0;
	const std::uint32_t vertices = record.vertices & shared::kRecordVertices;
	for (std::uint32_t i = 0; i < vertices; ++i)
	{
		const std::uint32_t next = (i + 1) % vertices;
		twice +=
		    double(record.uv[2 * i]) * record.uv[2 * next + 1] - double(record.uv[2 * next]) * record.uv[2 * i + 1];
	}
	return 0.5 * twice;
}

// Of what is drawn. The device's polygons run as their cells say, those of folded cells the other way; the host's run
// one way and lie in several records where they have many corners.
double drawnArea(const classify::SheetRecords& records)
{
	std::vector<std::vector<bool>> from_device;
	for (const classify::SheetRecords::Page& page : records.pages)
		from_device.emplace_back(page.count, false);
	for (const classify::SheetRecords::Run& run : records.runs)
		std::fill_n(from_device[run.page].begin() + run.first, run.count, true);
	double area = 0.0;
	for (std::size_t p = 0; p < records.pages.size(); ++p)
	{
		std::vector<shared::PolygonRecord> read(records.pages[p].count);
		EXPECT_TRUE(gpu::download(records.pages[p].page->buffer, 0, std::as_writable_bytes(std::span(read))));
		for (std::size_t i = 0; i < read.size(); ++i)
			area += from_device[p][i] ? std::abs(areaOf(read[i])) : areaOf(read[i]);
	}
	return area;
}

double meshArea(const mesh::SheetMesh& mesh, const Vec3& normal)
{
	Vec3 sum(0.0);
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		const auto polygon = mesh.polygon(p);
		for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
			sum += glm::cross(mesh.positions[polygon[i]] - mesh.positions[polygon[0]],
			                  mesh.positions[polygon[i + 1]] - mesh.positions[polygon[0]]);
	}
	return 0.5 * glm::dot(sum, normal);
}

void expectIdenticalMesh(const mesh::SheetMesh& a, const mesh::SheetMesh& b)
{
	EXPECT_EQ(a.cells_twisted, b.cells_twisted);
	EXPECT_EQ(a.polygon_starts, b.polygon_starts);
	EXPECT_EQ(a.polygon_vertices, b.polygon_vertices);
	EXPECT_EQ(a.positions, b.positions);
}

// The whole way of a slice with either classifier: the same mesh to the last bit, and drawn with its area.
void sliceBothWays(gpu::Device& device, const grid::BlockSet& set, const TestPlane& plane)
{
	cut::CutRequest request;
	request.in_generations = true;
	request.probe.sheets = {probe::makeSheet(plane.origin, plane.normal)};
	cut::Cutter on_cpu(set);
	auto on_gpu = cut::Cutter::onDevice(device, set, {}, nullptr);
	ASSERT_TRUE(on_gpu) << on_gpu.error().message;
	const Result<cut::Cut> cpu = on_cpu.cut(request);
	const Result<cut::Cut> gpu = (*on_gpu)->cut(request);
	ASSERT_TRUE(cpu && gpu);
	const mesh::SheetMesh mesh = cpu->mesh(set, 0);
	expectIdenticalMesh(mesh, gpu->mesh(set, 0));
	const double area = meshArea(mesh, request.probe.sheets[0].normal);
	EXPECT_NEAR(drawnArea(*gpu->sheets[0].records), area, 1e-5 * area);
}

// One block for each mask, all cut by one plane.
void cutMasks(gpu::Device& device, LatticeKind kind, std::uint32_t step)
{
	SCOPED_TRACE("kind " + std::to_string(static_cast<int>(kind)));
	RawSet raw;
	TestPlane plane{};
	const std::uint32_t all = (1u << twistedPoints(kind)) - 1u;
	for (std::uint32_t mask = 1; mask < all; mask += step)
	{
		const TwistedSet twisted = twistedSet(kind, mask, mask);
		raw.blocks.push_back(twisted.raw.blocks[0]);
		plane = twisted.plane;
	}
	grid::BlockSet set = build(raw);
	set.interfaces = {}; // the blocks lie one in the other and have nothing to do with each other
	const auto blocks = classify::GpuBlocks::create(device, set, {});
	ASSERT_TRUE(blocks) << blocks.error().message;
	const probe::Sheet sheet = probe::makeSheet(plane.origin, plane.normal);
	const grid::FieldChoice linear{"linear", grid::Association::point, 0};
	const CutBothWays cut = cutBothWays(**blocks, std::span(&sheet, 1), linear);
	expectSameCells(cut);
	expectRecords(set, std::span(&sheet, 1), linear, cut);
	sliceBothWays(device, set, plane);
}

} // namespace

using GpuTwisted = GpuTest;

TEST_F(GpuTwisted, EveryMaskOfEveryShape)
{
	for (const LatticeKind kind : {LatticeKind::curvilinear, LatticeKind::hexahedra, LatticeKind::wedges,
	                               LatticeKind::pyramids, LatticeKind::tetrahedra})
		cutMasks(device(), kind, 1);
}

TEST_F(GpuTwisted, PolyhedraWithWarpedFaces)
{
	cutMasks(device(), LatticeKind::polyhedra, 3);
	cutMasks(device(), LatticeKind::hexagonal, 61);
	cutMasks(device(), LatticeKind::doubles, 67);
}

TEST_F(GpuTwisted, RandomSetsAndPlanes)
{
	for (unsigned number = 0; number < 60; ++number)
	{
		SCOPED_TRACE(number);
		const grid::BlockSet set = build(randomSet(5000 + number));
		const auto blocks = classify::GpuBlocks::create(device(), set, {});
		ASSERT_TRUE(blocks) << blocks.error().message;
		for (unsigned n = 0; n < 4; ++n)
		{
			const TestPlane plane = randomPlane(set, 4 * number + n);
			const probe::Sheet sheet = probe::makeSheet(plane.origin, plane.normal);
			const CutBothWays cut = cutBothWays(**blocks, std::span(&sheet, 1), {});
			expectSameCells(cut);
			expectRecords(set, std::span(&sheet, 1), {}, cut);
		}
		if (testing::Test::HasFailure())
			return;
	}
}

TEST_F(GpuTwisted, CellsThatOverlap)
{
	Taken taken;
	for (const RawSet& raw : overlappingSets())
	{
		SCOPED_TRACE(raw.name);
		const grid::BlockSet set = build(raw);
		const auto blocks = classify::GpuBlocks::create(device(), set, {});
		ASSERT_TRUE(blocks) << blocks.error().message;
		const std::vector<TestPlane> planes = planesOfOverlappingSets();
		for (std::size_t n = 0; n < planes.size(); n += 3)
		{
			if (!taken.next())
				continue;
			const probe::Sheet sheet = probe::makeSheet(planes[n].origin, planes[n].normal);
			const CutBothWays cut = cutBothWays(**blocks, std::span(&sheet, 1), {});
			expectSameCells(cut);
			expectRecords(set, std::span(&sheet, 1), {}, cut);
		}
	}
}

} // namespace vp::test
