// Damages data files and runs vprobe on them: whatever a file holds, the program must neither crash nor hang nor show
// what is no number. A case follows from the seed and its number alone.
#include "corpus.h"
#include "damage.h"
#include "judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <mutex>
#include <optional>
#include <thread>

#include <sys/resource.h>
#include <unistd.h>

namespace
{

namespace fs = std::filesystem;
using namespace fuzz;

// Memory limit that docs/FORMATS.md promises for small files. It is far more than any file has taken.
constexpr std::uint64_t kBaseMemory = std::uint64_t(2) << 30;
constexpr std::uint64_t kMemoryPerByte = 1032;
// A reader is ended after 15 s, and 1 s for each 4 MiB; cutting and checking take as long for each.
constexpr std::chrono::seconds kTimeLimit{20};
constexpr std::uint64_t kBytesPerSecond = 2u << 20;
// Larger data sets take seconds a case.
constexpr std::uint64_t kMaxBytes = 1u << 20;
constexpr std::uint64_t kMaxBytesLong = 30u << 20;

std::chrono::seconds timeLimitOf(const DataSet& set)
{
	return kTimeLimit + std::chrono::seconds(set.bytes / kBytesPerSecond);
}

struct Options
{
	std::uint64_t seed = 1;
	std::size_t cases = 80;
	std::optional<std::size_t> only_case;
	std::string only_set; // part of its name
	std::string program = VPROBE_PROGRAM;
	bool is_long = false;
	bool keep = false;
	unsigned jobs = 2;
};

struct Tally
{
	std::mutex mutex;
	std::size_t cases = 0;
	std::size_t done = 0; // read all the same
	std::size_t failed = 0;
	double slowest = 0.0;
	std::size_t slowest_case = 0;
	std::uint64_t peak_bytes = 0;
	std::size_t largest_case = 0;
};

class TemporaryPlace
{
public:
	TemporaryPlace()
	{
		std::string name = (fs::temp_directory_path() / "vprobe-fuzz-XXXXXX").string();
		if (!mkdtemp(name.data()))
			throw std::runtime_error("no temporary folder " + name);
		path_ = name;
	}
	~TemporaryPlace()
	{
		std::error_code ignored;
		fs::remove_all(path_, ignored);
	}
	TemporaryPlace(const TemporaryPlace&) = delete;
	TemporaryPlace& operator=(const TemporaryPlace&) = delete;
	const fs::path& path() const { return path_; }

private:
	fs::path path_;
};

// The set as it is, by links, but for one file.
std::string makeDamagedCopy(const DataSet& set, const fs::path& folder, const fs::path& input, Random& random)
{
	// The file that is opened says what the others hold.
	const bool takes_input = random.oneIn(2) && fs::is_regular_file(set.folder / input);
	const fs::path& victim = takes_input ? input : set.files[random.below(set.files.size())];
	std::string contents = contentsOf((set.folder / victim).string());
	const std::string what = damage(contents, random);
	for (const fs::path& file : set.files)
	{
		fs::create_directories((folder / file).parent_path());
		if (file != victim)
			fs::create_symlink(set.folder / file, folder / file);
	}
	std::ofstream(folder / victim, std::ios::binary) << contents;
	return victim.string() + ": " + what;
}

// memory: for parts of arrays. With little of it, arrays stay in the file where they can.
std::vector<std::string> commandLine(const std::string& program, Command command, const std::string& file,
                                     const fs::path& out, const std::string& memory = "1G")
{
	switch (command)
	{
	case Command::info:
		return {program, "info", file, "--json"};
	case Command::check:
		return {program, "check", file, "--classify", "cpu", "--json"};
	default:
		return {program,
		        "slice",
		        file,
		        "--classify",
		        "cpu",
		        "--normal",
		        "0.3",
		        "0.5",
		        "0.81",
		        "--memory",
		        memory,
		        "-o",
		        (out / "cut.vtp").string(),
		        "--stats",
		        (out / "stats.json").string()};
	}
}

// Where a damaged file is left on a failure, and where a case runs.
fs::path placeOf(const Options& options, std::size_t number)
{
	return fs::temp_directory_path() / fmt::format("vprobe-fuzz-{}-{}-{}", options.seed, number, getpid());
}

void report(const Options& options, std::size_t number, const std::string& wrong, const std::string& damaged,
            const std::vector<std::string>& command, const ProgramRun& run)
{
	const char* data = std::getenv("VPROBE_DATA");
	std::string line;
	for (const std::string& word : command)
		line += word + " ";
	fmt::print(
	    "FAILED case {}: {}\n  damaged {}\n  kept as {}\n  {}\n  again: {}{} --seed {} --case {}{}\n  said: {}\n",
	    number, wrong, damaged, placeOf(options, number).string(), line,
	    data ? fmt::format("VPROBE_DATA={} ", data) : "", "fuzz_files", options.seed, number,
	    options.is_long ? " --long" : "", run.err.substr(0, 600));
	std::fflush(stdout);
}

void runCase(const Options& options, const std::vector<DataSet>& sets, std::size_t number, Tally& tally)
{
	Random random(options.seed, number);
	const DataSet& set = sets[number % sets.size()];
	if (set.name.find(options.only_set) == std::string::npos)
		return;
	const fs::path place = placeOf(options, number);
	for (const char* folder : {"in", "out", "said"})
		fs::create_directories(place / folder);
	const fs::path& input = set.inputs[random.below(set.inputs.size())];
	const std::string damaged = makeDamagedCopy(set, place / "in", input, random);
	const Command command = random.oneIn(4) ? (random.oneIn(2) ? Command::info : Command::check) : Command::slice;
	const std::string file = (place / "in" / input).string();
	const auto line = commandLine(options.program, command, file, place / "out", random.oneIn(2) ? "16" : "1G");
	const ProgramRun run = runProgram(line, (place / "said").string(), timeLimitOf(set));
	const std::string wrong = judge(command, run, file, place / "out", kBaseMemory + kMemoryPerByte * set.bytes);

	const std::lock_guard lock(tally.mutex);
	++tally.cases;
	tally.done += run.exit_code != 2;
	tally.failed += !wrong.empty();
	if (run.seconds > tally.slowest)
		tally.slowest = run.seconds, tally.slowest_case = number;
	if (run.peak_bytes > tally.peak_bytes)
		tally.peak_bytes = run.peak_bytes, tally.largest_case = number;
	if (!wrong.empty())
		report(options, number, wrong, damaged, line, run);
	else if (options.keep)
		fmt::print("case {}: exit code {} in {:.2f} s, {} MiB; damaged {}; in {}\n  {}", number, run.exit_code,
		           run.seconds, run.peak_bytes >> 20, damaged, place.string(), run.err);
	if (wrong.empty() && !options.keep)
		fs::remove_all(place);
}

// Undamaged, every set must be read; otherwise the damage would show nothing.
std::size_t countUnreadable(const Options& options, const std::vector<DataSet>& sets, const fs::path& place)
{
	std::size_t unreadable = 0;
	for (const DataSet& set : sets)
		for (const fs::path& input : set.inputs)
		{
			const auto line = commandLine(options.program, Command::info, (set.folder / input).string(), place);
			const ProgramRun run = runProgram(line, place.string(), timeLimitOf(set));
			unreadable += run.exit_code != 0;
			if (run.exit_code != 0)
				fmt::print("FAILED: {} is not read undamaged: {}", set.name, run.err);
		}
	return unreadable;
}

int runAll(const Options& options)
{
	const TemporaryPlace place;
	std::vector<DataSet> sets = writeSamples(place.path() / "samples", options.is_long);
	if (options.only_case && options.keep)
		fmt::print("{} sets\n", sets.size());
	Tally tally;
	tally.failed = countUnreadable(options, sets, place.path());
	if (const char* data = std::getenv("VPROBE_DATA"))
		for (DataSet& set : findRealSets(data, options.is_long ? kMaxBytesLong : kMaxBytes))
			sets.push_back(std::move(set));

	const std::size_t first = options.only_case.value_or(0);
	const std::size_t end = options.only_case ? first + 1 : options.cases;
	std::atomic<std::size_t> next = first;
	std::vector<std::jthread> workers;
	for (unsigned w = 0; w < options.jobs; ++w)
		workers.emplace_back(
		    [&]
		    {
			    for (std::size_t number = next++; number < end; number = next++)
				    runCase(options, sets, number, tally);
		    });
	workers.clear();
	fmt::print(
	    "{} cases of {} data sets: {} read all the same, {} failed; slowest {:.1f} s (case {}), most memory {} MiB "
	    "(case {})\n",
	    tally.cases, sets.size(), tally.done, tally.failed, tally.slowest, tally.slowest_case, tally.peak_bytes >> 20,
	    tally.largest_case);
	std::fflush(stdout);
	return tally.failed > 0;
}

bool parse(int argc, char** argv, Options& options)
{
	std::map<std::string, std::uint64_t*> numbers;
	std::uint64_t seed = options.seed, cases = 0, only = ~std::uint64_t(0), jobs = options.jobs;
	numbers = {{"--seed", &seed}, {"--cases", &cases}, {"--case", &only}, {"--jobs", &jobs}};
	for (int i = 1; i < argc; ++i)
	{
		const std::string word = argv[i];
		if (word == "--long" || word == "--keep")
			(word == "--long" ? options.is_long : options.keep) = true;
		else if ((word == "--only" || word == "--program") && i + 1 < argc)
			(word == "--only" ? options.only_set : options.program) = argv[++i];
		else if (const auto number = numbers.find(word); number != numbers.end() && i + 1 < argc)
		{
			const std::string_view text = argv[++i];
			if (std::from_chars(text.data(), text.data() + text.size(), *number->second).ec != std::errc())
				return false;
		}
		else
			return false;
	}
	options.seed = seed;
	options.cases = cases ? cases : options.is_long ? 10000 : 80;
	options.jobs = static_cast<unsigned>(std::clamp<std::uint64_t>(jobs, 1, 64));
	if (only != ~std::uint64_t(0))
		options.only_case = only;
	return true;
}

} // namespace

int main(int argc, char** argv)
{
	Options options;
	if (!parse(argc, argv, options))
	{
		fmt::print(stderr,
		           "usage: fuzz_files [--seed S] [--cases N | --case NUMBER] [--long] [--only PART-OF-A-SET'S-NAME] "
		           "[--jobs N] [--keep] [--program VPROBE]\n");
		return 1;
	}
	const rlimit none = {0, 0};
	setrlimit(RLIMIT_CORE, &none);
	// A sanitizer's build cannot limit the reader's address space.
	setenv("ASAN_OPTIONS", "max_allocation_size_mb=3072:allocator_may_return_null=1", 0);
	return runAll(options);
}
