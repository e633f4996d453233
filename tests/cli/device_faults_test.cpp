// A device that fails, at any call that may fail: one line and the right exit code, or all that was asked for.
#include "faulty_device.h"
#include "program.h"

#include <algorithm>
#include <ostream>

namespace cli
{

namespace
{

struct Task
{
	std::string name;
	Arguments arguments;
	std::string output; // output of a run without faults

	friend void PrintTo(const Task& task, std::ostream* to) { *to << task.name; }
};

const Task kPicture{"picture", {"render", "demo:blob:8", "--size", "320x240", "-o"}, "picture.png"};
const Task kSurfaces{
    "surfaces",
    {"render", "demo:shell:8", "--context", "boundary:0.3", "--vectors", "lines", "--size", "320x240", "-o"},
    "picture.png"};
const Task kCut{"cut", {"slice", "demo:shell:8", "--classify", "gpu", "-o"}, "cut.vtp"};
const Task kSweep{
    "sweep",
    {"sweep", "demo:blob:8", "--frames", "3", "--classify", "gpu", "--samples", "1", "--size", "320x240", "-o"},
    "frame{frame:02}.png"};

using Fault = std::pair<Task, std::string>;

class FaultyDevice : public Drawing, public testing::WithParamInterface<Fault>
{
protected:
	Outcome runWith(const std::string& fault) const
	{
		const auto& task = GetParam().first;
		const auto environment = vp::layer::faultyDevice(fault, path("calls"));
		return run(task.arguments + Arguments{path(task.output)}, {.environment = environment});
	}
	std::size_t calls() const { return std::stoul(contents(path("calls"))); }
	std::vector<std::string> outputs() const
	{
		std::vector<std::string> names = files();
		std::erase(names, "calls");
		return names;
	}
	void removeOutputs() const
	{
		for (const std::string& name : outputs())
			std::filesystem::remove(path(name));
	}
};

bool isOneLine(const std::string& text)
{
	return std::ranges::count(text, '\n') == 1 && text.ends_with('\n');
}

} // namespace

TEST_P(FaultyDevice, EndsInOneLineOrWithAll)
{
	const std::string kind = GetParam().second;
	ASSERT_EQ(runWith(kind + ":1000000000").status, 0);
	const std::vector<std::string> all = outputs();
	const std::size_t count = calls();
	ASSERT_GT(count, 20u);
#ifdef VPROBE_EVERY_FAULT
	const std::size_t step = 1;
#else
	const std::size_t step = count / 9;
#endif
	std::size_t failed = 0;
	for (std::size_t n = 1; n <= count; n += step)
	{
		SCOPED_TRACE(kind + ":" + std::to_string(n));
		removeOutputs();
		const Outcome outcome = runWith(kind + ":" + std::to_string(n));
		const int expected = kind == "lost" ? 3 : 4;
		// Opening a device that has no memory left is a device that cannot be used.
		EXPECT_TRUE(outcome.status == 0 || outcome.status == expected || (n < 5 && outcome.status == 3))
		    << outcome.status << outcome.err;
		if (outcome.status == 0)
		{
			EXPECT_EQ(outputs(), all);
			continue;
		}
		++failed;
		EXPECT_TRUE(isOneLine(outcome.err)) << outcome.err;
		// A sweep keeps the frames that it has finished.
		if (all.size() == 1)
		{
			EXPECT_EQ(outputs(), std::vector<std::string>());
		}
		for (const std::string& name : outputs())
			EXPECT_TRUE(std::ranges::find(all, name) != all.end()) << name;
	}
	EXPECT_GT(failed, 0u);
}

INSTANTIATE_TEST_SUITE_P(, FaultyDevice,
                         testing::Values(Fault{kPicture, "host"}, Fault{kPicture, "device"}, Fault{kPicture, "lost"},
                                         Fault{kSurfaces, "device"}, Fault{kSurfaces, "lost"}, Fault{kCut, "host"},
                                         Fault{kCut, "lost"}, Fault{kSweep, "device"}, Fault{kSweep, "lost"}),
                         [](const auto& info) { return info.param.first.name + "_" + info.param.second; });

} // namespace cli
