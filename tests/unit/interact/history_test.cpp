#include "interact/history.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace vp::interact
{

TEST(History, UndoesAndDoesAgainByName)
{
	History<int> history(0);
	EXPECT_FALSE(history.undo());
	EXPECT_TRUE(history.commit(1, "one"));
	EXPECT_TRUE(history.commit(2, "two"));
	EXPECT_EQ(history.undoLabel(), "two");
	EXPECT_TRUE(history.undo());
	EXPECT_EQ(history.state(), 1);
	EXPECT_EQ(history.undoLabel(), "one");
	EXPECT_EQ(history.redoLabel(), "two");
	EXPECT_TRUE(history.redo());
	EXPECT_EQ(history.state(), 2);
	EXPECT_FALSE(history.redo());
	history.undo();
	EXPECT_TRUE(history.commit(3, "three"));
	EXPECT_FALSE(history.canRedo());
	EXPECT_EQ(history.steps(), 2u);
}

TEST(History, EqualStatesAreNoStepAndKeepWhatWasUndone)
{
	History<int> history(0);
	history.commit(1, "one");
	history.undo();
	EXPECT_FALSE(history.commit(0, "nothing"));
	EXPECT_TRUE(history.canRedo());
	EXPECT_EQ(history.steps(), 0u);
}

TEST(History, ADragIsOneStep)
{
	History<int> history(0);
	for (int i = 1; i <= 10; ++i)
		history.commit(i, "drag", "drag");
	EXPECT_EQ(history.steps(), 1u);
	history.endMerge();
	history.commit(20, "drag", "drag");
	EXPECT_EQ(history.steps(), 2u);
	history.commit(21, "slider", "slider");
	history.commit(22, "other");
	history.commit(23, "other");
	EXPECT_EQ(history.steps(), 5u);
	while (history.undo())
		;
	EXPECT_EQ(history.state(), 0);
}

TEST(History, ADragBackToItsStartIsNoStep)
{
	History<int> history(0);
	history.commit(1, "first");
	history.commit(2, "drag", "drag");
	history.commit(1, "drag", "drag");
	EXPECT_EQ(history.steps(), 1u);
	EXPECT_EQ(history.undoLabel(), "first");
	history.commit(3, "drag", "drag");
	history.commit(4, "drag", "drag");
	EXPECT_EQ(history.steps(), 2u);
	history.undo();
	EXPECT_EQ(history.state(), 1);
}

TEST(History, AnEqualStateOfAnotherKeyEndsAMerge)
{
	History<int> history(0);
	history.commit(1, "a", "a");
	history.commit(1, "b", "b");
	history.commit(2, "b", "b");
	EXPECT_EQ(history.steps(), 2u);
	EXPECT_EQ(history.undoLabel(), "b");
}

TEST(History, AnUndoneDragIsNotMergedInto)
{
	History<int> history(0);
	history.commit(1, "drag", "drag");
	history.undo();
	history.redo();
	history.commit(2, "drag", "drag");
	EXPECT_EQ(history.steps(), 2u);
}

TEST(History, ForgetsTheOldest)
{
	History<int> history(0);
	for (int i = 1; i <= static_cast<int>(kMaxSteps) + 7; ++i)
		history.commit(i, "step");
	EXPECT_EQ(history.steps(), kMaxSteps);
	while (history.undo())
		;
	EXPECT_EQ(history.state(), 7);
}

// Against a plain list of states and a place in it.
TEST(History, GoesAsAListOfStates)
{
	std::mt19937 random(3);
	History<int> history(0);
	std::vector<int> states{0};
	std::size_t at = 0;
	for (int i = 0; i < 5000; ++i)
	{
		switch (random() % 4)
		{
		case 0:
			EXPECT_EQ(history.undo(), at > 0);
			at -= at > 0;
			break;
		case 1:
			EXPECT_EQ(history.redo(), at + 1 < states.size());
			at += at + 1 < states.size();
			break;
		default:
			const int state = static_cast<int>(random() % 5);
			const bool differs = state != states[at];
			EXPECT_EQ(history.commit(state, std::to_string(state)), differs);
			if (differs)
			{
				states.resize(++at);
				states.push_back(state);
			}
		}
		ASSERT_EQ(history.state(), states[at]);
		if (states.size() > kMaxSteps)
			break;
	}
}

} // namespace vp::interact
