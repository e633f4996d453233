#include "base/input_files.h"
#include "base/messages.h"
#include "base/progress.h"
#include "commands/commands.h"
#include "options/trace_option.h"
#include "profile/counted_planes.h"
#include "profile/history.h"
#include "profile/profile_compare.h"
#include "profile/profile_report.h"
#include "profile/swept_probe.h"
#include "profile/team_profile.h"
#include "profile/turns_report.h"
#include "report/console.h"
#include "report/explain.h"
#include "report/remaining_time.h"
#include "team.h"
#include "view/validate.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace vp::app
{

namespace
{

// For --compare and --history, which measure nothing.
Status requireAlone(const CLI::App& command, const std::string& reader, const std::string& with = "")
{
	for (const CLI::Option* option : command.get_options())
		if (option->count() > 0 && option->get_name() != reader && option->get_name() != with)
			return Error{ErrorKind::usage, fmt::format("{}: means nothing to {}, which reads what was measured before; "
			                                           "leave one of the two out",
			                                           option->get_name(), reader)};
	return Nothing{};
}

Result<ExitCode> runHistory(const ProfileOptions& options, const CLI::App& command)
{
	if (Status alone = requireAlone(command, "--history", "--output"); !alone)
		return alone.error();
	if (options.output.empty())
		return Error{ErrorKind::usage, "--history: draws a picture; name it by -o FILE.svg"};
	if (!isFirst())
		return ExitCode::done;
	const Result<History> history = readHistory(options.history);
	if (!history)
		return history.error();
	if (history->others > 0)
		warn("{} of {} runs are of other machines, devices or work than the last one, and are left out",
		     history->others, history->others + history->runs.size());
	return writeStats(options.output, {}, historySvg(*history));
}

Result<ExitCode> runCompare(const ProfileOptions& options, const CLI::App& command)
{
	if (Status alone = requireAlone(command, "--compare"); !alone)
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
	if (!options.output.empty())
		return Error{ErrorKind::usage, "-o: takes the picture of a --history; the figures go to --json"};
	if (!options.label.empty() && options.append.empty())
		return Error{ErrorKind::usage, "--label: names a run in a file; add --append FILE.jsonl"};
	if (options.append == "-")
		return Error{ErrorKind::usage, "--append -: runs are kept in a file; name one"};
	if (Status place = isFirst() ? checkWritable(options.append) : Nothing{}; !place)
		return place;
	if (!options.append.empty())
		noteInput(options.append); // nothing else may replace it
	if (!options.inTurns())
		for (const char* option : {"--rounds", "--at-most"})
			if (command.get_option(option)->count() > 0)
				return Error{ErrorKind::usage, fmt::format("{}: is about measuring in turns; add --versus or "
				                                           "--versus-program, or leave it out",
				                                           option)};
	if (Status fits = checkSweep(options); !fits)
		return fits;
	// With --with, the look was checked where the options were taken.
	return options.draw || !options.with.empty() ? Status(Nothing{})
	                                             : refuseLook(command, "nothing is drawn", "add --draw");
}

Status checkTurns(const ProfileOptions& options)
{
	if (!options.trace.empty())
		return Error{ErrorKind::usage, "--trace: tells of one program alone; leave it or --versus out"};
	if (!options.append.empty())
		return Error{ErrorKind::usage, "--append: keeps runs of one setting; leave it or --versus out"};
	if (processes().team())
		return Error{ErrorKind::usage, "--versus: measures one process for each setting; run it by vprobe"};
	if (options.rounds < kMinRounds || options.rounds > kMaxRounds)
		return Error{ErrorKind::usage,
		             fmt::format("--rounds {}: give a number from {} to {}", options.rounds, kMinRounds, kMaxRounds)};
	for (const std::string& text : options.versus)
	{
		ProfileOptions setting = options;
		Status fits = takeOptions(setting, text);
		if (fits)
			fits = prepare(setting.common);
		if (fits)
			fits = checkSweep(setting);
		if (!fits)
			return Error{fits.error().kind, fmt::format("--versus '{}': {}", text, fits.error().message)};
	}
	return Nothing{};
}

Status writeJson(const std::string& path, const nlohmann::json& document)
{
	const std::string text = document.dump(1, '\t', false, nlohmann::json::error_handler_t::replace) + "\n";
	const Result<ExitCode> written = writeStats(path, {}, text);
	return written ? Status(Nothing{}) : written.error();
}

Result<ExitCode> runTurns(const ProfileOptions& options)
{
	if (Status fits = checkTurns(options); !fits)
		return fits.error();
	std::vector<TimeLimit> limits;
	for (const std::string& text : options.at_most)
	{
		Result<TimeLimit> limit = parseTimeLimit(text);
		if (!limit)
			return Error{limit.error().kind, fmt::format("--at-most {}", limit.error().message)};
		limits.push_back(std::move(*limit));
	}
	std::vector<Contender> contenders;
	contenders.emplace_back(Contender::Kind::first, "");
	for (const std::string& text : options.versus)
		contenders.emplace_back(Contender::Kind::setting, text);
	for (const std::string& program : options.versus_program)
		contenders.emplace_back(Contender::Kind::build, program);
	Turns turns(std::move(contenders));
	if (Status begun = turns.begin(); !begun)
		return begun.error();
	if (Status known = checkLimits(turns, limits); !known)
		return known.error();
	if (Status measured = turns.run(options.rounds); !measured)
		return measured.error();
	const nlohmann::json document =
	    turnsJson(turns, limits,
	              {{"input", fmt::format("{}", fmt::join(options.common.spec.input.files, " "))},
	               {"path", options.path},
	               {"planes", options.planes},
	               {"draw", options.draw}});
	if (options.json != "-")
		print("{}", turnsTable(document));
	if (Status written = writeJson(options.json, document); !written)
		return written.error();
	if (Status saved = saveSpec(options.common); !saved)
		return saved.error();
	return exceedsLimit(document) ? ExitCode::differs : ExitCode::done;
}

// Measures plane after plane.
Result<ProfileLog> measure(SweptProbe& swept, std::optional<write::TraceFile>& trace)
{
	ProfileLog log;
	RemainingTime remaining(swept.planes());
	Progress progress(remaining.line());
	const auto hand = [&](std::vector<Timeline::Section> sections)
	{
		if (trace)
			trace->add(std::move(sections), swept.session().timeline()->takeMarks());
	};
	hand(swept.takeSections()); // the sections of reading and building
	for (std::size_t plane = 0; plane < swept.planes(); ++plane)
	{
		progress.say(remaining.line());
		if (Status measured = swept.measure(plane); !measured)
			return measured.error();
		std::vector<Timeline::Section> sections = swept.takeSections();
		log.add(swept.made().slice, swept.made().sheets, sections);
		hand(std::move(sections));
		remaining.done();
	}
	return log;
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
		if (Status written = commitTrace(profile.session, *trace); !written)
			return written;
	if (!options.append.empty())
		if (Status appended = appendRun(options.append, options.label, document); !appended)
			return appended;
	return saveSpec(options.common);
}

Result<ExitCode> runProfile(ProfileOptions& options, const CLI::App& command)
{
	if (!options.compare.empty())
		return runCompare(options, command);
	if (!options.history.empty())
		return runHistory(options, command);
	if (Status taken = options.with.empty() ? Nothing{} : takeOptions(options, options.with); !taken)
		return taken.error();
	if (Status ready = prepare(options.common); !ready)
		return ready.error();
	if (options.common.explain)
		return explain(options.common.spec, {});
	if (Status fits = checkProfileOptions(options, command); !fits)
		return fits.error();
	if (options.inTurns())
		return runTurns(options);
	if (options.turns_pipe)
	{
		const Status answered = answerPlanes(options);
		return answered ? Result<ExitCode>(ExitCode::done) : answered.error();
	}
	Result<std::optional<write::TraceFile>> trace = openTrace(options.trace);
	if (!trace)
		return trace.error();
	// The stages of several processes come from different machines.
	const bool tells_floor = !options.no_floor && !processes().team();
	gpu::keepPipelineFigures(tells_floor);
	Result<SweptProbe> swept = SweptProbe::open(options);
	if (!swept)
		return swept.error();
	StageWork work;
	DeviceWork device_work;
	const Result<ProfileLog> log = measure(*swept, *trace);
	if (!log)
		return log.error();
	Profile profile{swept->session(), *log, options.path, swept->picture()};
	if (Status counted = tells_floor ? countUse(*swept, work) : Nothing{}; !counted)
		return counted.error();
	if (Status counted = tells_floor ? countTouched(*swept, work) : Nothing{}; !counted)
		return counted.error();
	const bool has_device = swept->session().device() != nullptr;
	if (Status counted = tells_floor && has_device ? countShaders(*swept, device_work) : Nothing{}; !counted)
		return counted.error();
	const Result<Floor> floor = tells_floor ? measureFloor(swept->session().device().get()) : Floor();
	if (!floor)
		return floor.error();
	if (tells_floor)
	{
		profile.work = &work;
		profile.device_work = has_device ? &device_work : nullptr;
		profile.floor = &*floor;
	}
	if (Status reported = report(options, profile, *trace); !reported)
		return reported.error();
	return ExitCode::done;
}

void addHistoryOptions(CLI::App& command, ProfileOptions& options)
{
	const char* group = "History";
	command.add_option("--append", options.append, "Add the times of this run to a file of runs")
	    ->type_name("FILE.jsonl")
	    ->group(group);
	command
	    .add_option("--label", options.label,
	                "Name of this run in the file, such as a version; runs without one go by their date")
	    ->type_name("TEXT")
	    ->group(group);
	command
	    .add_option("--history", options.history, "Measure nothing, and draw the runs of a file and where they changed")
	    ->type_name("FILE.jsonl")
	    ->group(group);
	command.add_option("-o,--output", options.output, "The picture of --history")->type_name("FILE.svg")->group(group);
}

void addTurnsOptions(CLI::App& command, ProfileOptions& options)
{
	const char* group = "In turns";
	command
	    .add_option("--versus", options.versus,
	                "Measure another setting in turns with this one: options in quotes, which take precedence. Give it "
	                "again for several")
	    ->type_name("'OPTIONS'")
	    ->expected(1)
	    ->take_all()
	    ->group(group);
	command
	    .add_option("--versus-program", options.versus_program,
	                "Measure another build of vprobe in turns with this one, with the same options")
	    ->type_name("PROGRAM")
	    ->expected(1)
	    ->take_all()
	    ->group(group);
	command.add_option("--rounds", options.rounds, "Measure at most so many rounds")
	    ->capture_default_str()
	    ->type_name("N")
	    ->group(group);
	command
	    .add_option(
	        "--at-most", options.at_most,
	        "End with exit code 6 if a stage (default: frame) takes more than so many times as long as with the "
	        "first setting, and the interval leaves no doubt")
	    ->type_name("[STAGE=]RATIO")
	    ->expected(1)
	    ->take_all()
	    ->group(group);
	// These two are for the programs that --versus starts.
	command.add_option("--with", options.with)->group("");
	command.add_flag("--turns-pipe", options.turns_pipe)->group("");
}

} // namespace

void addProfile(CLI::App& program, Run& run)
{
	auto options = std::make_shared<ProfileOptions>();
	CLI::App* command = program.add_subcommand(
	    "profile", "Measure a sweep of a probe through an input: times of every stage, work, memory; compare settings "
	               "and builds");
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
	    ->add_flag("--no-floor", options->no_floor,
	               "Do not measure what this machine can do, and what the stages use besides time")
	    ->group(group);
	command
	    ->add_option("--compare", options->compare,
	                 "Measure nothing, and print what changed between two files that --json wrote")
	    ->expected(2)
	    ->allow_extra_args(false)
	    ->type_name("A.json B.json")
	    ->group(group);
	addTurnsOptions(*command, *options);
	addHistoryOptions(*command, *options);
	command->callback([&run, options, command]
	                  { run = [options, command] { return runProfile(*options, *command); }; });
}

} // namespace vp::app
