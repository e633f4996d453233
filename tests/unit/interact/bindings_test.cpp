#include "interact/bindings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace vp::interact
{

TEST(Bindings, NoChordTwiceAndNoActionWithout)
{
	std::set<std::string> names;
	std::set<Action> actions;
	for (const Binding& binding : bindings())
	{
		EXPECT_TRUE(names.insert(nameOf(binding.chord)).second) << nameOf(binding.chord);
		EXPECT_EQ(actionOf(binding.chord), binding.action) << nameOf(binding.chord);
		EXPECT_NE(binding.chord.key, Key::none);
		EXPECT_FALSE(binding.words.empty());
		EXPECT_EQ(wordsOf(binding.action), binding.words) << nameOf(binding.chord);
		actions.insert(binding.action);
	}
	EXPECT_EQ(actions.size(), static_cast<std::size_t>(kActions));
}

// Else the list would tell a group, or an action, twice.
TEST(Bindings, GroupsAndChordsOfAnActionStandTogether)
{
	std::set<std::string_view> groups;
	std::set<Action> actions;
	const Binding* last = nullptr;
	for (const Binding& binding : bindings())
	{
		if (!last || last->group != binding.group)
		{
			EXPECT_TRUE(groups.insert(binding.group).second) << binding.group;
		}
		if (!last || last->action != binding.action)
		{
			EXPECT_TRUE(actions.insert(binding.action).second) << binding.words;
		}
		last = &binding;
	}
}

// A letter with Shift and one without are keys of the same letter: capitals would never come from a keyboard.
TEST(Bindings, KeysArePrintedWithoutShift)
{
	for (const Binding& binding : bindings())
	{
		const auto code = static_cast<char32_t>(binding.chord.key);
		EXPECT_FALSE(code >= U'A' && code <= U'Z') << nameOf(binding.chord);
		EXPECT_TRUE(code < 0x7F || code > 0x110000) << nameOf(binding.chord);
	}
}

TEST(Bindings, NamesChords)
{
	EXPECT_EQ(nameOf(Chord{key('z'), true, true, false}), "Ctrl+Shift+Z");
	EXPECT_EQ(nameOf(Chord{Key::page_down, false, false, true}), "Alt+PageDown");
	EXPECT_EQ(nameOf(Chord{Key::remove, false, false, false}), "Delete");
	EXPECT_EQ(nameOf(Chord{Key::end, false, false, false}), "End");
	EXPECT_EQ(nameOf(Chord{Key::f11, false, false, false}), "F11");
	EXPECT_EQ(nameOf(Chord{Key::f12, false, false, false}), "F12");
	EXPECT_EQ(nameOf(Chord{Key::space, false, false, false}), "Space");
	EXPECT_EQ(keysOf(Action::save_state), "Ctrl+S");
	EXPECT_EQ(keysOf(Action::redo), "Ctrl+Shift+Z, Ctrl+Y");
}

TEST(Bindings, SignsThatNeedShiftAreKnownWithIt)
{
	EXPECT_EQ(actionOf({key('?'), false, true, false}), Action::help);
	EXPECT_EQ(actionOf({key('?'), false, false, false}), Action::help);
	EXPECT_EQ(actionOf({key('.'), false, true, false}), Action::push_forward_fine);
	EXPECT_EQ(actionOf({key('x'), false, true, false}), std::nullopt);
	EXPECT_EQ(actionOf({key('s'), true, false, true}), std::nullopt);
}

TEST(Bindings, ActionsAreKnownByName)
{
	EXPECT_EQ(actionNamed("push_forward"), Action::push_forward);
	EXPECT_EQ(actionNamed("push"), std::nullopt);
	EXPECT_EQ(actionNamed(""), std::nullopt);
	for (const Binding& binding : bindings())
		EXPECT_EQ(actionNamed(binding.name), binding.action) << binding.name;
}

TEST(Bindings, TheListIsAligned)
{
	std::istringstream text(bindingsText());
	std::string line;
	int actions = 0;
	std::size_t column = 0;
	while (std::getline(text, line))
	{
		EXPECT_FALSE(line.ends_with(' ')) << line;
		if (!line.starts_with("  "))
			continue;
		++actions;
		const std::size_t words = line.find_last_of(' ', line.find(std::string(wordsOf(bindings()[0].action))));
		if (column == 0)
			column = words;
		EXPECT_EQ(line[column], ' ') << line;
		EXPECT_NE(line[column + 1], ' ') << line;
	}
	EXPECT_EQ(actions, kActions);
}

} // namespace vp::interact
