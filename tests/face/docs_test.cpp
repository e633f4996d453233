#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

namespace face
{

namespace
{

std::string textOf(const std::string& file)
{
	std::ostringstream text;
	text << std::ifstream(std::string(VPROBE_SOURCE_DIR) + "/" + file).rdbuf();
	return text.str();
}

} // namespace

TEST(Embedding, QuotesThePrograms)
{
	const std::string page = textOf("docs/EMBEDDING.md");
	for (const char* program : {"slice_own_grid.cpp", "draw_picture.cpp", "sweep_frames.cpp"})
	{
		const std::string source = textOf(std::string("tests/embed/") + program);
		ASSERT_FALSE(source.empty());
		EXPECT_NE(page.find("```cpp\n" + source + "```"), std::string::npos) << program;
		EXPECT_LE(std::count(source.begin(), source.end(), '\n'), 40) << program;
	}
}

} // namespace face
