#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace vp::render
{

/// A fragment of a surface at a pixel, as shared::SurfaceFragment has it.
struct SurfacePixel
{
	std::uint32_t pixel; // counted from the top left
	float depth;         // near / w
	std::uint32_t color;
	std::uint32_t order; // of an opaque surface its number

	bool operator==(const SurfacePixel&) const = default;
};

/// What surfaces of any form show in one sample. Pixels ascend.
struct SurfaceFragments
{
	std::vector<SurfacePixel> nearest; // of opaque surfaces, one at a pixel
	std::vector<SurfacePixel> listed;  // of all others, in whatever order at a pixel
};

/// What the sheets of a picture show at each pixel in one sample, before they have colors. The layers follow each
/// other, each with its rows from the top. A value is followed by how much of a mesh line is there, if there are two
/// channels.
struct LayerValues
{
	std::uint32_t width = 0;
	std::uint32_t height = 0;
	std::uint32_t layers = 0;
	std::uint32_t channels = 1;
	std::span<float> values;              // shared::kEmptyValue where a sheet is not
	SurfaceFragments* surfaces = nullptr; // null in a picture without surfaces

	std::size_t count() const { return std::size_t(width) * height * layers * channels; }
};

/// Takes in what other processes have drawn of the same sheets. Returns false in a process that is to draw no further,
/// since another one colors the layers.
using MergeLayers = std::function<bool(const LayerValues&)>;

} // namespace vp::render
