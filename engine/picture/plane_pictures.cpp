#include "picture/plane_pictures.h"

#include "picture/facing.h"
#include "picture/sheet_looks.h"
#include "picture/sheet_values.h"
#include "write/frame_names.h"
#include "write/plane_picture.h"

#include <fmt/format.h>

namespace vp::picture
{

bool namesPictures(const std::string& output)
{
	return write::pictureFormatOf(output).has_value();
}

Result<std::vector<std::string>> pictureNames(const std::string& output, std::size_t sheets)
{
	if (sheets <= 1 && output.find("{sheet") == std::string::npos)
		return std::vector(sheets, output); // a probe may hide all its sheets
	Result<write::FrameNames> names = write::FrameNames::create(output, "{sheet}");
	if (!names)
		return names.error();
	std::vector<std::string> paths;
	for (std::size_t i = 0; i < sheets; ++i)
		paths.push_back(names->of(static_cast<int>(i)));
	return paths;
}

Result<std::vector<std::string>> writePictures(const session::Session& session, const view::ResolvedLook& look,
                                               const cut::Cut& slice, const std::vector<session::SheetStats>& sheets,
                                               const std::string& output)
{
	Result<std::vector<std::string>> paths = pictureNames(output, sheets.size());
	if (!paths)
		return paths;
	const std::vector<render::Segment> outline = render::outlineOf(session.blocks(), look.look.outline);
	const grid::Orientation orientation = orientationOf(session.blocks());
	SheetLooks looks(session, look);
	if (Status seen = looks.seeTimesIfAsked(); !seen)
		return seen.error();
	std::vector<render::FlatScene> flats;
	for (std::size_t s = 0; s < sheets.size(); ++s)
	{
		auto scale = looks.scaleOf(slice, sheets, hasNan(sheets[s]));
		if (!scale)
			return scale.error();
		Result<render::SheetDrawing> drawing = looks.drawing(slice.sheets[s], sheets[s]);
		if (!drawing)
			return drawing.error();
		render::FlatScene& flat = flats.emplace_back();
		flat.scene.values = *scale;
		flat.scene.sheets.push_back(std::move(*drawing));
		flat.scene.outline = outline;
		flat.scene.bounds = session.blocks().bounds();
		flat.scene.look = looks.choice().look;
		if (looks.choice().captions)
			flat.scene.look.caption = withTime(session, caption(slice.sheets[s].sheet, *flat.scene.bounds));
		flat.camera = look.spec.camera;
		flat.content = facingSheet(slice.sheets[s].sheet, orientation, session.spec().probe.up.has_value());
		if (orientation.patient)
			flat.sides = sidesOf(flat.content, *orientation.patient);
		const grid::BlockSet& blocks = slice.blocksOf(session.blocks());
		ShownPolygons shown = sheets[s].crinkle // no part of a flat picture
		                          ? ShownPolygons{sheets[s].mesh, sheetValues(blocks, slice.sheets[s], sheets[s].mesh,
		                                                                      look.byGeneration())}
		                          : shownPolygons(blocks, slice.sheets[s], sheets[s], look.byGeneration());
		flat.mesh = &shown.mesh;
		flat.color_steps = write::colorSteps(*write::pictureFormatOf(output));
		if (look.look.mesh)
			flat.part_edges = mesh::partEdges(blocks, shown.mesh);
		flat.values = std::move(shown.values);
	}
	if (Status written = write::writePlanePictures(flats, *paths); !written)
		return written.error();
	return paths;
}

} // namespace vp::picture
