// Memory that runs out at any call of the program's own code: one line and exit code 4, or all that was asked for.
#include "faulty_memory.h"
#include "program.h"
#include "sample_files.h"

#include <algorithm>
#include <cstdlib>
#include <ostream>
#include <set>

namespace cli
{

namespace
{

struct MemoryTask
{
	std::string name;
	Arguments arguments; // FILE stands for a file to read
	std::string output;  // empty: it tells what it finds
	bool draws = false;
	// nlohmann's destructor asks for memory. Without it only std::terminate() is left, whose handler says so.
	bool has_json = false;

	friend void PrintTo(const MemoryTask& task, std::ostream* to) { *to << task.name; }
};

// A part of the calls is taken where time is short; --long takes the first call of each place in the code.
#ifdef VPROBE_EVERY_FAULT
constexpr std::size_t kMaxPlaces = 100000;
constexpr std::uint64_t kFirst = 40;
constexpr double kGrowth = 1.02;
#else
constexpr std::size_t kMaxPlaces = 4;
constexpr std::uint64_t kFirst = 3;
constexpr double kGrowth = 8.0;
#endif

const std::vector<MemoryTask> kMemoryTasks = {
    {"slice", {"slice", "demo:shell:8", "--classify", "cpu"}, "cut.vtp"},
    {"slice_file", {"slice", "FILE", "--classify", "cpu"}, "cut.ply", false, true},
    {"slice_probe", {"slice", "demo:blob:6", "--classify", "cpu", "--probe", "trihedral"}, "cut.vtm"},
    {"slice_surface", {"slice", "demo:shell:8", "--classify", "cpu", "--surface", "sphere:1.5"}, "cut.vtp"},
    {"slice_mixed", {"slice", "demo:mixed:4", "--classify", "cpu"}, "cut.vtp"},
    {"sweep", {"sweep", "demo:shell:6", "--classify", "cpu", "--frames", "3"}, "out.pvd", false, true},
    {"info", {"info", "demo:shell:6"}, "", false, true},
    {"info_file", {"info", "FILE"}, "", false, true},
    {"check_file", {"check", "FILE"}, "", false, true},
    {"convert", {"convert", "FILE", "-o"}, "converted.vtu", false, true},
    {"render", {"render", "demo:shell:6", "--size", "160x120", "--samples", "1"}, "picture.png", true},
    {"render_all",
     {"render", "demo:shell:6", "--context", "boundary:0.3", "--vectors", "lines", "--size", "160x120", "--samples",
      "1"},
     "picture.png",
     true},
    {"flat", {"slice", "demo:shell:6", "--size", "160x120"}, "picture.png", true},
    {"sweep_drawn",
     {"sweep", "demo:blob:6", "--frames", "2", "--classify", "gpu", "--samples", "1", "--size", "160x120"},
     "frame{frame:02}.png",
     true,
     true}};

class FaultyMemory : public Drawing, public testing::WithParamInterface<std::pair<std::string, MemoryTask>>
{
protected:
	FaultyMemory() : file_(write("hexahedra.vtu", xmlHexahedra())), calls_(path("calls")) {}

	void SetUp() override
	{
		if (task().draws)
			Drawing::SetUp();
	}
	const MemoryTask& task() const { return GetParam().second; }
	Outcome runWith(const std::string& number, const std::string& other_input = {}) const
	{
		std::filesystem::create_directory(path("to"));
		std::filesystem::remove(calls_); // what an earlier run has told
		Arguments arguments = task().arguments;
		if (!other_input.empty())
			arguments[1] = other_input;
		std::ranges::replace(arguments, "FILE", file_);
		if (!task().output.empty() && arguments.back() != "-o")
			arguments.push_back("-o");
		if (!task().output.empty())
			arguments.push_back(path("to/" + task().output));
		Surroundings surroundings{.environment = vp::memory::faultyMemory(GetParam().first + ":" + number, calls_)};
		surroundings.environment["VPROBE_VALIDATION"] = "0"; // its memory is not ours
		// The reader takes less than it may: then a lack of memory is the machine's and not the file's.
		surroundings.memory_limit = GetParam().first == "vprobe-read" ? 2000l << 20 : 0;
		return run(arguments, surroundings);
	}
	// All that lies in the folder of the outputs, and then empties it.
	std::map<std::string, std::string> takeOutputs() const
	{
		std::map<std::string, std::string> outputs;
		for (const auto& entry : std::filesystem::recursive_directory_iterator(path("to")))
			outputs[entry.path()] = entry.is_regular_file() ? contents(entry.path()) : "";
		std::filesystem::remove_all(path("to"));
		return outputs;
	}
	// One line and exit code 4. Command info prints line by line, and may have begun.
	static testing::AssertionResult isOutOfMemory(Outcome outcome, const Outcome& whole)
	{
		if (whole.out.starts_with(outcome.out))
			outcome.out.clear();
		return isError(outcome, 4, {"memory", ";"});
	}
	// Each output is whole or not there at all, and nothing else is. Frames of a sweep appear one by one.
	bool isNothingHalf(const std::map<std::string, std::string>& outputs,
	                   const std::map<std::string, std::string>& all) const
	{
		const bool is_one = !task().draws || task().arguments[0] != "sweep";
		return std::ranges::includes(all, outputs) && (!is_one || outputs.empty() || outputs == all);
	}
	// Checks the end of a run: as one without a fault, or in one line. Returns true for the latter.
	bool hasFailed(const Outcome& outcome, const std::map<std::string, std::string>& outputs, const Outcome& whole,
	               const std::map<std::string, std::string>& all) const
	{
		if (outcome.status == 0)
		{
			EXPECT_EQ(outcome.out, whole.out);
			EXPECT_EQ(outcome.err, whole.err);
			EXPECT_TRUE(outputs == all);
			return false;
		}
		EXPECT_TRUE(isOutOfMemory(outcome, whole));
		EXPECT_TRUE(isNothingHalf(outputs, all));
		return true;
	}
	// CLI11 has functions that may not throw but ask for memory. They are done when the program looks for its input.
	std::uint64_t callsBeforeInput() const
	{
		EXPECT_EQ(runWith("0", "demo:none").status, 2);
		return vp::memory::toldCalls(calls_)->count;
	}
	// The numbers of the calls that are let fail.
	std::set<std::uint64_t> numbers() const
	{
		const auto told = vp::memory::toldCalls(calls_);
		std::set<std::uint64_t> numbers;
		const std::size_t step = std::max<std::size_t>(1, told->places / kMaxPlaces);
		for (std::size_t i = 0; i < told->places; i += step)
			numbers.insert(told->first_calls[i]);
		for (std::uint64_t n = 1; n <= told->count;
		     n = n < kFirst ? n + 1 : static_cast<std::uint64_t>(n * kGrowth) + 1)
			numbers.insert(n);
		return numbers;
	}

	std::string file_;
	std::string calls_;
};

} // namespace

TEST_P(FaultyMemory, EndsInOneLineOrWithAll)
{
	const Outcome whole = runWith("0");
	ASSERT_EQ(whole.status, 0) << whole.err;
	const std::map<std::string, std::string> all = takeOutputs();
	const std::set<std::uint64_t> tried = numbers();
	ASSERT_GT(vp::memory::toldCalls(calls_)->count, 100u) << "the program's calls are not counted";
	const std::uint64_t before_input = callsBeforeInput();
	std::size_t failed = 0;
	for (const std::uint64_t n : tried)
	{
		SCOPED_TRACE(GetParam().first + ":" + std::to_string(n));
		const Outcome outcome = runWith(std::to_string(n));
		const std::map<std::string, std::string> outputs = takeOutputs();
		// Figures become JSON last.
		const bool may_terminate = n <= before_input || task().has_json || outputs == all;
		EXPECT_TRUE(may_terminate || !vp::memory::toldCalls(calls_)->terminated) << outcome.err;
		failed += hasFailed(outcome, outputs, whole, all);
	}
	EXPECT_GE(failed, tried.size() / 2);
}

// There is none even for the last line.
TEST_P(FaultyMemory, MayBeGoneForGood)
{
	const Outcome whole = runWith("0");
	ASSERT_EQ(whole.status, 0) << whole.err;
	const std::map<std::string, std::string> all = takeOutputs();
	const std::uint64_t count = vp::memory::toldCalls(calls_)->count;
	std::size_t tried = 0, failed = 0;
	for (std::uint64_t n = 1; n <= count;
	     n = n < kFirst ? n + 1 : static_cast<std::uint64_t>(n * (3 + kGrowth) / 4) + 1)
	{
		SCOPED_TRACE(GetParam().first + ":" + std::to_string(n) + "+");
		const Outcome outcome = runWith(std::to_string(n) + "+");
		++tried;
		failed += hasFailed(outcome, takeOutputs(), whole, all);
	}
	EXPECT_GE(failed + 2, tried); // the last calls may come when all is done
}

namespace
{

std::vector<std::pair<std::string, MemoryTask>> memoryCases(bool drawn)
{
	std::vector<std::pair<std::string, MemoryTask>> cases;
	for (const MemoryTask& task : kMemoryTasks)
	{
		if (task.draws != drawn)
			continue;
		cases.emplace_back("vprobe", task);
		if (std::ranges::find(task.arguments, "FILE") != task.arguments.end())
			cases.emplace_back("vprobe-read", task);
	}
	return cases;
}

std::string nameOfCase(const testing::TestParamInfo<std::pair<std::string, MemoryTask>>& info)
{
	return info.param.second.name + (info.param.first == "vprobe" ? "" : "_in_reader");
}

} // namespace

INSTANTIATE_TEST_SUITE_P(Cpu, FaultyMemory, testing::ValuesIn(memoryCases(false)), nameOfCase);
INSTANTIATE_TEST_SUITE_P(Drawn, FaultyMemory, testing::ValuesIn(memoryCases(true)), nameOfCase);

} // namespace cli
