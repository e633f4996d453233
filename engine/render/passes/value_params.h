#pragma once

#include "render/scene/value_style.h"
#include "shared/render_types.h"

#include <cstdint>
#include <vector>

namespace vp::render
{

// The words that coloring shaders read beside their parameters (render_colors.glsl). add() returns the place.
class ColorTables
{
public:
	std::uint32_t add(const std::vector<Color>& colors);
	std::uint32_t add(const std::vector<double>& numbers);
	// All of them, never empty: behind them is what is read, and not shown, where there are no values.
	std::vector<std::uint32_t> take();

private:
	std::vector<std::uint32_t> words_;
};

// How values become colors; the rest of `sheet` is left as it is. Without values all have one color.
void setPlain(shared::SheetParams& sheet, Color color);
void setValues(shared::SheetParams& sheet, const ValueStyle& style, ColorTables& tables);

// The kCompose bits that its values ask for.
std::uint32_t featuresOf(const shared::SheetParams& sheet);

} // namespace vp::render
