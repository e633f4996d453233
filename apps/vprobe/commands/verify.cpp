#include "commands/commands.h"
#include "options/spec_options.h"
#include "report/console.h"
#include "report/stats_json.h"
#include "team.h"
#include "verify/junit.h"
#include "verify/report_page.h"
#include "verify/verifier.h"
#include "version.h"
#include "write/atomic_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

namespace vp::app
{

namespace
{

struct CompareOptions
{
	SpecOptions common; // only the machine
	std::vector<std::string> places;
	std::string junit;
	std::string report; // a folder
	bool updates = false;

	std::string page() const { return report.empty() ? "" : (std::filesystem::path(report) / "index.html").string(); }
};

// Prints a line about a judgment: results go to standard output, errors to standard error.
void printJudgment(const Judgment& one)
{
	if (one.verdict == Verdict::failed)
	{
		const bool names_file = one.detail.starts_with(one.file);
		return printLine(names_file ? one.detail : fmt::format("{}: {}", one.file, one.detail));
	}
	const std::string device = one.driver.empty() ? one.device : fmt::format("{}, {}", one.device, one.driver);
	print("{}  {}{}{}  [{}]\n", word(one.verdict), one.file, one.detail.empty() ? "" : "  ", one.detail, device);
}

// The first error's code goes before that of a difference. A state with impossible settings is a file that cannot be
// used.
ExitCode codeOf(const std::vector<Judgment>& judgments)
{
	ExitCode code = ExitCode::done;
	for (const Judgment& one : judgments)
	{
		if (one.error)
			return one.error->kind == ErrorKind::usage ? ExitCode::input : exitCodeOf(one.error->kind);
		if (one.verdict == Verdict::differs)
			code = ExitCode::differs;
	}
	return code;
}

void printSummary(const std::vector<Judgment>& judgments)
{
	const auto count = [&](Verdict verdict) { return std::ranges::count(judgments, verdict, &Judgment::verdict); };
	std::string line = fmt::format("{} passed", count(Verdict::passed));
	for (const auto& [verdict, what] :
	     {std::pair{Verdict::differs, "different"}, {Verdict::updated, "updated"}, {Verdict::failed, "not judged"}})
		if (count(verdict) > 0)
			line += fmt::format(", {} {}", count(verdict), what);
	print("{}; vprobe {}\n", line, kVersion);
}

Status writeWhole(const std::string& text, const std::string& file)
{
	if (file.empty())
		return Nothing{};
	Result<write::AtomicFile> out = write::AtomicFile::create(file);
	if (!out)
		return out.error();
	out->write(text);
	return out->commit();
}

Result<ExitCode> runVerify(const CompareOptions& options)
{
	if (options.common.wrong)
		return *options.common.wrong;
	for (const std::string& file : {options.junit, options.page()})
		if (Status place = checkWritable(file); !place)
			return place.error();
	std::vector<Judgment> judgments;
	Verifier verifier({.updates = options.updates, .keeps_pictures = !options.report.empty()},
	                  [&](Judgment judgment)
	                  {
		                  printJudgment(judgment);
		                  judgments.push_back(std::move(judgment));
	                  });
	verifier.judge(findCases(options.places, options.common.spec.machine, options.updates));
	printSummary(judgments);
	if (Status written = writeWhole(options.junit.empty() ? "" : junitText(judgments), options.junit); !written)
		return written.error();
	if (Status written = writeWhole(options.report.empty() ? "" : reportPage(judgments), options.page()); !written)
		return written.error();
	return codeOf(judgments);
}

} // namespace

void addVerify(CLI::App& program, Run& run)
{
	auto options = std::make_shared<CompareOptions>();
	CLI::App* command = program.add_subcommand(
	    "verify", "Compare what saved states draw with the pictures and figures that lie beside them");
	command
	    ->add_option("STATE", options->places,
	                 "A file that --save wrote, or a folder of them. Beside NAME.json lie NAME.png (as render draws "
	                 "it), NAME.flat.png (as slice -o draws it) or NAME.figures.json (some keys of slice --stats)")
	    ->required()
	    ->type_name("STATE.json|FOLDER");
	command->add_flag("--update", options->updates, "Write what is missing or not as expected, and say so");
	command->add_option("--junit", options->junit, "Write the verdicts as JUnit XML, for a CI server")
	    ->type_name("FILE.xml");
	command
	    ->add_option("--report", options->report,
	                 "Write a page index.html with expected, drawn and difference side by side")
	    ->type_name("FOLDER");
	addSettings(*command, options->common, "machine", Scope::all);
	command->footer(
	    "Exit code 6 if something differs; 2, 3 or 4 if a case could not be judged. The other cases run on.");
	command->callback([&run, options] { run = [options] { return runVerify(*options); }; });
}

} // namespace vp::app
