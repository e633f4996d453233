#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

// How the pages of a TIFF file make a volume, as ImageJ and OME-TIFF say it in the description of the first page. Other
// files have one page after the other along z.
struct TiffLayout
{
	std::uint32_t channels = 1;
	std::uint32_t slices = 1;
	std::uint32_t times = 1;
	std::string order = "CZT"; // which runs fastest, from page to page
	std::array<double, 3> spacing{1.0, 1.0, 1.0};
	std::string length_units;
	double time_step = 1.0;

	std::uint64_t pages() const { return std::uint64_t(channels) * slices * times; }
	std::uint64_t pageOf(std::uint32_t channel, std::uint32_t slice, std::uint32_t time) const;
};

// `samples`: of a pixel; OME counts them as channels. `resolution`: pixels in a unit of length along x and y, 0 where
// the file does not say it.
TiffLayout tiffLayout(std::string_view description, std::uint64_t pages, std::uint32_t samples,
                      std::array<double, 2> resolution);
