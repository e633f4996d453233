#pragma once

#include "render/color/color_map.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace vp::render
{

// The color map that one of ParaView's presets describes, without its name. The error says what is wrong with the
// object and how it should be.
Result<ColorMap> colorMapOf(const nlohmann::json& preset);

// Returns the opacity between the points of a preset, x, alpha, midpoint and sharpness each, as vtkPiecewiseFunction
// has it: half way at the midpoint, and a sharpness from 0, a straight line, by Hermite curves to 1, a step.
double presetOpacity(const std::vector<double>& points, double x);

// A name for legends and error lines: line breaks become blanks. Empty where there is no text.
std::string oneLine(const nlohmann::json& words);

} // namespace vp::render
