#pragma once

#include "foam_case.h"
#include "foam_join.h"

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace vp::reader::codes
{

// A case at one time: whole, or put together from the parts of its processors.
class FoamWhole
{
public:
	explicit FoamWhole(FoamCase whole) : parts_({std::move(whole)}) {}
	// threads: the most that read parts side by side.
	FoamWhole(std::vector<FoamCase> parts, int threads)
	    : parts_(std::move(parts)), threads_(threads), is_decomposed_(true)
	{
	}

	std::vector<std::string> regions() const;
	FoamRegion region(const std::string& name) const;
	// Those of the first part.
	std::vector<FoamFieldFile> fields(const std::string& region) const { return parts_[0].fields(region); }
	// Throws FoamUnknown if a part does not have the field.
	FoamField field(const FoamFieldFile& file, const std::string& name, const FoamRegion& region) const;

private:
	void forEachPart(const std::function<void(std::size_t)>& read) const;

	std::vector<FoamCase> parts_;
	int threads_ = 1;
	bool is_decomposed_ = false;
};

} // namespace vp::reader::codes
