#pragma once

#include "pixel_lists.h"

#include "classify/gpu_records.h"

namespace vp::render::test
{

// Layers composed on the device against lists of fragments at each pixel, sorted and blended by the test.
class ExactOrder : public DrawingTest
{
protected:
	// So many random probes, three cameras each.
	void compareProbes(unsigned first_seed, int probes)
	{
		const auto pool = classify::RecordPool::create(device(), 512);
		ListComparison all;
		for (int i = 0; i < probes; ++i)
		{
			std::mt19937 random(first_seed + static_cast<unsigned>(i));
			const std::vector<KnownSheet> sheets = randomProbe(random);
			Scene scene = bareScene(200, 150, 1);
			for (const KnownSheet& known : sheets)
			{
				auto records = classify::recordsFromHost(pool, known.records);
				ASSERT_TRUE(records);
				scene.sheets.push_back(known.drawing);
				scene.sheets.back().records = *records;
			}
			for (int view = 0; view < 3; ++view)
			{
				scene.camera = randomCamera(random);
				const ListComparison one = compareLists(blendedLists(scene, sheets), draw(scene));
				EXPECT_LE(one.worst, kBlendTolerance) << "probe " << first_seed + static_cast<unsigned>(i) << " with "
				                                      << sheets.size() << " sheets, camera " << view;
				all.pixels += one.pixels;
				all.several += one.several;
				all.edges += one.edges;
				all.edge_off += one.edge_off;
				all.worst = std::max(all.worst, one.worst);
			}
		}
		RecordProperty("pixels", static_cast<int>(all.pixels));
		RecordProperty("worst", std::to_string(all.worst));
		RecordProperty("edge_pixels_off", static_cast<int>(all.edge_off));
		std::cout << all.pixels << " pixels, " << all.several << " with several sheets, worst " << all.worst
		          << " of 255; " << all.edges << " on edges, " << all.edge_off << " of them off\n";
		EXPECT_LE(10'000 * all.edge_off, all.pixels);
		EXPECT_GE(5 * all.several, all.pixels);
		EXPECT_LE(20 * all.edges, all.pixels) << "too much was set apart";
	}
};

} // namespace vp::render::test
