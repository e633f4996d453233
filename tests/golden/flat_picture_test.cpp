#include "baseline.h"

#include "cut/cutter.h"
#include "grid/demo/demo.h"
#include "write/plane_picture.h"

#include <gtest/gtest.h>

#include <cairo.h>
#include <unistd.h>
#include <zlib.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string_view>

namespace vp::render::test
{

namespace
{

// The blob's middle, with values of ours.
class Flat : public testing::Test
{
protected:
	Flat()
	    : blocks_(grid::makeDemo("blob", 24).value()),
	      folder_(std::filesystem::temp_directory_path() / ("vprobe_flat_" + std::to_string(getpid())))
	{
		std::filesystem::create_directories(folder_);
	}
	~Flat() override { std::filesystem::remove_all(folder_); }

	FlatScene sceneOf(const std::function<double(const Vec3&)>& value, const probe::Sheet& sheet)
	{
		cut::Cutter cutter(blocks_);
		cut::CutRequest request;
		request.in_generations = true;
		request.probe.sheets = {sheet};
		mesh_ = cutter.cut(std::move(request)).value().mesh(blocks_, 0);
		FlatScene flat;
		flat.content = sheet;
		flat.mesh = &mesh_;
		double lo = std::numeric_limits<double>::infinity();
		double hi = -lo;
		for (const Vec3& p : mesh_.positions)
		{
			flat.values.of_vertices.push_back(value(p));
			if (std::isfinite(value(p)))
				lo = std::min(lo, value(p)), hi = std::max(hi, value(p));
		}
		flat.scene.values = ValueScale{"f", lo, hi};
		flat.scene.sheets.push_back({sheet, nullptr});
		flat.scene.bounds = blocks_.bounds();
		flat.scene.look.background = parseBackground("white").value();
		flat.scene.look.width = 800;
		flat.scene.look.height = 500;
		flat.scene.look.title = "a field";
		return flat;
	}

	Picture drawn(const FlatScene& flat) { return readPng(written(flat, "flat.png")); }

	std::string written(const FlatScene& flat, const char* name)
	{
		const std::string path = (folder_ / name).string();
		const Status done = write::writePlanePictures(std::span(&flat, 1), std::span(&path, 1));
		EXPECT_TRUE(done) << (done ? "" : done.error().message);
		return path;
	}

	std::string text(const std::string& path)
	{
		std::ifstream file(path, std::ios::binary);
		return {std::istreambuf_iterator<char>(file), {}};
	}

	std::size_t files() const
	{
		return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder_), {}));
	}

	grid::BlockSet blocks_;
	mesh::SheetMesh mesh_;
	std::filesystem::path folder_;
};

int distance(const Picture& picture, std::uint32_t x, std::uint32_t y, const Color& color)
{
	const auto pixel = picture.pixel(x, y);
	return std::max({std::abs(pixel[0] - color.r), std::abs(pixel[1] - color.g), std::abs(pixel[2] - color.b)});
}

// Returns the contents of a PDF's streams, one after the other. cairo 1.18 and later compress the page's description
// too.
std::string unpacked(const std::string& pdf)
{
	const std::string_view head = "\nstream\n";
	std::string result;
	for (std::size_t at = pdf.find(head); at != std::string::npos; at = pdf.find(head, at + 1))
	{
		const std::size_t begin = at + head.size();
		std::vector<Bytef> out(1'000'000);
		z_stream stream{};
		stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(pdf.data() + begin));
		stream.avail_in = static_cast<uInt>(pdf.size() - begin);
		stream.next_out = out.data();
		stream.avail_out = static_cast<uInt>(out.size());
		if (inflateInit(&stream) != Z_OK)
			return {};
		inflate(&stream, Z_FINISH); // a stream that is no compressed text gives nothing
		result.append(reinterpret_cast<const char*>(out.data()), stream.total_out);
		inflateEnd(&stream);
	}
	return result;
}

// The outermost pixels.
struct Box4
{
	std::uint32_t x0, y0, x1, y1;
};

// Returns the box of a window that the slice fills. It ends at white pixels, seen from the middle.
Box4 filledBox(const Picture& picture, std::uint32_t x, std::uint32_t y)
{
	const auto white = [&](std::uint32_t a, std::uint32_t b) { return distance(picture, a, b, {255, 255, 255}) < 8; };
	Box4 box{x, y, x, y};
	while (!white(box.x0 - 1, y))
		--box.x0;
	while (!white(box.x1 + 1, y))
		++box.x1;
	while (!white(x, box.y0 - 1))
		--box.y0;
	while (!white(x, box.y1 + 1))
		++box.y1;
	return box;
}

probe::Sheet windowed(double width, double height)
{
	probe::Sheet sheet = probe::makeSheet({0.0, 0.0, 0.1}, {0.0, 0.0, 1.0});
	sheet.window = probe::centeredWindow(width, height);
	return sheet;
}

} // namespace

TEST_F(Flat, ColorsOfAKnownFieldTrueToScale)
{
	const FlatScene flat = sceneOf([](const Vec3& p) { return p.x; }, windowed(4.0, 2.0));
	const Picture picture = drawn(flat);
	ASSERT_EQ(picture.width, 800u);
	ASSERT_EQ(picture.height, 500u);
	const Box4 box = filledBox(picture, 350, 240);
	const double width = box.x1 - box.x0 + 1.0;
	const double height = box.y1 - box.y0 + 1.0;
	EXPECT_NEAR(width / height, 2.0, 0.02);
	EXPECT_GT(width, 400.0);
	const ColorMap map = makeColorMap("viridis").value();
	for (double part = 0.02; part < 1.0; part += 0.03)
		for (const double up : {0.1, 0.5, 0.9})
		{
			const auto x = static_cast<std::uint32_t>(box.x0 + part * width);
			const auto y = static_cast<std::uint32_t>(box.y0 + up * height);
			EXPECT_LE(distance(picture, x, y, map.at((x + 0.5 - box.x0) / width)), 3) << x << " " << y;
		}
}

TEST_F(Flat, InfinityIsBeyondTheRange)
{
	constexpr double kInfinity = std::numeric_limits<double>::infinity();
	// Points lie at multiples of 0.25.
	FlatScene flat = sceneOf([](const Vec3& p) { return p.x < -0.9  ? -kInfinity
		                                                : p.x > 0.9 ? kInfinity
		                                                            : p.x; },
	                         windowed(4.0, 2.0));
	flat.scene.values->below = flat.scene.values->above = true;
	flat.scene.look.marks_out_of_range = true;
	flat.scene.look.lines = 3;
	flat.scene.look.labels = false;
	const Picture picture = drawn(flat);
	const Box4 box = filledBox(picture, 350, 240);
	const ColorMap map = makeColorMap("viridis").value();
	const auto shows = [&](double at, const Color& color)
	{
		const auto x = static_cast<std::uint32_t>(box.x0 + (at + 2.0) / 4.0 * (box.x1 - box.x0 + 1.0));
		for (const double up : {0.03, 0.3, 0.97})
			EXPECT_LE(distance(picture, x, static_cast<std::uint32_t>(box.y0 + up * (box.y1 - box.y0)), color), 5)
			    << at;
	};
	for (const double at : {1.05, 1.5, 1.95})
	{
		shows(at, map.above);
		shows(-at, map.below);
	}
	shows(0.87, map.nan);
	shows(-0.87, map.nan);
	shows(0.25, map.at(1.0 / 1.5 * (0.25 + 0.75)));
}

TEST_F(Flat, ContourLinesRunThroughTheirPlaces)
{
	FlatScene flat = sceneOf([](const Vec3& p) { return p.x; }, windowed(4.0, 2.0));
	flat.scene.look.lines = 3; // -1, 0, 1
	flat.scene.look.labels = false;
	const Picture with = drawn(flat);
	flat.scene.look.lines = 0;
	const Picture without = drawn(flat);
	const Box4 box = filledBox(without, 350, 240);
	const double width = box.x1 - box.x0 + 1.0;
	const std::uint32_t y = box.y0 + (box.y1 - box.y0) / 3;
	for (int line = 1; line <= 3; ++line)
	{
		const auto x = static_cast<std::uint32_t>(box.x0 + 0.25 * line * width);
		int darkest = 0;
		for (std::uint32_t i = x - 1; i <= x + 1; ++i)
			darkest = std::max(darkest, std::abs(with.pixel(i, y)[1] - without.pixel(i, y)[1]));
		EXPECT_GT(darkest, 40) << line;
		EXPECT_EQ(with.pixel(x + 12, y), without.pixel(x + 12, y));
	}
	// A label takes a part of a line, where there is room for it.
	flat.scene.look.lines = 3;
	flat.scene.look.labels = true;
	EXPECT_NE(drawn(flat).rgba, with.rgba);
}

TEST_F(Flat, NanAndWhatIsBeyondTheRangeHaveTheirColors)
{
	FlatScene flat = sceneOf([](const Vec3& p) { return p.y > 0.45 ? std::nan("") : p.x; }, windowed(4.0, 2.0));
	flat.scene.look.range = {-1.0, 1.0};
	flat.scene.values->has_nan = true;
	const Picture plain = drawn(flat);
	flat.scene.look.marks_out_of_range = true;
	const Picture picture = drawn(flat);
	const Box4 box = filledBox(picture, 350, 300);
	const ColorMap map = makeColorMap("viridis").value();
	EXPECT_LE(distance(picture, box.x0 + 20, box.y1 - 20, map.below), 2);
	EXPECT_LE(distance(picture, box.x1 - 20, box.y1 - 20, map.above), 2);
	EXPECT_LE(distance(picture, box.x1 - 20, box.y0 + 10, map.nan), 2);
	EXPECT_LE(distance(plain, box.x0 + 20, box.y1 - 20, map.at(0.0)), 2);
	EXPECT_LE(distance(plain, box.x1 - 20, box.y1 - 20, map.at(1.0)), 2);
	EXPECT_LE(distance(plain, box.x1 - 20, box.y0 + 10, map.nan), 2);
}

TEST_F(Flat, LooksAsItDid)
{
	FlatScene flat = sceneOf([](const Vec3& p) { return std::sin(2.0 * p.x) * std::cos(1.5 * p.y) + 0.2 * p.z; },
	                         probe::makeSheet({0.2, 0.1, 0.3}, {0.3, -0.5, 0.8}));
	flat.scene.look.lines = 7;
	flat.scene.look.caption = "a caption";
	flat.scene.look.length_units = "mm";
	const Picture picture = drawn(flat);
	// The cairo of the baseline puts letters on whole pixels, 1.18 and later on quarters of them. Then only parts
	// without letters count: some of the slice, the colors of the legend, and the sheet in its box.
	const std::vector<PictureBox> parts{{360, 195, 420, 320}, {634, 73, 647, 281}, {660, 345, 755, 440}};
	for (const PictureBox& part : parts)
		EXPECT_TRUE(looksLike(picture, "flat", part));
	if (cairo_version() < CAIRO_VERSION_ENCODE(1, 18, 0))
	{
		EXPECT_TRUE(looksLike(picture, "flat"));
	}
}

TEST_F(Flat, PolygonsOfVectorFilesKeepTheirPlaces)
{
	FlatScene flat = sceneOf([](const Vec3& p) { return p.x; }, windowed(4.0, 2.0));
	flat.color_steps = write::colorSteps(write::PictureFormat::svg);
	flat.scene.look.lines = 3;
	const std::string svg = text(written(flat, "flat.svg"));
	EXPECT_EQ(svg.rfind("<?xml", 0), 0u);
	EXPECT_NE(svg.find("width=\"800px\" height=\"500px\""), std::string::npos) << svg.substr(0, 300);
	EXPECT_NE(svg.find("</svg>"), std::string::npos);
	EXPECT_EQ(svg.find("<image"), std::string::npos); // polygons, no pixels
	EXPECT_LT(svg.size(), 200'000u);
	const std::string pdf = text(written(flat, "flat.pdf"));
	EXPECT_EQ(pdf.rfind("%PDF-", 0), 0u);
	EXPECT_NE((pdf + unpacked(pdf)).find("[ 0 0 600 375 ]"), std::string::npos); // points of a page
	EXPECT_NE(pdf.find("%%EOF"), std::string::npos);
	EXPECT_LT(pdf.size(), 100'000u);
}

TEST_F(Flat, AnEmptySliceHasAPictureToo)
{
	FlatScene flat = sceneOf([](const Vec3& p) { return p.x; }, probe::makeSheet({0.0, 0.0, 50.0}, {0.0, 0.0, 1.0}));
	ASSERT_EQ(mesh_.polygons(), 0u);
	flat.scene.values = ValueScale{"f", 0.0, 1.0};
	flat.scene.look.lines = 5;
	EXPECT_EQ(drawn(flat).width, 800u);
}

TEST_F(Flat, TheSmallestAndOddSizesDoNoHarm)
{
	FlatScene flat = sceneOf([](const Vec3& p) { return p.x; }, windowed(4.0, 0.001));
	flat.scene.look.lines = 5;
	for (const auto& [width, height] : {std::pair{1u, 1u}, {40u, 700u}, {900u, 30u}, {200u, 200u}})
	{
		flat.scene.look.width = width;
		flat.scene.look.height = height;
		const Picture picture = drawn(flat);
		EXPECT_EQ(picture.width, width);
		EXPECT_EQ(picture.height, height);
	}
}

TEST_F(Flat, NamesInAnyEncodingCanBeWritten)
{
	FlatScene flat = sceneOf([](const Vec3& p) { return p.x; }, windowed(4.0, 2.0));
	flat.scene.look.title = "caf\xe9 \xed\xa0\x80 \xc3";
	flat.scene.look.length_units = "\xb5m";
	flat.scene.values->title = "temp\xff\xfe";
	EXPECT_EQ(drawn(flat).width, 800u);
	EXPECT_NE(text(written(flat, "flat.svg")).find("</svg>"), std::string::npos);
	EXPECT_NE(text(written(flat, "flat.pdf")).find("%%EOF"), std::string::npos);
}

TEST_F(Flat, AllPicturesOrNone)
{
	const FlatScene flat = sceneOf([](const Vec3& p) { return p.x; }, windowed(4.0, 2.0));
	const std::vector<FlatScene> flats{flat, flat};
	const std::vector<std::string> paths{(folder_ / "a.png").string(), (folder_ / "none/b.png").string()};
	std::ofstream(folder_ / "none") << "a file where the folder would be";
	const Status written = write::writePlanePictures(flats, paths);
	ASSERT_FALSE(written);
	EXPECT_EQ(written.error().kind, ErrorKind::output);
	EXPECT_NE(written.error().message.find("none/b.png"), std::string::npos);
	EXPECT_EQ(files(), 1u);
}

} // namespace vp::render::test
