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
	std::uint32_t order; // number of the surface if it is opaque

	bool operator==(const SurfacePixel&) const = default;
};

/// The pixels that surfaces of any form show in one sample, in ascending order.
struct SurfaceFragments
{
	std::vector<SurfacePixel> nearest; // opaque surfaces, one entry at a pixel
	std::vector<SurfacePixel> listed;  // all other surfaces, in any order at a pixel
};

/// The values that the sheets of a picture show at each pixel in one sample, before they have colors. The layers follow
/// each other, each with its rows from the top. If there are two channels, a value is followed by the share of the
/// pixel that a mesh line covers.
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
