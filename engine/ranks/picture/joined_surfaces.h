#pragma once

#include "base/result.h"
#include "ranks/join/borders.h"
#include "ranks/search/joined_contour.h"
#include "render/passes/surface_polygons.h"
#include "render/scene/sheet_contours.h"

#include <memory>
#include <span>

namespace vp::ranks
{

/// Returns the polygons of a surface in device memory. Those of other ranks around them have a part in how they look.
/// borders: joinBorders() or joinWholeCells() of the mesh. part_edges: edges that lines of the mesh leave out.
Result<std::shared_ptr<const render::SurfacePolygons>>
surfacePolygons(const Ranks& ranks, gpu::Device& device, const mesh::SheetMesh& mesh, const Borders& borders,
                render::SheetValues values, const mesh::PartEdges& part_edges = {});

/// Returns the polygons of the contours of a sheet, where the sheet shows them, or null if there is nothing to draw.
/// colored: they show their values.
Result<std::shared_ptr<const render::SurfacePolygons>> contourPolygons(const Ranks& ranks, gpu::Device& device,
                                                                       const cut::SheetCut& sheet,
                                                                       std::span<const GrownContour> contours,
                                                                       bool colored);

/// Returns the polygons of a surface that all ranks have as a whole. Only the first rank draws it.
Result<std::shared_ptr<const render::SurfacePolygons>> surfaceOfFirst(const Ranks& ranks, gpu::Device& device,
                                                                      const mesh::SheetMesh& mesh,
                                                                      const render::SurfaceValues& values);

} // namespace vp::ranks
