// A pack, of which the window reads what the sheet meets.

#include "desktop.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace view
{

namespace
{

class Packs : public Desktop
{
protected:
	const Area middle_{240, 280, 80, 60}; // within the sheet
};

} // namespace

TEST_F(Packs, LookLikeTheirInputs)
{
	const std::string pack = path("pack.vtkhdf");
	ASSERT_EQ(run({"pack", "demo:tets:8", "-o", pack, "--part", "64"}).status, 0);
	std::vector<std::vector<vp::render::Picture>> pictures;
	for (const std::string& input : {std::string("demo:tets:8"), pack})
	{
		open({input, "--normal", "0.3", "0.5", "0.8"});
		std::vector<vp::render::Picture>& seen = pictures.emplace_back();
		// Whole cells need all parts, and their neighbors.
		for (const char* line :
		     {"do push_forward", "do push_back", "set crinkle true", "do push_back", "set crinkle false"})
		{
			command(line);
			settle();
			seen.push_back(rest(middle_));
		}
		close();
		std::filesystem::remove(path("commands"));
	}
	EXPECT_GT(difference(pictures[0][1], pictures[0][2]), 0.0);
	for (std::size_t picture = 0; picture < pictures[0].size(); ++picture)
		EXPECT_EQ(difference(pictures[0][picture], pictures[1][picture]), 0.0) << picture;
}

} // namespace view
