#include "wrapped_grids.h"

#include <gtest/gtest.h>

namespace face
{

using vprobe::ErrorKind;
using vprobe::View;

TEST(View, SettingsAreSetByKey)
{
	View view;
	for (const auto& [key, value] : std::vector<std::pair<std::string, std::string>>{{"probe", "trihedral"},
	                                                                                 {"normal", "x"},
	                                                                                 {"origin", "1 2 3"},
	                                                                                 {"camera", "30,20"},
	                                                                                 {"lines", "7"},
	                                                                                 {"mesh", "true"},
	                                                                                 {"color_by", "generation"},
	                                                                                 {"opacity", "0.5"},
	                                                                                 {"context", "boundary:0.2"},
	                                                                                 {"path", "spin"},
	                                                                                 {"classify", "cpu"}})
	{
		const auto set = view.set(key, value);
		EXPECT_TRUE(set) << set.error().message;
	}
	EXPECT_TRUE(view.check());
	View again;
	ASSERT_TRUE(again.read(view.json()));
	EXPECT_EQ(again.json(), view.json());
	EXPECT_NE(View().json(), view.json());
	View copy = view;
	copy.opacity(0.25);
	EXPECT_NE(copy.json(), view.json());
}

TEST(View, WhatCannotBeNamesTheKey)
{
	View view;
	const auto refused = [&](const char* key, const char* value, const std::string& words)
	{
		const auto set = view.set(key, value);
		ASSERT_FALSE(set) << key;
		EXPECT_EQ(set.error().kind, ErrorKind::usage);
		EXPECT_NE(set.error().message.find(words), std::string::npos) << set.error().message;
	};
	refused("color", "red", "there is no setting 'color'; there are files");
	refused("lines", "many", "`lines` many: not a number");
	refused("origin", "1 2", "`origin` 1 2: takes 3 numbers");
	refused("axes", "all", "`axes` all: takes corner, box or none");
	refused("mesh", "yes", "takes true or false");
	EXPECT_TRUE(view.check());
	EXPECT_FALSE(View().vanes(0).check());
	EXPECT_FALSE(View().window(-1.0, 1.0).check());
	EXPECT_EQ(view.read("{").error().kind, ErrorKind::input);
}

TEST(View, AnErrorOfTheDataSetNamesWhatThereIs)
{
	const Box box(3);
	const auto data = vprobe::Dataset::wrap({box.image()}, vprobe::Classify::cpu);
	ASSERT_TRUE(data);
	const auto cut = data->cut(View().array("none"));
	ASSERT_FALSE(cut);
	EXPECT_EQ(cut.error().kind, ErrorKind::input);
	EXPECT_NE(cut.error().message.find("point:value"), std::string::npos) << cut.error().message;
	const auto plan = data->plan(View());
	ASSERT_TRUE(plan);
	ASSERT_EQ(plan->size(), 1u);
	EXPECT_EQ(plan->front().strategy, "rows");
	EXPECT_EQ(plan->front().classifier, "cpu");
	EXPECT_FALSE(plan->front().reason.empty());
}

} // namespace face
