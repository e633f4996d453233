#include "known_surface.h"

#include "base/messages.h"
#include "classify/gpu_records.h"

#include <iostream>

namespace vp::render::test
{

// Pictures that the device's memory does not hold are drawn part by part.
class Parts : public DrawingTest
{
protected:
	// Draws on a device of which only so many bytes may be used. told: what messages say meanwhile.
	Result<Picture> drawWithin(VkDeviceSize bytes, const std::function<Scene(gpu::Device&)>& scene_on,
	                           std::string* told = nullptr)
	{
		const MessageListener listener(
		    [&](Severity, std::string_view line)
		    {
			    if (told)
				    *told += line;
		    });
		gpu::DeviceOptions options;
		options.memory = bytes;
		auto device = gpu::Device::create(options);
		EXPECT_TRUE(device);
		auto renderer = Renderer::create(**device);
		EXPECT_TRUE(renderer);
		Result<Picture> picture = renderer->draw(scene_on(**device));
		EXPECT_EQ((*device)->validationMessages(), 0u);
		return picture;
	}
};

namespace
{

constexpr std::uint32_t kWidth = 320;
constexpr std::uint32_t kHeight = 240;

// Makes the same scene on any device.
Scene randomScene(gpu::Device& device, unsigned seed, int samples)
{
	std::mt19937 random(seed);
	Scene scene = bareScene(kWidth, kHeight, samples);
	scene.look.background = {{200, 100, 0}, {0, 100, 200}};
	scene.look.lines = 6;
	for (const KnownSheet& known : randomProbe(random))
	{
		auto records = classify::recordsFromHost(classify::RecordPool::create(device), known.records);
		EXPECT_TRUE(records);
		scene.sheets.push_back(known.drawing);
		scene.sheets.back().records = *records;
	}
	if (seed % 2 == 0)
		for (const double opacity : {0.4, 1.0})
		{
			scene.surfaces.push_back(onDevice(device, randomBlob(random)));
			scene.surfaces.back().opacity = opacity;
		}
	scene.camera = randomCamera(random);
	return scene;
}

} // namespace

TEST_F(Parts, OfAPictureMakeTheWhole)
{
	// Without surfaces, and with them.
	for (const auto& [seed, samples] : {std::pair{61u, 1}, std::pair{61u, 4}, std::pair{62u, 4}})
	{
		const auto scene = [&, seed = seed, samples = samples](gpu::Device& device)
		{ return randomScene(device, seed, samples); };
		const Scene sample = scene(device());
		const Picture whole = draw(sample);
		// The picture and its copy, and some 100 rows of layers, sums and depths. With surfaces a quarter is for lists
		// of fragments.
		const bool has_lists = !sample.surfaces.empty();
		const std::size_t row = kWidth * (4 * sample.sheets.size() + (has_lists ? 40 : 24));
		const std::size_t bytes = 8 * kWidth * kHeight + 100 * row;
		std::string told;
		const auto parts = drawWithin(has_lists ? bytes * 4 / 3 : bytes, scene, &told);
		ASSERT_TRUE(parts) << parts.error().message;
		EXPECT_NE(told.find("parts"), std::string::npos) << told;
		std::size_t off = 0;
		for (std::uint32_t y = 0; y < kHeight; ++y)
			for (std::uint32_t x = 0; x < kWidth; ++x)
			{
				const auto p = whole.pixel(x, y);
				off += difference({double(p[0]), double(p[1]), double(p[2])}, parts->pixel(x, y)) > 2.0;
			}
		std::cout << told << "; " << off << " pixels differ\n";
		EXPECT_LE(1000 * off, kWidth * kHeight) << "probe " << seed << ", " << samples << " samples";
	}
}

TEST_F(Parts, WhatFitsInNoPartIsAnErrorThatTellsWhatTakesTheMemory)
{
	const auto picture = drawWithin(1 << 18, [](gpu::Device& device) { return randomScene(device, 61, 1); });
	ASSERT_FALSE(picture);
	EXPECT_EQ(picture.error().kind, ErrorKind::out_of_memory);
	EXPECT_NE(picture.error().message.find("320x240"), std::string::npos);
	EXPECT_NE(picture.error().message.find("`device_memory`"), std::string::npos);
}

} // namespace vp::render::test
