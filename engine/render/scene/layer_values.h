#pragma once

#include <cstdint>
#include <functional>
#include <span>

namespace vp::render
{

/// What the sheets of a picture show at each pixel in one sample, before they have colors. The layers follow each
/// other, each with its rows from the top. A value is followed by how much of a mesh line is there, if there are two
/// channels.
struct LayerValues
{
	std::uint32_t width = 0;
	std::uint32_t height = 0;
	std::uint32_t layers = 0;
	std::uint32_t channels = 1;
	std::span<float> values; // shared::kEmptyValue where a sheet is not

	std::size_t count() const { return std::size_t(width) * height * layers * channels; }
};

/// Takes in what other processes have drawn of the same sheets. Returns false in a process that is to draw no further,
/// since another one colors the layers.
using MergeLayers = std::function<bool(const LayerValues&)>;

} // namespace vp::render
