#pragma once

#include "vprobe-read/base/mapped_text.h"

#include <string>
#include <string_view>

namespace vp::reader::text
{

// The text of a whole file, unpacked if it is packed by gzip.
class MaybeGzip
{
public:
	explicit MaybeGzip(const std::string& file);
	std::string_view text() const { return is_packed_ ? std::string_view(unpacked_) : mapped_.text(); }

private:
	MappedText mapped_;
	bool is_packed_;
	std::string unpacked_;
};

} // namespace vp::reader::text
