#pragma once

#include "tiff_layout.h"
#include "tiff_pages.h"
#include "vprobe-read/arrays/stored_place.h"
#include "vprobe-read/arrays/value_image.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vp::reader::volumes
{

// The files of a data set, one of them open at a time.
class TiffFiles
{
public:
	// names: of the files beside the first one.
	TiffFiles(std::string first, const std::vector<std::string>& names) : first_(std::move(first)), names_(names) {}

	// Throws a Refusal if it cannot be opened.
	TiffPages& open(std::uint32_t file);

private:
	std::string first_;
	const std::vector<std::string>& names_;
	std::optional<TiffPages> pages_;
	std::uint32_t current_ = std::numeric_limits<std::uint32_t>::max();
};

// The volume in TIFF pages, at one time after the other.
class TiffVolume
{
public:
	// Reads how the pages make a volume. Throws a Refusal if they make none.
	explicit TiffVolume(const std::string& file);
	TiffVolume(const TiffVolume&) = delete;
	TiffVolume& operator=(const TiffVolume&) = delete;

	const TiffLayout& layout() const { return layout_; }
	// Returns what of the file is left out.
	std::vector<std::string> leftOut();

	// Chooses a time. It comes before all that follows. Throws a Refusal if the file has not the values of its pages.
	void choose(std::uint32_t time);
	arrays::ValueLayout values() const;
	void readPlane(std::uint32_t channel, std::uint32_t slice, char* to);

	// Returns where the values of a channel lie in parts: rows of plain pages, or the strips or tiles of others.
	// Returns nothing if these are larger than parts may be.
	std::optional<arrays::StoredPlace> storedPlace(std::uint32_t channel);
	// Reads a strip or tile, by its number among those of all slices. `to` has room for one, also at the rims.
	void readPart(std::uint32_t channel, std::uint64_t number, std::span<std::byte> to);

private:
	struct Plane
	{
		std::uint32_t file = 0;
		std::uint64_t page = std::numeric_limits<std::uint64_t>::max(); // none
	};

	void mapPlanes();
	Plane planeOf(std::uint32_t channel, std::uint32_t slice);
	std::optional<std::vector<std::uint64_t>> plainPlanes(std::uint32_t channel);

	std::string file_;
	TiffLayout layout_;
	TiffFiles files_;
	std::vector<std::uint64_t> alike_; // pages like the first one that is no preview
	std::vector<Plane> planes_;
	TiffPageKind kind_;
	std::uint32_t time_ = 0;
	bool reads_behind_ = false; // the values of all planes follow the first page
};

} // namespace vp::reader::volumes
