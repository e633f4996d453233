// A device that fails while the window is open: the window stays, and so does what was set in it.
#include "desktop.h"
#include "faulty_device.h"

#include <cstdlib>

namespace view
{

namespace
{

class WindowOnAFaultyDevice : public Desktop, public testing::WithParamInterface<std::string>
{
protected:
	~WindowOnAFaultyDevice() override
	{
		for (const auto& [name, value] : vp::layer::faultyDevice({}, {}))
			unsetenv(name.c_str());
	}
	void failAt(const std::string& fault) const
	{
		for (const auto& [name, value] : vp::layer::faultyDevice(fault, path("calls")))
			setenv(name.c_str(), value.c_str(), 1);
	}
};

} // namespace

TEST_P(WindowOnAFaultyDevice, Stays)
{
	failAt(GetParam());
	open({"demo:shell:16"});
	act("preset_trihedral");
	settle();
	act("preset_paddlewheel");
	act("undo");
	settle();
	act("bands");
	const nlohmann::json set = settle();
	EXPECT_EQ(set["probe"]["probe"], "trihedral") << set.dump(1);
	// A step from before can still be undone.
	act("undo");
	act("undo");
	EXPECT_EQ(settle()["probe"]["probe"], "single");
	command("screenshot " + path("window.png"));
	EXPECT_TRUE(eventually([&] { return cli::sizeOf(cli::contents(path("window.png"))).width > 0; }));
	close(err());
	EXPECT_EQ(err().find("what was set is kept"), std::string::npos) << err();
	// The fault was met.
	EXPECT_GE(std::stoull(cli::contents(path("calls"))), std::stoull(GetParam().substr(GetParam().find(':') + 1)));
}

INSTANTIATE_TEST_SUITE_P(, WindowOnAFaultyDevice,
#ifdef VPROBE_EVERY_FAULT
                         testing::ValuesIn(
                             []
                             {
	                             std::vector<std::string> faults;
	                             for (int n = 176; n < 876; n += 7) // the window is open
		                             for (const char* kind : {"host:", "device:", "lost:"})
			                             faults.push_back(kind + std::to_string(n));
	                             for (int n = 2; n < 80; n += 3)
		                             for (const char* kind : {"surface:", "date:"})
			                             faults.push_back(kind + std::to_string(n));
	                             for (int n = 2; n < 40; n += 3) // presenting is never late
		                             faults.push_back("late:" + std::to_string(n));
	                             return faults;
                             }()),
#else
                         testing::Values("lost:60", "lost:400", "host:170", "device:270", "device:600", "surface:7", "surface:20",
                                         "date:6", "date:21", "late:6"),
#endif
                         [](const auto& info)
                         {
	                         std::string name = info.param;
	                         name[name.find(':')] = '_';
	                         return name;
                         });

} // namespace view
