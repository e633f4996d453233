#include "commands.h"
#include "look_options.h"
#include "probe_options.h"
#include "render/renderer.h"
#include "slice/gpu_records.h"
#include "slice/host_records.h"
#include "stats_json.h"
#include "write/png.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

namespace vp::app
{

namespace
{

struct RenderOptions
{
	ProbeOptions probe;
	std::string output;
	std::string stats;
	LookOptions look;
};

std::string caption(const probe::Sheet& sheet)
{
	return fmt::format("origin {:.4g}, {:.4g}, {:.4g}   normal {:.3f}, {:.3f}, {:.3f}", sheet.origin.x, sheet.origin.y,
	                   sheet.origin.z, sheet.normal.x, sheet.normal.y, sheet.normal.z);
}

bool holdsNan(const std::vector<SheetStats>& sheets)
{
	return std::any_of(sheets.begin(), sheets.end(),
	                   [](const SheetStats& sheet) { return sheet.measure.nan_area > 0.0; });
}

// What the sheets look like where they lie: records that the GPU classifier left in device memory, or the CPU's mesh
// put there.
Result<std::vector<std::shared_ptr<const slice::SheetRecords>>>
sheetRecords(const Session& session, const slice::Slice& slice, const std::vector<SheetStats>& sheets)
{
	std::vector<std::shared_ptr<const slice::SheetRecords>> records;
	const std::shared_ptr<slice::RecordPool> pool = slice::RecordPool::create(*session.device);
	for (std::size_t s = 0; s < slice.sheets.size(); ++s)
	{
		if (slice.sheets[s].records)
		{
			records.push_back(slice.sheets[s].records);
			continue;
		}
		const auto host = slice::recordsFromMesh(session.blocks, slice.sheets[s].sheet, sheets[s].mesh, session.field);
		auto made = slice::recordsFromHost(pool, host);
		if (!made)
			return made.error();
		records.push_back(*made);
	}
	return records;
}

Result<render::Picture> drawSheets(Session& session, const slice::Slice& slice, const std::vector<SheetStats>& sheets,
                                   const std::vector<std::string>& inputs, const LookChoice& choice)
{
	auto records = sheetRecords(session, slice, sheets);
	if (!records)
		return records.error();
	auto values = valueScale(session, inputs, choice.look, holdsNan(sheets));
	if (!values)
		return values.error();

	render::Scene scene;
	scene.look = choice.look;
	scene.look.caption = caption(session.probe.sheets.front());
	scene.values = *values;
	scene.bounds = session.blocks.bounds();
	for (std::size_t s = 0; s < slice.sheets.size(); ++s)
		scene.sheets.push_back({slice.sheets[s].sheet, (*records)[s], choice.opacity});
	const std::vector<render::Segment> outline = render::outlineOf(session.blocks, scene.look.outline);
	scene.outline = outline;
	// The picture holds the blocks and the lines around them.
	std::vector<Vec3> extent = render::extentOf(session.blocks);
	if (scene.look.box_axes)
		for (int i = 0; i < 8; ++i)
			extent.push_back(render::corner(*scene.bounds, i));
	for (const render::Segment& line : outline)
		extent.insert(extent.end(), {line.a, line.b});
	scene.camera = render::makeCamera(choice.camera, &session.probe.sheets.front(), extent,
	                                  render::pictureFrame(scene.look, scene.values));

	Result<render::Renderer> renderer = render::Renderer::create(*session.device);
	if (!renderer)
		return renderer.error();
	return renderer->draw(scene, session.timeline.get());
}

Result<ExitCode> runRender(const RenderOptions& options)
{
	if (options.output.empty())
		return Error{ExitCode::usage, "-o: a picture needs a place; give the name of a .png file, or -"};
	if (options.output == "-" && options.stats == "-")
		return Error{ExitCode::usage,
		             "-o - and --stats -: standard output takes one thing at a time; name a file for the other"};
	if (options.output != "-" && std::filesystem::path(options.output).extension() != ".png")
		return Error{ExitCode::usage, fmt::format("-o {}: pictures are written as .png; give a name that ends so, or -",
		                                          options.output)};
	Result<LookChoice> look = parseLook(options.look, options.probe.inputs);
	if (!look)
		return look.error();

	Result<std::unique_ptr<Session>> opened = openSession(options.probe, DeviceUse::draw);
	if (!opened)
		return opened.error();
	Session& session = **opened;
	Result<slice::Slice> slice = cut(session);
	if (!slice)
		return slice.error();
	const std::vector<SheetStats> sheets = sheetStats(session, *slice);
	Result<render::Picture> picture = [&]
	{
		const TimedSection section(session.timeline.get(), "render");
		return drawSheets(session, *slice, sheets, options.probe.inputs, *look);
	}();
	if (!picture)
		return picture.error();
	if (Status written = write::writePng(*picture, options.output); !written)
		return written.error();
	return writeStats(options.stats, options.output, statsJson(options.probe, session, *slice, sheets));
}

} // namespace

void addRender(CLI::App& program, Run& run)
{
	auto options = std::make_shared<RenderOptions>();
	CLI::App* command =
	    program.add_subcommand("render", "Draw the cut of an input by a plane, with legend and axes, as a PNG");
	addInputs(*command, options->probe);
	addProbeOptions(*command, options->probe);
	command->add_option("-o,--output", options->output, "Picture; - writes it to standard output")
	    ->type_name("FILE.png|-");
	command->add_option("--stats", options->stats, "Figures and times as JSON")->type_name("FILE|-");

	addLookOptions(*command, options->look);
	command->callback([&run, options] { run = [options] { return runRender(*options); }; });
}

} // namespace vp::app
