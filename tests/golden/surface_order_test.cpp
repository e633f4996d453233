#include "known_surface.h"
#include "pixel_lists.h"
#include "tries.h"

#include "classify/gpu_records.h"

namespace vp::render::test
{

namespace
{

// Crossing sheets, none in the plane of another: there the order of surfaces is nobody's promise.
std::vector<KnownSheet> crossingSheets(std::mt19937& random)
{
	std::vector<KnownSheet> sheets;
	for (KnownSheet& known : randomProbe(random))
	{
		known.drawing.window = WindowRect{-9.0, 9.0, -9.0, 9.0};
		const probe::Sheet* before = sheets.empty() ? nullptr : &sheets.back().drawing.sheet;
		if (!before || glm::length(glm::cross(before->normal, known.drawing.sheet.normal)) > 1e-6)
			sheets.push_back(std::move(known));
	}
	return sheets;
}

class SurfaceOrder : public DrawingTest
{
protected:
	void addLayer(Scene& scene, const KnownSheet& known)
	{
		auto records = classify::recordsFromHost(classify::RecordPool::create(device()), known.records);
		ASSERT_TRUE(records);
		scene.sheets.push_back(known.drawing);
		scene.sheets.back().records = *records;
	}

	// Surfaces are drawn by the device's own rasterizer.
	double reach() { return edgeReach(device().limits().subPixelPrecisionBits); }
};

} // namespace

TEST_F(SurfaceOrder, SheetsDrawnAsSurfacesLookAsTheyDoAsLayers)
{
	std::size_t pixels = 0;
	std::size_t several = 0;
	for (unsigned seed = 1; seed <= 6; ++seed)
	{
		std::mt19937 random(seed);
		const std::vector<KnownSheet> sheets = crossingSheets(random);
		Scene layers = bareScene(200, 150, 1);
		Scene surfaces = layers;
		for (const KnownSheet& known : sheets)
		{
			addLayer(layers, known);
			surfaces.surfaces.push_back(onDevice(device(), asSurface(known)));
		}
		layers.camera = surfaces.camera = randomCamera(random);
		const Picture one = draw(layers);
		const Picture other = draw(surfaces);
		const std::vector<PixelList> lists = blendedLists(layers, sheets, {}, reach());
		for (std::size_t i = 0; i < lists.size(); ++i)
		{
			const auto x = static_cast<std::uint32_t>(i % 200);
			const auto y = static_cast<std::uint32_t>(i / 200);
			const auto p = one.pixel(x, y);
			if (lists[i].on_edge)
				continue;
			ASSERT_LE(difference({double(p[0]), double(p[1]), double(p[2])}, other.pixel(x, y)), 2.0)
			    << "probe " << seed << " at " << x << " " << y;
			++pixels;
			several += lists[i].fragments > 1;
		}
	}
	EXPECT_GE(pixels, (1.0 - 5.0 * reach()) * 6 * 200 * 150);
	EXPECT_GE(5 * several, pixels);
}

TEST_F(SurfaceOrder, OfLayersAndSurfacesMixed)
{
	ListComparison all;
	for (unsigned seed = 21; seed < 21 + static_cast<unsigned>(vp::test::tries(8)); ++seed)
	{
		std::mt19937 random(seed);
		Scene scene = bareScene(200, 150, 1);
		std::vector<KnownSheet> layers;
		std::vector<KnownSurface> surfaces;
		for (const KnownSheet& known : crossingSheets(random))
			if (random() % 2 == 0)
				surfaces.push_back(asSurface(known));
			else
				layers.push_back(known);
		for (int blobs = 1 + static_cast<int>(random() % 2); blobs > 0; --blobs)
			surfaces.push_back(randomBlob(random));
		for (const KnownSheet& known : layers)
			addLayer(scene, known);
		for (const KnownSurface& known : surfaces)
			scene.surfaces.push_back(onDevice(device(), known));
		for (int view = 0; view < 2; ++view)
		{
			scene.camera = randomCamera(random);
			const ListComparison one = compareLists(blendedLists(scene, layers, surfaces, reach()), draw(scene));
			EXPECT_LE(one.worst, kBlendTolerance)
			    << "probe " << seed << ", " << layers.size() << " layers, camera " << view;
			all.pixels += one.pixels;
			all.several += one.several;
			all.edges += one.edges;
			all.edge_off += one.edge_off;
			all.worst = std::max(all.worst, one.worst);
		}
	}
	std::cout << all.pixels << " pixels, " << all.several << " with several fragments, worst " << all.worst
	          << " of 255; " << all.edges << " on edges, " << all.edge_off << " of them off\n";
	EXPECT_LE(1000 * all.edge_off, reach() / kEdgeReach * all.pixels);
	EXPECT_GE(4 * all.several, all.pixels);
	EXPECT_LE(5 * all.edges, reach() / kEdgeReach * all.pixels) << "too much was set apart";
}

TEST_F(SurfaceOrder, OfMoreFragmentsAPixelThanABatchHolds)
{
	std::mt19937 random(5);
	Scene scene = bareScene(80, 60, 1);
	std::vector<KnownSurface> surfaces;
	for (int i = 0; i < 20; ++i)
	{
		surfaces.push_back(randomBlob(random));
		surfaces.back().drawing.opacity = 0.08;
		scene.surfaces.push_back(onDevice(device(), surfaces.back()));
	}
	scene.camera = randomCamera(random);
	const std::vector<PixelList> lists = blendedLists(scene, {}, surfaces, reach());
	std::size_t most = 0;
	for (const PixelList& list : lists)
		most = std::max(most, list.fragments);
	EXPECT_GE(most, 30u);
	EXPECT_LE(compareLists(lists, draw(scene)).worst, kBlendTolerance);
}

TEST_F(SurfaceOrder, ASheetInASurfacesPlaneIsInFront)
{
	KnownSheet known;
	known.drawing.sheet = probe::makeSheet({0.1, 0.2, 0.3}, {0.3, -0.2, 0.9});
	known.drawing.opacity = 1.0;
	vp::shared::PolygonRecord record{0, 4, {-1, -1, 1, -1, 1, 1, -1, 1}, {}};
	known.records = {record};
	KnownSurface behind = asSurface(known);
	std::fill(behind.vertex_values.begin(), behind.vertex_values.end(), 1.0);
	Scene scene = bareScene(120, 90, 1);
	addLayer(scene, known);
	scene.surfaces.push_back(onDevice(device(), behind));
	const Picture picture = draw(scene);
	std::size_t seen = 0;
	for (std::uint32_t y = 0; y < 90; ++y)
		for (std::uint32_t x = 0; x < 120; ++x)
			if (hit(scene, known.drawing.sheet, 0.97, x + 0.5, y + 0.5))
			{
				++seen;
				ASSERT_LE(difference(rgb(scene.look.colors.at(0.0)), picture.pixel(x, y)), 1.0) << x << " " << y;
			}
	EXPECT_GE(seen, 300u);
}

} // namespace vp::render::test
