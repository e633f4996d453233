#include "own_samples.h"
#include "sample_bytes.h"

#include <fmt/format.h>

namespace
{

using vp::Vec3;

// Columns run along y, rows along z, sections along x.
void writeTurnedMrc(const std::string& path)
{
	std::string bytes;
	const auto words = [&](std::initializer_list<int> numbers)
	{
		for (const int number : numbers)
			addBigEndian(bytes, number);
	};
	const auto reals = [&](std::initializer_list<float> numbers)
	{
		for (const float number : numbers)
			addBigEndian(bytes, number);
	};
	words({5, 4, 6, 2, 0, 0, 0, 6, 5, 4});
	reals({3.0f, 1.25f, 8.0f, 90.0f, 90.0f, 90.0f});
	words({2, 3, 1});
	reals({0.0f, 0.0f, 0.0f});
	words({1, 80}); // an extended header of 80 bytes
	bytes.append(100, '\0');
	reals({2.0f, -2.0f, -1.5f});
	bytes += "MAP \x11\x11";
	bytes.resize(1024 + 80, '\0');
	for (int section = 0; section < 6; ++section)
		for (int row = 0; row < 4; ++row)
			for (int column = 0; column < 5; ++column)
				addBigEndian(bytes, static_cast<float>(sampleValue(
				                        Vec3(2.0 + 0.5 * section, -2.0 + 0.25 * column, -1.5 + 2.0 * row))));
	writeContents(path, bytes);
}

// As ImageJ writes stacks, with two times: pages of one strip each.
void writeImageJ(const std::string& path)
{
	const std::string description = std::string("ImageJ=1.53t\nimages=12\nslices=6\nframes=2\nhyperstack=true\n"
	                                            "unit=micron\nfinterval=0.5\nspacing=2.0\nloop=false\n") +
	                                '\0';
	std::string bytes = "II*";
	bytes += '\0';
	addBytes<std::uint32_t>(bytes, 8 + 16);
	for (const std::uint32_t number : {4u, 1u, 4u, 1u}) // four pixels in a micron
		addBytes(bytes, number);
	for (std::uint32_t page = 0; page < 12; ++page)
	{
		const auto at = static_cast<std::uint32_t>(bytes.size());
		constexpr std::uint32_t kTags = 13;
		const std::uint32_t text = at + 2 + 12 * kTags + 4;
		const std::uint32_t values = text + static_cast<std::uint32_t>(description.size());
		const std::uint32_t size = 5 * 4 * sizeof(float);
		const auto entry = [&](std::uint16_t tag, std::uint16_t type, std::uint32_t count, std::uint32_t value)
		{
			addBytes(bytes, tag);
			addBytes(bytes, type);
			addBytes(bytes, count);
			addBytes(bytes, value);
		};
		addBytes<std::uint16_t>(bytes, kTags);
		entry(256, 4, 1, 5);
		entry(257, 4, 1, 4);
		entry(258, 3, 1, 32);
		entry(259, 3, 1, 1);
		entry(262, 3, 1, 1);
		entry(270, 2, static_cast<std::uint32_t>(description.size()), text);
		entry(273, 4, 1, values);
		entry(277, 3, 1, 1);
		entry(278, 4, 1, 4);
		entry(279, 4, 1, size);
		entry(282, 5, 1, 8);
		entry(283, 5, 1, 16);
		entry(339, 3, 1, 3);
		addBytes<std::uint32_t>(bytes, page == 11 ? 0 : values + size);
		bytes += description;
		for (int row = 0; row < 4; ++row)
			for (int column = 0; column < 5; ++column)
				addBytes(bytes,
				         page < 6 ? 0.0f
				                  : static_cast<float>(sampleValue(Vec3(0.25 * column, 0.25 * row, 2.0 * (page - 6)))));
	}
	writeContents(path, bytes);
}

// An element with an explicit type, filled up to an even length.
void addElement(std::string& bytes, std::uint16_t group, std::uint16_t element, const std::string& type,
                std::string value)
{
	if (value.size() % 2 != 0)
		value += type == "UI" ? '\0' : ' ';
	addBytes(bytes, group);
	addBytes(bytes, element);
	bytes += type;
	if (type == "OW")
	{
		addBytes<std::uint16_t>(bytes, 0);
		addBytes(bytes, static_cast<std::uint32_t>(value.size()));
	}
	else
		addBytes(bytes, static_cast<std::uint16_t>(value.size()));
	bytes += value;
}

std::string shortNumber(std::uint16_t number)
{
	std::string bytes;
	addBytes(bytes, number);
	return bytes;
}

// A series of a file for each slice.
void writeDicom(const std::string& path)
{
	const std::string ct = "1.2.840.10008.5.1.4.1.1.2";
	for (int k = 0; k < kSamplePoints[2]; ++k)
	{
		const std::string instance = fmt::format("1.2.3.4.{}", k + 1);
		std::string meta;
		addElement(meta, 2, 2, "UI", ct);
		addElement(meta, 2, 3, "UI", instance);
		addElement(meta, 2, 0x10, "UI", "1.2.840.10008.1.2.1");
		std::string bytes(128, '\0');
		bytes += "DICM";
		std::string length;
		addBytes(length, static_cast<std::uint32_t>(meta.size()));
		addElement(bytes, 2, 0, "UL", length);
		bytes += meta;
		std::string pixels;
		for (int j = 0; j < kSamplePoints[1]; ++j)
			for (int i = 0; i < kSamplePoints[0]; ++i)
				addBytes(pixels, static_cast<std::uint16_t>(sampleValue(Vec3(i, j, k))));
		addElement(bytes, 8, 0x16, "UI", ct);
		addElement(bytes, 8, 0x18, "UI", instance);
		addElement(bytes, 8, 0x60, "CS", "CT");
		addElement(bytes, 0x20, 0xd, "UI", "1.2.3.5");
		addElement(bytes, 0x20, 0xe, "UI", "1.2.3.6");
		addElement(bytes, 0x20, 0x13, "IS", fmt::format("{}", k + 1));
		addElement(bytes, 0x20, 0x32, "DS", fmt::format("0\\0\\{}", k));
		addElement(bytes, 0x20, 0x37, "DS", "1\\0\\0\\0\\1\\0");
		addElement(bytes, 0x28, 2, "US", shortNumber(1));
		addElement(bytes, 0x28, 4, "CS", "MONOCHROME2");
		addElement(bytes, 0x28, 0x10, "US", shortNumber(4));
		addElement(bytes, 0x28, 0x11, "US", shortNumber(5));
		addElement(bytes, 0x28, 0x30, "DS", "1\\1");
		addElement(bytes, 0x28, 0x100, "US", shortNumber(16));
		addElement(bytes, 0x28, 0x101, "US", shortNumber(16));
		addElement(bytes, 0x28, 0x102, "US", shortNumber(15));
		addElement(bytes, 0x28, 0x103, "US", shortNumber(0));
		addElement(bytes, 0x7fe0, 0x10, "OW", pixels);
		writeContents((std::filesystem::path(path).parent_path() / fmt::format("slice_{}.dcm", k)).string(), bytes);
	}
}

} // namespace

std::vector<SampleFile> scanSamples()
{
	return {
	    {"turned.mrc", writeTurnedMrc, "curvilinear", kSampleCellCount, kSamplePointCount, false, ""},
	    {"slice_0.dcm", writeDicom, "image", kSampleCellCount, kSamplePointCount, false, "slice_3.dcm"},
	    {"stack.tif", writeImageJ, "image", kSampleCellCount, kSamplePointCount, false, ""},
	};
}
