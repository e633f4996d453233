#include "render/flat/flat_layout.h"

#include <gtest/gtest.h>

namespace vp::render
{

// The legend shares the right side with the small view of the grid.
TEST(FlatLayout, SmallPicturesHaveALegendThatFitsOrNone)
{
	const mesh::SheetMesh empty;
	const FontAtlas lettering({9.0, 12.0, 40.0}, {"s"});
	std::size_t some = 0;
	std::size_t none = 0;
	for (std::uint32_t width = 48; width <= 320; width += 34)
		for (std::uint32_t height = 24; height <= 240; height += 8)
			for (const double hi : {1.0, 98765.4e3})
			{
				SCOPED_TRACE(testing::Message() << width << "x" << height << " up to " << hi);
				FlatScene flat;
				flat.scene.values = ValueScale{"s", 0.0, hi};
				flat.scene.bounds = Box{{-3.0, 0.0, -2.0}, {3.0, 3.0, 2.0}};
				flat.scene.sheets.resize(1);
				flat.scene.look.width = width;
				flat.scene.look.height = height;
				flat.content = probe::makeSheet({0.0, 1.5, 0.0}, {0.0, 0.0, 1.0});
				flat.mesh = &empty;
				const std::vector<LegendContent> contents = legendContents(flat.scene);
				Look bare = flat.scene.look;
				bare.axes = false;
				const FlatLayout layout = makeFlatLayout(flat, contents, makeLayout(bare, {}), lettering);
				(layout.text.legends.empty() ? none : some) += 1;
				EXPECT_TRUE(layout.small.size() == glm::dvec2(0.0) || layout.small.size().x > 4.0 * layout.text.em);
				for (const LegendLayout& legend : layout.text.legends)
				{
					EXPECT_GE(legend.bar.size().y, 3.0 * layout.text.em);
					EXPECT_GE(legend.title.size().y, 1.2 * layout.text.em);
					EXPECT_LE(legend.title.hi.y, legend.bar.lo.y);
					EXPECT_GE(legend.column.lo.x, 0.0);
					EXPECT_LE(legend.column.hi.x, width);
					EXPECT_LE(legend.column.hi.y, height);
					EXPECT_FALSE(legend.column.overlaps(layout.small));
					EXPECT_FALSE(legend.column.overlaps(layout.plot));
				}
			}
	EXPECT_GT(some, 100u);
	EXPECT_GT(none, 20u);
}

} // namespace vp::render
