#pragma once

#include "mesh/part_edges.h"
#include "mesh/sheet_mesh.h"
#include "render/scene/scene.h"

#include <array>
#include <string>
#include <vector>

typedef struct _cairo cairo_t;

namespace vp::render
{

// A sheet seen straight on and true to scale, with axes. Beside it a small view shows where the sheet lies in the grid.
struct FlatScene
{
	Scene scene;         // has this sheet alone; its records and its camera are not used
	CameraChoice camera; // camera of the small view
	probe::Sheet content;
	const mesh::SheetMesh* mesh = nullptr; // mesh of the content
	SheetValues values;
	mesh::PartEdges part_edges{};     // edges that the mesh lines leave out
	std::array<std::string, 4> sides; // letters at the left, right, lower and upper rim; mostly empty
	// The number of color steps over the range, if the look has no bands. At most 256, as in a color map. A file of
	// polygons grows with it.
	int color_steps = kColorMapSize;

	const SheetDrawing& sheet() const { return scene.sheets.front(); }
	bool hasValues() const { return scene.values || sheet().values; }
};

// Draws the scene in the units of the look's size, with y down. It needs no device.
void drawFlat(const FlatScene& flat, cairo_t* context);

} // namespace vp::render
