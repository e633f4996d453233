#pragma once

#include "vprobe-read/text/gzip_text.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace vp::reader::codes
{

// Processors that write by OpenFOAM's collated file handler share their files: each has a block of every file, and the
// head of what is in the blocks stands in the first one.

// Returns what follows the beginning of the first block, or the whole text if it has no blocks. A file's first bytes
// are enough.
std::string_view foamFirstBlock(std::string_view text);

// The text of a file, or that of one of its blocks with the head in front.
class FoamFileText
{
public:
	FoamFileText(const std::filesystem::path& file, std::optional<std::size_t> block);
	std::string_view text() const { return has_block_ ? std::string_view(block_) : file_.text(); }

private:
	text::MaybeGzip file_;
	bool has_block_ = false;
	std::string block_;
};

} // namespace vp::reader::codes
