#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vp::reader::volumes
{

// Pages one after the other that hold planes one after the other.
struct TiffRun
{
	std::uint64_t plane = 0;
	std::uint32_t file = 0; // which of TiffLayout::files
	std::uint64_t page = 0;
	std::optional<std::uint64_t> count{}; // none: all that the file has from there on
};

// How the pages of a TIFF file make a volume, as ImageJ, OME-TIFF and tifffile say it in the description of the first
// page. Other files have one page after the other along z. A plane is one channel and slice at one time.
struct TiffLayout
{
	std::uint32_t channels = 1;
	std::uint32_t slices = 1;
	std::uint32_t times = 1;
	std::string order = "CZT";          // which runs fastest, from plane to plane
	std::vector<std::string> files{""}; // the first is the file itself, others lie beside it
	std::vector<TiffRun> runs;
	bool counts_previews = false; // pages are numbered with those of other kinds
	std::array<double, 3> origin{0.0, 0.0, 0.0};
	std::array<double, 3> spacing{1.0, 1.0, 1.0};
	std::string length_units;
	std::vector<double> time_values; // one for each time; empty where there is one time
	std::string time_units;
	double slope = 1.0; // the values are rescaled by it
	double intercept = 0.0;
	std::string value_units;
	std::vector<std::string> notes; // for the user

	// Throws a Refusal where they are more than there can be.
	std::uint64_t planes() const;
	std::uint64_t planeOf(std::uint32_t channel, std::uint32_t slice, std::uint32_t time) const;
};

// Holds the facts that a file gives about its pages.
struct TiffFacts
{
	std::string file; // its name, without folders
	std::string description;
	std::uint64_t pages = 0;                    // like the first one
	std::uint32_t samples = 1;                  // per pixel; OME counts them as channels
	std::array<double, 2> resolution{0.0, 0.0}; // pixels in a unit of length along x and y; 0: not said
	std::string resolution_unit;
};

// Throws a Refusal where the description cannot be followed.
TiffLayout tiffLayout(const TiffFacts& facts);

// The same for OME's XML.
bool isOme(std::string_view description);
TiffLayout omeLayout(const TiffFacts& facts);

// The file beside this one that has the OME-XML; empty where the description is complete.
std::string omeMetadataFile(std::string_view description);

} // namespace vp::reader::volumes
