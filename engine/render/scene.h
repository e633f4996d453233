#pragma once

#include "probe/sheet.h"
#include "render/camera.h"
#include "render/look.h"
#include "render/outline.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vp::slice
{
struct SheetRecords;
}

namespace vp::render
{

struct SheetDrawing
{
	probe::Sheet sheet;                                 // the frame of the records' uv
	std::shared_ptr<const slice::SheetRecords> records; // polygons in device memory; null: an empty sheet
	double opacity = 1.0;
};

// The array that the sheets show.
struct ValueScale
{
	std::string title; // above the legend: name and component
	double lo = 0.0;   // of the data
	double hi = 1.0;
	bool has_nan = false; // puts a swatch into the legend
};

struct Scene
{
	std::vector<SheetDrawing> sheets; // up to shared::kMaxLayers
	std::optional<ValueScale> values; // none: the sheets have one plain colour
	std::span<const Segment> outline;
	Camera camera; // made for pictureFrame() of the same scene
	Look look;
};

// The ends of the colour map.
std::pair<double, double> colorRange(const ValueScale& values, const Look& look);

// The picture and the part of it that legend, title, caption and axes leave: for makeCamera().
Frame pictureFrame(const Look& look, const std::optional<ValueScale>& values);

} // namespace vp::render
