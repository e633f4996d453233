#include "synthetic_scene.h"

#include "classify/gpu_records.h"
#include "mesh/host_records.h"
#include "shared/slice_types.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vp::render::test
{

namespace
{

struct SharedDevice
{
	std::unique_ptr<gpu::Device> device;
	std::string why_not;

	SharedDevice()
	{
		gpu::DeviceOptions options;
		options.validation = true;
		auto made = gpu::Device::create(options);
		if (made)
			device = std::move(*made);
		else
			why_not = made.error().message;
	}
};

const SharedDevice& shared()
{
	static const SharedDevice device;
	return device;
}

} // namespace

gpu::Device* sharedDevice()
{
	return shared().device.get();
}

const std::string& whyNoDevice()
{
	return shared().why_not;
}

void DrawingTest::SetUp()
{
	if (!sharedDevice())
		GTEST_SKIP() << "no Vulkan device: " << whyNoDevice();
	messages_before_ = device().validationMessages();
	auto made = Renderer::create(device());
	ASSERT_TRUE(made) << made.error().message;
	renderer_ = std::move(*made);
}

void DrawingTest::TearDown()
{
	if (sharedDevice())
	{
		EXPECT_EQ(device().validationMessages(), messages_before_);
	}
}

Picture DrawingTest::draw(const Scene& scene)
{
	auto drawn = renderer().draw(scene);
	EXPECT_TRUE(drawn) << drawn.error().message;
	return drawn ? std::move(*drawn) : Picture{};
}

SheetDrawing DrawingTest::square(const probe::Sheet& sheet, double half, double opacity,
                                 const std::function<double(double, double)>& f, int n)
{
	std::vector<vp::shared::PolygonRecord> records;
	for (int j = 0; j < n; ++j)
		for (int i = 0; i < n; ++i)
		{
			vp::shared::PolygonRecord record{};
			record.vertices = 4;
			for (int k = 0; k < 4; ++k)
			{
				const double u = half * (2.0 * (i + (k == 1 || k == 2)) / n - 1.0);
				const double v = half * (2.0 * (j + (k >= 2)) / n - 1.0);
				const double value = f(u, v);
				record.uv[2 * k] = static_cast<float>(u);
				record.uv[2 * k + 1] = static_cast<float>(v);
				record.value[k] = mesh::drawnValue(value);
			}
			records.push_back(record);
			records.push_back({}); // a cell that emitted nothing
		}
	auto on_device = classify::recordsFromHost(classify::RecordPool::create(device()), records);
	EXPECT_TRUE(on_device);
	return {sheet, *on_device, opacity};
}

Scene bareScene(std::uint32_t width, std::uint32_t height, int samples)
{
	Scene scene;
	scene.look.width = width;
	scene.look.height = height;
	scene.look.samples = samples;
	scene.look.background = parseBackground("white").value();
	scene.look.legend = false;
	scene.look.axes = false;
	scene.values = ValueScale{"f", 0.0, 1.0, false};
	scene.camera.position = {0.0, 0.0, 5.0};
	scene.camera.vertical_field = 40.0;
	scene.camera.near = 1.0;
	return scene;
}

std::optional<Hit> hit(const Scene& scene, const probe::Sheet& sheet, double half, double x, double y)
{
	const Camera& camera = scene.camera;
	const double tangent = std::tan(0.5 * camera.vertical_field * std::numbers::pi / 180.0);
	const double aspect = static_cast<double>(scene.look.width) / scene.look.height;
	const Vec3 ray = camera.forward() + tangent * aspect * (2.0 * x / scene.look.width - 1.0) * camera.right() +
	                 tangent * (1.0 - 2.0 * y / scene.look.height) * camera.trueUp();
	const double distance = glm::dot(sheet.normal, sheet.origin - camera.position) / glm::dot(sheet.normal, ray);
	const Vec3 at = camera.position + distance * ray - sheet.origin;
	const Hit found{distance, glm::dot(at, sheet.xAxis()), glm::dot(at, sheet.up)};
	if (!(distance > 0.0) || std::max(std::abs(found.u), std::abs(found.v)) > half)
		return std::nullopt;
	return found;
}

Rgb rgb(Color color)
{
	return {double(color.r), double(color.g), double(color.b)};
}

Rgb over(const Rgb& front, double opacity, const Rgb& back)
{
	Rgb mixed;
	for (int c = 0; c < 3; ++c)
		mixed[c] = opacity * front[c] + (1.0 - opacity) * back[c];
	return mixed;
}

double difference(const Rgb& expected, const std::array<std::uint8_t, 4>& pixel)
{
	double most = 0.0;
	for (int c = 0; c < 3; ++c)
		most = std::max(most, std::abs(expected[c] - pixel[c]));
	return most;
}

} // namespace vp::render::test
