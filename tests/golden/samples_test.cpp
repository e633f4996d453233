#include "known_surface.h"

#include "classify/gpu_records.h"

#include <algorithm>
#include <iostream>

namespace vp::render::test
{

namespace
{

constexpr std::uint32_t kSmallWidth = 160;
constexpr std::uint32_t kSmallHeight = 120;
constexpr std::uint32_t kSide = 4; // side of a pixel, in pixels of the larger picture

// The mean of kSide x kSide pixels.
Rgb meanOver(const Picture& picture, std::uint32_t x, std::uint32_t y)
{
	Rgb sum{};
	for (std::uint32_t j = 0; j < kSide; ++j)
		for (std::uint32_t i = 0; i < kSide; ++i)
		{
			const auto pixel = picture.pixel(kSide * x + i, kSide * y + j);
			for (int c = 0; c < 3; ++c)
				sum[c] += pixel[c];
		}
	for (double& channel : sum)
		channel /= kSide * kSide;
	return sum;
}

class Samples : public DrawingTest
{
protected:
	Scene randomScene(std::mt19937& random)
	{
		Scene scene = bareScene(kSmallWidth, kSmallHeight, int(kSide * kSide));
		for (const KnownSheet& known : randomProbe(random))
		{
			auto records = classify::recordsFromHost(classify::RecordPool::create(device()), known.records);
			EXPECT_TRUE(records);
			scene.sheets.push_back(known.drawing);
			scene.sheets.back().records = *records;
			scene.sheets.back().rim = false;
		}
		scene.surfaces.push_back(onDevice(device(), randomBlob(random)));
		scene.surfaces.push_back(onDevice(device(), randomBlob(random)));
		scene.surfaces[1].opacity = 1.0;
		scene.camera = randomCamera(random);
		return scene;
	}
};

} // namespace

// Later samples are drawn at edges only. The picture is that of all samples, which a larger picture has.
TEST_F(Samples, OfAPictureAreThePixelsOfALargerOne)
{
	std::size_t off = 0;
	std::size_t pixels = 0;
	double sum = 0.0;
	for (unsigned seed = 41; seed <= 46; ++seed)
	{
		std::mt19937 random(seed);
		Scene scene = randomScene(random);
		scene.sheets.resize(seed % 3 == 0 ? 0 : scene.sheets.size());
		scene.surfaces.resize(seed % 2 == 0 ? 2 : 0);
		const Picture picture = draw(scene);
		scene.look.samples = 1;
		scene.look.width *= kSide;
		scene.look.height *= kSide;
		const Picture larger = draw(scene);
		for (std::uint32_t y = 0; y < kSmallHeight; ++y)
			for (std::uint32_t x = 0; x < kSmallWidth; ++x, ++pixels)
			{
				const double here = difference(meanOver(larger, x, y), picture.pixel(x, y));
				sum += here;
				off += here > 40.0; // two of sixteen samples, and a bit more
			}
	}
	std::cout << off << " of " << pixels << " pixels are off; mean difference " << sum / double(pixels) << " of 255\n";
	EXPECT_LE(1000 * off, 2 * pixels);
	EXPECT_LE(sum, double(pixels));
}

// A picture does not depend on what was drawn before it, although a layer's later samples are drawn in part.
TEST_F(Samples, LeaveNothingBehind)
{
	std::mt19937 random(51);
	const Scene one = randomScene(random);
	const Scene other = randomScene(random);
	const Picture first = draw(one);
	draw(other);
	EXPECT_TRUE(draw(one).rgba == first.rgba);
}

} // namespace vp::render::test
