#include "synthetic_scene.h"

#include "classify/gpu_records.h"
#include "shared/slice_types.h"

#include <cmath>

namespace vp::render::test
{

namespace
{

constexpr Frame kFrame{240.0, 180.0, {}, {}, {}};

} // namespace

class MeshLines : public DrawingTest
{
protected:
	MeshLines() : scene_(bareScene(240, 180, 4)) { scene_.look.colors = makeColorMap("grey").value(); }

	// How much darker the lines make a point of the sheet, of 765.
	int ink(double u, double v)
	{
		const glm::dvec2 p = scene_.camera.project({u, v, 0.0}, kFrame);
		const auto x = static_cast<std::uint32_t>(p.x);
		const auto y = static_cast<std::uint32_t>(p.y);
		const auto sum = [](const std::array<std::uint8_t, 4>& c) { return c[0] + c[1] + c[2]; };
		return sum(plain_.pixel(x, y)) - sum(lines_.pixel(x, y));
	}
	// Along row v, over the whole picture.
	double inkOfRow(double v)
	{
		const glm::dvec2 p = scene_.camera.project({0.0, v, 0.0}, kFrame);
		double all = 0.0;
		for (std::uint32_t x = 0; x < 240; ++x)
		{
			const auto y = static_cast<std::uint32_t>(p.y);
			all += plain_.pixel(x, y)[0] - lines_.pixel(x, y)[0];
		}
		return all;
	}
	void drawBoth()
	{
		scene_.look.mesh = false;
		plain_ = draw(scene_);
		scene_.look.mesh = true;
		lines_ = draw(scene_);
	}

	Scene scene_;
	Picture plain_;
	Picture lines_;
};

TEST_F(MeshLines, LieAlongThePolygonsEdges)
{
	scene_.sheets = {square(kFacing, 1.2, 1.0, half, 4)}; // edges at multiples of 0.6
	drawBoth();
	for (const double edge : {-0.6, 0.0, 0.6})
		for (const double off : {-1.0, -0.4, 0.25, 0.8})
		{
			EXPECT_GE(ink(edge, off), 60) << edge << " " << off;
			EXPECT_GE(ink(off, edge), 60) << edge << " " << off;
		}
	for (const double u : {-0.9, -0.3, 0.3, 0.9})
		for (const double v : {-0.9, -0.3, 0.3, 0.9})
			EXPECT_EQ(ink(u, v), 0) << u << " " << v;
	// Off the sheet there is nothing.
	EXPECT_EQ(ink(1.4, 0.3), 0);
}

TEST_F(MeshLines, AreAsWideAtAnyZoom)
{
	scene_.sheets = {square(kFacing, 8.0, 1.0, half, 16)}; // edges 1 apart
	const auto inkOfALine = [&](double distance)
	{
		scene_.camera.position.z = distance;
		drawBoth();
		const double seen = 2.0 * distance * std::tan(20.0 * std::acos(-1.0) / 180.0) * 240.0 / 180.0;
		return inkOfRow(0.5) / (1.0 + 2.0 * std::floor(0.5 * seen)); // ink per visible line
	};
	const double near = inkOfALine(2.0);
	EXPECT_GT(near, 20.0);
	for (const double distance : {3.0, 5.0, 9.0})
		EXPECT_NEAR(inkOfALine(distance), near, 0.25 * near) << distance;
	// Seen at an angle too: the row through the middle is across the edges all the same.
	scene_.camera.position = {0.0, 3.0, 4.0};
	drawBoth();
	const double tilted = 2.0 * 5.0 * std::tan(20.0 * std::acos(-1.0) / 180.0) * 240.0 / 180.0;
	EXPECT_NEAR(inkOfRow(0.05) / (1.0 + 2.0 * std::floor(0.5 * tilted)), near, 0.3 * near);
}

TEST_F(MeshLines, FadeWherePolygonsAreAsSmallAsPixels)
{
	scene_.sheets = {square(kFacing, 1.2, 1.0, half, 120)}; // about a pixel each
	drawBoth();
	double most = 0.0;
	for (double u = -1.0; u < 1.0; u += 0.05)
		most = std::max<double>(most, ink(u, 0.3));
	EXPECT_LE(most, 40.0);
	EXPECT_GT(most, 0.0);
}

TEST_F(MeshLines, DiagonalsThatPartALargePolygonAreNoEdges)
{
	// An octagon as two records of one cell, as the cutter makes them; then as those of two cells.
	for (const bool one_cell : {true, false})
	{
		std::vector<glm::dvec2> corners;
		for (int i = 0; i < 8; ++i)
			corners.push_back(1.2 * glm::dvec2(std::cos(0.7853981634 * i), std::sin(0.7853981634 * i)));
		// hidden: the edge that is the diagonal, if the records are of one cell.
		const auto record = [&](std::uint32_t cell, std::vector<int> which, int hidden)
		{
			vp::shared::PolygonRecord made{};
			made.cell = cell;
			made.vertices = static_cast<std::uint32_t>(which.size());
			if (one_cell)
				made.vertices |= vp::shared::kHiddenRecordEdge << hidden;
			for (std::size_t k = 0; k < which.size(); ++k)
			{
				made.uv[2 * k] = static_cast<float>(corners[which[k]].x);
				made.uv[2 * k + 1] = static_cast<float>(corners[which[k]].y);
				made.value[k] = 0.5f;
			}
			return made;
		};
		const std::vector<vp::shared::PolygonRecord> records{record(7, {0, 1, 2, 3, 4, 5}, 5),
		                                                     record(one_cell ? 7 : 8, {0, 5, 6, 7}, 0)};
		auto on_device = classify::recordsFromHost(classify::RecordPool::create(device()), records);
		ASSERT_TRUE(on_device);
		scene_.sheets = {{kFacing, *on_device, 1.0}};
		drawBoth();
		const glm::dvec2 on_diagonal = 0.5 * (corners[0] + corners[5]);
		const glm::dvec2 on_edge = 0.5 * (corners[5] + corners[6]);
		const int seen = ink(on_diagonal.x, on_diagonal.y);
		EXPECT_TRUE(one_cell ? seen == 0 : seen >= 60) << seen;
		EXPECT_GE(ink(0.995 * on_edge.x, 0.995 * on_edge.y), 20);
	}
}

} // namespace vp::render::test
