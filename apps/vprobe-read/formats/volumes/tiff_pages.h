#pragma once

#include "grid/field.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vp::reader::volumes
{

// How a page of a TIFF file holds its values.
struct TiffPageKind
{
	std::uint32_t width = 0;
	std::uint32_t height = 0;
	std::uint16_t samples = 1; // per pixel
	std::uint16_t bits = 1;    // per sample
	std::uint16_t format = 1;  // libtiff's SAMPLEFORMAT_...

	bool operator==(const TiffPageKind&) const = default;
	// Throws a Refusal for types that are not read. Single bits become bytes.
	grid::NumberType type() const;
	std::uint64_t bytes() const; // in a page that was read
};

// The pages of a TIFF file, through libtiff. Whatever libtiff complains about while it reads values is an error.
class TiffPages
{
public:
	// Throws a Refusal if libtiff cannot open it.
	explicit TiffPages(const std::string& file);
	~TiffPages();

	std::uint64_t count() const { return pages_.size(); }
	const TiffPageKind& kind(std::uint64_t page) const { return pages_[page].kind; }
	bool isPreview(std::uint64_t page) const { return pages_[page].is_preview; }
	std::string description(); // that of the first page
	std::array<double, 2> resolution();
	std::string resolutionUnit();

	// Throws a Refusal if the page asks for more values than the file can hold, before there is room made for them.
	void refuseImpossible(std::uint64_t page);
	// Reads a page into kind(page).bytes(), samples of a pixel side by side.
	void read(std::uint64_t page, char* to);
	// Reads the plane with this number of those that follow the values of the first page, which have no pages of their
	// own: so ImageJ writes what is larger than 4 GiB.
	void readBehindFirst(std::uint64_t plane, char* to);
	bool isPlain(std::uint64_t page); // its values stand in the file as they are, in strips
	// Returns where the values of such a page begin, if its strips lie one after the other.
	std::optional<std::uint64_t> plainBegin(std::uint64_t page);
	bool isSwapped() const; // its numbers have the other order of bytes

	// Returns the width and height of the tiles of a page, or of its strips.
	std::array<std::uint32_t, 2> blockSize(std::uint64_t page);
	// Reads a tile or strip, by its place in the page, into rows of its own width. Pixels beyond the page stay as they
	// are.
	void readBlock(std::uint64_t page, std::uint64_t across, std::uint64_t down, char* to);

private:
	struct Page
	{
		TiffPageKind kind;
		bool is_preview;
		std::uint64_t place;
	};
	void select(std::uint64_t page);
	void beginValues();
	void readTiles(const TiffPageKind& kind, char* to);
	void readRows(const TiffPageKind& kind, char* to);

	std::string file_;
	void* tiff_ = nullptr;
	std::vector<Page> pages_;
};

} // namespace vp::reader::volumes
