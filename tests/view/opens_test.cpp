// A window in which one file after the other is opened takes no more memory than at first.
#include "desktop.h"
#include "sample_files.h"

#include <array>

namespace view
{

namespace
{

constexpr int kWarm = 400;
constexpr int kOpens = 2000;
constexpr std::size_t kMaxGrowth = std::size_t(12) << 20; // 7 KiB an open

class WindowThatOpensFiles : public Desktop
{
};

} // namespace

TEST_F(WindowThatOpensFiles, KeepsItsMemory)
{
	validates_ = false; // the layers keep a note of each object
	const std::array<std::string, 3> inputs{write("hexahedra.vtu", cli::xmlHexahedra()),
	                                        write("image.vti", cli::xmlImage()), "demo:blob:6"};
	open({"demo:shell:8"});
	std::size_t warm = 0;
	for (int i = 0; i < kOpens; ++i)
	{
		const std::string& input = inputs[static_cast<std::size_t>(i) % inputs.size()];
		command("open " + input);
		command("wait");
		if (i % 5 == 0)
		{
			ASSERT_EQ(settle()["input"]["files"][0], input.substr(input.rfind('/') + 1));
		}
		if (i % 100 == 0)
			std::printf("%d opens: %zu MiB\n", i, program().residentBytes() >> 20);
		if (i == kWarm)
			warm = program().residentBytes();
	}
	settle();
	const std::size_t after = program().residentBytes();
	EXPECT_LT(after, warm + kMaxGrowth) << warm << " bytes after " << kWarm << " opens, " << after << " after "
	                                    << kOpens;
	close();
}

} // namespace view
