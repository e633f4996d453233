#pragma once

#include "mesh/sheet_mesh.h"
#include "render/scene/scene.h"

#include <vector>

typedef struct _cairo cairo_t;

namespace vp::render
{

// A sheet seen straight on, true to scale, with axes, and beside it where it lies in the grid.
struct FlatScene
{
	Scene scene;         // of this sheet alone; its records are not looked at, nor is the camera
	CameraChoice camera; // of the small view
	probe::Sheet content;
	const mesh::SheetMesh* mesh = nullptr; // of the content
	SheetValues values;
	// Steps of color from the range's low end to its high one, where bands are not asked for. The color map holds
	// no more than 256; a file of polygons grows with them.
	int color_steps = kColorMapSize;

	const SheetDrawing& sheet() const { return scene.sheets.front(); }
	bool hasValues() const { return scene.values || sheet().values; }
};

// Draws it in the units of the look's size, y down. Nothing in it needs a device.
void drawFlat(const FlatScene& flat, cairo_t* context);

} // namespace vp::render
