#include "commands.h"
#include "probe_options.h"
#include "render/renderer.h"
#include "slice/gpu_records.h"
#include "slice/host_records.h"
#include "stats_json.h"
#include "write/png.h"

#include <fmt/format.h>

#include <cmath>
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
	std::string size = "1280x720";
	int samples = 8;
	std::string colormap = "viridis";
	std::vector<double> range;
	double opacity = 1.0;
	std::string background = "gradient";
	std::string camera = "auto";
	std::string outline = "box";
	std::optional<std::string> title;
};

Result<render::Look> makeLook(const RenderOptions& options)
{
	render::Look look;
	Result<std::pair<std::uint32_t, std::uint32_t>> size = render::parseSize(options.size);
	if (!size)
		return size.error();
	std::tie(look.width, look.height) = *size;
	look.samples = options.samples;
	Result<render::ColorMap> colors = render::makeColorMap(options.colormap);
	if (!colors)
		return colors.error();
	look.colors = *colors;
	if (!options.range.empty())
	{
		if (!(options.range[0] < options.range[1]) || !std::isfinite(options.range[1] - options.range[0]))
			return Error{ExitCode::usage, fmt::format("--range {} {}: the first number must be below the second",
			                                          options.range[0], options.range[1])};
		look.range = {options.range[0], options.range[1]};
	}
	Result<render::Background> background = render::parseBackground(options.background);
	if (!background)
		return background.error();
	look.background = *background;
	Result<render::Outline> outline = render::parseOutline(options.outline);
	if (!outline)
		return outline.error();
	look.outline = *outline;
	return look;
}

std::string defaultTitle(const std::vector<std::string>& inputs)
{
	const std::string& first = inputs.front();
	const std::string name = first.starts_with("demo:") ? first : std::filesystem::path(first).filename().string();
	return inputs.size() == 1 ? name : fmt::format("{} and {} more", name, inputs.size() - 1);
}

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
                                   const RenderOptions& options, const render::CameraChoice& camera,
                                   const render::Look& look)
{
	auto records = sheetRecords(session, slice, sheets);
	if (!records)
		return records.error();

	render::Scene scene;
	scene.look = look;
	scene.look.title = options.title.value_or(defaultTitle(options.probe.inputs));
	scene.look.caption = caption(session.probe.sheets.front());
	if (session.field)
	{
		const auto [lo, hi] = slice::fieldRange(session.blocks, *session.field);
		scene.values = {session.field->title(session.blocks), lo, hi, holdsNan(sheets)};
	}
	for (std::size_t s = 0; s < slice.sheets.size(); ++s)
		scene.sheets.push_back({slice.sheets[s].sheet, (*records)[s], options.opacity});
	const std::vector<render::Segment> outline = render::outlineOf(session.blocks, look.outline);
	scene.outline = outline;
	// The picture holds the blocks and the lines around them.
	std::vector<Vec3> extent = render::extentOf(session.blocks);
	for (const render::Segment& line : outline)
		extent.insert(extent.end(), {line.a, line.b});
	scene.camera = render::makeCamera(camera, &session.probe.sheets.front(), extent,
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
	Result<render::Look> look = makeLook(options);
	if (!look)
		return look.error();
	Result<render::CameraChoice> camera = render::parseCamera(options.camera);
	if (!camera)
		return camera.error();

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
		return drawSheets(session, *slice, sheets, options, *camera, *look);
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

	const char* group = "Look";
	command->add_option("--size", options->size, "Of the picture in pixels")
	    ->type_name("WxH")
	    ->capture_default_str()
	    ->group(group);
	command->add_option("--samples", options->samples, "Samples per pixel, for smooth edges")
	    ->check(CLI::Range(1, render::kMaxSamples))
	    ->capture_default_str()
	    ->group(group);
	command->add_option("--colormap", options->colormap, fmt::format("{}", fmt::join(render::colorMapNames(), ", ")))
	    ->type_name("NAME")
	    ->capture_default_str()
	    ->group(group);
	command
	    ->add_option("--range", options->range,
	                 "Values at the ends of the colour map (default: those of the whole array)")
	    ->expected(2)
	    ->allow_extra_args(false)
	    ->type_name("LO HI")
	    ->group(group);
	command->add_option("--opacity", options->opacity, "Of the sheet, 0 to 1")
	    ->check(CLI::Range(0.0, 1.0))
	    ->capture_default_str()
	    ->group(group);
	command
	    ->add_option("--background", options->background, "gradient, white, black, grey, transparent, #RGB or #RRGGBB")
	    ->type_name("COLOUR")
	    ->capture_default_str()
	    ->group(group);
	command
	    ->add_option("--camera", options->camera,
	                 "auto (obliquely onto the sheet), x, -x, y, -y, z, -z, iso, sheet, azimuth and elevation in "
	                 "degrees, or position, focal "
	                 "point and up as nine numbers")
	    ->type_name("VIEW|AZ,EL|9 NUMBERS")
	    ->capture_default_str()
	    ->group(group);
	command
	    ->add_option("--outline", options->outline,
	                 "What orients the sheet: box, edges (the boundary's feature edges) or none")
	    ->capture_default_str()
	    ->group(group);
	command->add_option("--title", options->title, "Above the picture (default: the input's name; \"\" for none)")
	    ->type_name("TEXT")
	    ->group(group);
	command->callback([&run, options] { run = [options] { return runRender(*options); }; });
}

} // namespace vp::app
