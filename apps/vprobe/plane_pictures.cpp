#include "plane_pictures.h"

#include "painter.h"
#include "slice/generations.h"
#include "write/frame_names.h"
#include "write/plane_picture.h"

#include <fmt/format.h>

namespace vp::app
{

namespace
{

std::vector<double> vertexValues(const grid::BlockSet& blocks, const slice::SheetMesh& mesh,
                                 const slice::FieldChoice& field)
{
	const std::vector<const grid::Field*> fields = field.inEach(blocks);
	std::vector<double> values;
	values.reserve(mesh.positions.size());
	for (std::size_t v = 0; v < mesh.positions.size(); ++v)
		values.push_back(slice::vertexValue(blocks, mesh, v, fields, field.component));
	return values;
}

std::vector<double> polygonValues(const grid::BlockSet& blocks, const slice::SheetMesh& mesh,
                                  const slice::FieldChoice& field)
{
	std::vector<double> values;
	values.reserve(mesh.polygons());
	for (const auto& [b, cell] : mesh.polygon_cells)
	{
		const grid::Field* of_block = field.in(blocks.blocks[b]);
		values.push_back(of_block ? slice::cellValue(blocks.blocks[b], *of_block, field.component, cell)
		                          : std::numeric_limits<double>::quiet_NaN());
	}
	return values;
}

void setValues(const Session& session, const slice::SheetSlice& sheet, bool by_generation, render::FlatScene& flat)
{
	if (by_generation)
		flat.polygon_values = slice::polygonGenerations(sheet, *flat.mesh);
	else if (sheet.field && sheet.field->association == grid::Association::cell)
		flat.polygon_values = polygonValues(session.blocks, *flat.mesh, *sheet.field);
	else if (sheet.field)
		flat.vertex_values = vertexValues(session.blocks, *flat.mesh, *sheet.field);
}

} // namespace

bool namesPictures(const std::string& output)
{
	return write::pictureFormatOf(output).has_value();
}

Status refuseLook(const CLI::App& command, const std::string& output)
{
	for (const CLI::Option* option : command.get_options())
		if (option->get_group() == "Look" && option->count() > 0)
			return Error{
			    ExitCode::usage,
			    fmt::format("{}: says how a picture looks, and {}; write a .png, .svg or .pdf, or leave it out",
			                option->get_name(),
			                output.empty() ? "no -o asks for one" : fmt::format("-o {} is none", output))};
	return Nothing{};
}

Result<std::vector<std::string>> pictureNames(const std::string& output, std::size_t sheets)
{
	if (sheets == 1 && output.find("{sheet") == std::string::npos)
		return std::vector{output};
	Result<write::FrameNames> names = write::FrameNames::create(output, "{sheet}");
	if (!names)
		return names.error();
	std::vector<std::string> paths;
	for (std::size_t i = 0; i < sheets; ++i)
		paths.push_back(names->of(static_cast<int>(i)));
	return paths;
}

Result<std::vector<std::string>> writePictures(const Session& session, const std::vector<std::string>& inputs,
                                               const LookChoice& look, const slice::Slice& slice,
                                               const std::vector<SheetStats>& sheets, const std::string& output)
{
	Result<std::vector<std::string>> paths = pictureNames(output, sheets.size());
	if (!paths)
		return paths;
	const std::vector<render::Segment> outline = render::outlineOf(session.blocks, look.look.outline);
	SheetLooks looks(session, inputs, look);
	std::vector<render::FlatScene> flats;
	for (std::size_t s = 0; s < sheets.size(); ++s)
	{
		auto scale = looks.scaleOf(slice, hasNan(sheets[s]));
		if (!scale)
			return scale.error();
		Result<render::SheetDrawing> drawing = looks.drawing(slice.sheets[s], sheets[s]);
		if (!drawing)
			return drawing.error();
		render::FlatScene& flat = flats.emplace_back();
		flat.scene.values = *scale;
		flat.scene.sheets.push_back(std::move(*drawing));
		flat.scene.outline = outline;
		flat.scene.bounds = session.blocks.bounds();
		flat.scene.look = look.look;
		flat.scene.look.caption = caption(slice.sheets[s].sheet);
		flat.camera = look.camera;
		flat.content = slice.sheets[s].sheet;
		flat.mesh = &sheets[s].mesh;
		flat.color_steps = write::colorSteps(*write::pictureFormatOf(output));
		setValues(session, slice.sheets[s], look.by_generation, flat);
	}
	if (Status written = write::writePlanePictures(flats, *paths); !written)
		return written.error();
	return paths;
}

} // namespace vp::app
