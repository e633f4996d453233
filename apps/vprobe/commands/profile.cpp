#include "base/messages.h"
#include "base/progress.h"
#include "commands/commands.h"
#include "options/spec_options.h"
#include "options/trace_option.h"
#include "picture/painter.h"
#include "profile/profile_compare.h"
#include "profile/profile_report.h"
#include "profile/team_profile.h"
#include "report/console.h"
#include "report/explain.h"
#include "report/remaining_time.h"
#include "session/frame.h"
#include "team.h"
#include "view/settings.h"
#include "view/validate.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace vp::app
{

namespace
{

constexpr int kMaxPlanes = 10'000; // a profile keeps some dozens of numbers for each generation of each

struct ProfileOptions
{
	SpecOptions common;
	std::string path = "profile"; // not the sweep's that a state brings
	int planes = probe::kProfilePlanes;
	bool draw = false;
	std::string json;
	std::string trace;
	std::vector<std::string> compare; // none, or two files
};

// Of --compare, which measures nothing.
Status requireAlone(const CLI::App& command)
{
	for (const CLI::Option* option : command.get_options())
		if (option->count() > 0 && option->get_name() != "--compare")
			return Error{ErrorKind::usage,
			             fmt::format("{}: means nothing to --compare, which reads two profiles; leave one of the two "
			                         "out",
			                         option->get_name())};
	return Nothing{};
}

Result<ExitCode> runCompare(const ProfileOptions& options, const CLI::App& command)
{
	if (Status alone = requireAlone(command); !alone)
		return alone.error();
	if (!isFirst())
		return ExitCode::done;
	Result<nlohmann::json> a = readProfile(options.compare[0]);
	if (!a)
		return a.error();
	Result<nlohmann::json> b = readProfile(options.compare[1]);
	if (!b)
		return b.error();
	print("{}", compareProfiles(*a, *b, options.compare[0], options.compare[1]));
	return ExitCode::done;
}

// Told before a large file is read.
Status checkProfileOptions(const ProfileOptions& options, const CLI::App& command)
{
	if (options.json == "-" && options.trace == "-")
		return Error{ErrorKind::usage,
		             "--json - and --trace -: standard output takes one thing at a time; name a file for the other"};
	if (Status place = isFirst() ? checkWritable(options.json) : Nothing{}; !place)
		return place;
	if (options.planes < 1 || options.planes > kMaxPlanes)
		return Error{ErrorKind::usage,
		             fmt::format("--planes {}: give a number from 1 to {}", options.planes, kMaxPlanes)};
	return options.draw ? Status(Nothing{}) : refuseLook(command, "nothing is drawn", "add --draw");
}

Result<probe::Path> pathOf(const ProfileOptions& options)
{
	view::SweepSpec sweep;
	if (Status chosen = choosePath(sweep, options.path); !chosen)
		return Error{chosen.error().kind, fmt::format("`path` {}: {}", options.path, chosen.error().message)};
	if (sweep.over_times)
		return Error{ErrorKind::usage, "--path times: a profile moves a probe; choose another path"};
	if (Status fits = view::requirePathOfSurface(options.common.spec.probe, sweep); !fits)
		return fits.error();
	return view::pathOf(sweep);
}

// Measures plane after plane; nothing is cut before the first, so that it shows what a first cut takes.
class Measurement
{
public:
	Measurement(session::Session& session, std::optional<picture::Painter> painter,
	            std::optional<write::TraceFile>& trace)
	    : session_(session), painter_(std::move(painter)), trace_(trace)
	{
	}

	Status run(const std::vector<probe::Frame>& poses, const probe::Path& path)
	{
		const int planes = static_cast<int>(poses.size());
		RemainingTime remaining(poses.size());
		Progress progress(remaining.line());
		hand(session_.timeline()->takeSections()); // of what was read and built
		for (int k = 0; k < planes; ++k)
		{
			progress.say(remaining.line());
			if (Status measured = plane({.pose = poses[static_cast<std::size_t>(k)],
			                             .done = probe::progress(path, k, planes),
			                             .wants = wants(),
			                             .expect = session::Expect::more});
			    !measured)
				return measured;
			std::vector<Timeline::Section> sections = session_.timeline()->takeSections();
			log_.add(cut_->slice, cut_->sheets, sections);
			hand(std::move(sections));
			remaining.done();
		}
		return Nothing{};
	}

	const ProfileLog& log() const { return log_; }

private:
	session::Wants wants() const
	{
		using Figures = session::Wants::Figures;
		return {.figures = painter_ ? Figures::for_picture : Figures::none, .contours = false, .warns = false};
	}

	Status plane(const session::FrameRequest& request)
	{
		const TimedSection section(session_.timeline(), "frame");
		Result<std::shared_ptr<const session::Frame>> made = session_.frame(request);
		if (!made)
			return made.error();
		cut_ = std::move(*made);
		if (!painter_)
			return Nothing{};
		const Result<render::Picture> picture = painter_->draw(cut_->slice, cut_->sheets);
		return picture ? Status(Nothing{}) : picture.error();
	}

	void hand(std::vector<Timeline::Section> sections)
	{
		if (trace_)
			trace_->add(std::move(sections));
	}

	session::Session& session_;
	std::optional<picture::Painter> painter_;
	std::optional<write::TraceFile>& trace_;
	ProfileLog log_;
	std::shared_ptr<const session::Frame> cut_; // of the last plane
};

Status writeJson(const std::string& path, const nlohmann::json& document)
{
	const std::string text = document.dump(1, '\t', false, nlohmann::json::error_handler_t::replace) + "\n";
	const Result<ExitCode> written = writeStats(path, {}, text);
	return written ? Status(Nothing{}) : written.error();
}

Status report(const ProfileOptions& options, const Profile& profile, std::optional<write::TraceFile>& trace)
{
	const nlohmann::json document = profileOfTeam(profile);
	if (!isFirst())
		return Nothing{};
	if (document["empty_planes"] > 0)
		warn("{} of {} planes are empty: the probe misses the grid there", document["empty_planes"].get<int>(),
		     document["planes"].get<int>());
	if (options.json != "-" && options.trace != "-")
		print("{}", profileTable(document));
	if (Status written = writeJson(options.json, document); !written)
		return written;
	if (trace)
		if (Status written = trace->commit(); !written)
			return written;
	return saveSpec(options.common);
}

Result<ExitCode> runProfile(const ProfileOptions& options, const CLI::App& command)
{
	if (!options.compare.empty())
		return runCompare(options, command);
	view::ViewSpec spec = options.common.spec;
	if (!options.draw)
		spec.look = {}; // that a state brings: it has no say
	if (Status ready = prepare(options.common); !ready)
		return ready.error();
	session::OpenOptions how{.use = options.draw ? session::DeviceUse::draw : session::DeviceUse::classify,
	                         .keep = Timeline::Keep::sections,
	                         .ranks = processes()};
	if (options.common.explain)
		return explain(options.common.spec, {});
	const Result<probe::Path> path = pathOf(options);
	if (!path)
		return path.error();
	for (const Status& fits :
	     {checkProfileOptions(options, command), view::refuseGenerations(spec.probe, spec.look.color_by)})
		if (!fits)
			return fits.error();
	Result<view::ResolvedLook> look = view::resolveLook(spec);
	if (!look)
		return look.error();
	const std::string picture =
	    fmt::format("{}x{}, {} samples", look->look.width, look->look.height, look->look.samples);
	Result<std::optional<write::TraceFile>> trace = openTrace(options.trace);
	if (!trace)
		return trace.error();

	Result<std::unique_ptr<session::Session>> opened = session::Session::open(spec, how);
	if (!opened)
		return opened.error();
	session::Session& session = **opened;
	std::optional<picture::Painter> painter;
	if (options.draw)
	{
		Result<picture::Painter> made = picture::Painter::create(session, std::move(*look));
		if (!made)
			return made.error();
		painter.emplace(std::move(*made));
	}
	Measurement measurement(session, std::move(painter), *trace);
	const auto poses = probe::poses(*path, session.view().probe, session.blocks().bounds(), options.planes);
	if (Status measured = measurement.run(poses, *path); !measured)
		return measured.error();
	const Profile profile{session, measurement.log(), options.path,
	                      options.draw ? std::optional(picture) : std::nullopt};
	if (Status reported = report(options, profile, *trace); !reported)
		return reported.error();
	return ExitCode::done;
}

} // namespace

void addProfile(CLI::App& program, Run& run)
{
	auto options = std::make_shared<ProfileOptions>();
	CLI::App* command = program.add_subcommand(
	    "profile", "Measure a sweep of a probe through an input: times of every stage, work, memory; compare two");
	addInputs(*command, options->common)->required(false); // --state may name them
	addProbeOptions(*command, options->common);
	addExplain(*command, options->common);
	addSettings(*command, options->common, "look");
	addStateOptions(*command, options->common);
	const char* group = "Profile";
	command->add_flag("--draw", options->draw, "Measure whole frames: draw every plane as well")->group(group);
	command->add_option("--planes", options->planes, "Number of planes")
	    ->capture_default_str()
	    ->type_name("N")
	    ->group(group);
	command
	    ->add_option("--path", options->path,
	                 "Path of the probe: profile (planes that tilt through the middle of the bounds), or any path that "
	                 "sweep takes")
	    ->capture_default_str()
	    ->type_name("NAME|FILE.json")
	    ->group(group);
	command->add_option("--json", options->json, "The figures as JSON; - writes them instead of the table")
	    ->type_name("FILE|-")
	    ->group(group);
	addTraceOption(*command, options->trace, group);
	command
	    ->add_option("--compare", options->compare,
	                 "Measure nothing, and print what changed between two files that --json wrote")
	    ->expected(2)
	    ->allow_extra_args(false)
	    ->type_name("A.json B.json")
	    ->group(group);
	command->callback([&run, options, command]
	                  { run = [options, command] { return runProfile(*options, *command); }; });
}

} // namespace vp::app
