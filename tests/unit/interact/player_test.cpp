#include "interact/player.h"

#include <gtest/gtest.h>

#include <vector>

namespace vp::interact
{

namespace
{

std::vector<int> framesFrom(const Player& player, double start, double step, int count)
{
	std::vector<int> frames;
	for (int i = 0; i < count; ++i)
		frames.push_back(player.frameAt(start + i * step));
	return frames;
}

using Frames = std::vector<int>;

} // namespace

TEST(Player, PlaysInALoopFromTheTimeItIsTold)
{
	Player player(4, 10.0);
	EXPECT_FALSE(player.playing(0.0));
	EXPECT_EQ(player.frameAt(77.0), 0);
	player.play(100.0);
	EXPECT_EQ(framesFrom(player, 100.0, 0.1, 9), (Frames{0, 1, 2, 3, 0, 1, 2, 3, 0}));
	EXPECT_EQ(framesFrom(player, 100.05, 0.1, 5), (Frames{0, 1, 2, 3, 0}));
	EXPECT_EQ(player.frameAt(100.0 + 4e6 * 0.1 + 0.25), 2); // frames are left out
	player.pause(100.25);
	EXPECT_EQ(player.frameAt(500.0), 2);
	player.toggle(600.0);
	EXPECT_EQ(framesFrom(player, 600.0, 0.1, 3), (Frames{2, 3, 0}));
	player.toggle(600.1);
	EXPECT_FALSE(player.playing(600.2));
}

TEST(Player, ThereAndBackTellsTheEndsOnce)
{
	Player player(4, 1.0);
	player.setThereAndBack(true, 0.0);
	player.play(0.0);
	EXPECT_EQ(framesFrom(player, 0.0, 1.0, 10), (Frames{0, 1, 2, 3, 2, 1, 0, 1, 2, 3}));
	// Switched off on the way back it goes on from the frame there is, forward.
	player.setThereAndBack(false, 4.0);
	EXPECT_EQ(framesFrom(player, 4.0, 1.0, 4), (Frames{2, 3, 0, 1}));
	EXPECT_TRUE(player.playing(4.0));
}

TEST(Player, WithoutALoopItStopsAtTheEndAndBeginsAnew)
{
	Player player(3, 1.0);
	player.setLoops(false, 0.0);
	player.play(0.0);
	EXPECT_EQ(framesFrom(player, 0.0, 1.0, 6), (Frames{0, 1, 2, 2, 2, 2}));
	EXPECT_TRUE(player.playing(1.5));
	EXPECT_FALSE(player.playing(2.0));
	player.play(9.0);
	EXPECT_EQ(framesFrom(player, 9.0, 1.0, 3), (Frames{0, 1, 2}));
	player.setThereAndBack(true, 20.0);
	player.seek(0, 20.0);
	player.play(20.0);
	EXPECT_EQ(framesFrom(player, 20.0, 1.0, 7), (Frames{0, 1, 2, 1, 0, 0, 0}));
	EXPECT_FALSE(player.playing(24.5));
}

TEST(Player, ChangesGoOnFromTheFrameThereIs)
{
	Player player(100, 10.0);
	player.play(0.0);
	player.setSpeed(20.0, 1.05); // in the middle of frame 10
	EXPECT_EQ(player.frameAt(1.06), 10);
	EXPECT_EQ(player.frameAt(1.08), 11);
	EXPECT_EQ(player.frameAt(2.08), 31);
	player.setFrames(20, 2.08);
	EXPECT_EQ(player.frameAt(2.08), 19);
	EXPECT_TRUE(player.playing(2.08));
	EXPECT_EQ(player.frameAt(2.14), 0);
	player.setSpeed(1e9, 3.0);
	EXPECT_EQ(player.speed(), kMaxSpeed);
	player.setSpeed(0.0, 3.0);
	EXPECT_EQ(player.speed(), kMinSpeed);
}

TEST(Player, SeeksAndStepsAndPausesThere)
{
	Player player(5, 10.0);
	player.play(0.0);
	player.seek(3, 0.5);
	EXPECT_FALSE(player.playing(1.0));
	EXPECT_EQ(player.frameAt(1.0), 3);
	player.step(1, 1.0);
	player.step(1, 1.0);
	EXPECT_EQ(player.frameAt(1.0), 0);
	player.step(-2, 1.0);
	EXPECT_EQ(player.frameAt(1.0), 3);
	player.setLoops(false, 1.0);
	player.step(7, 1.0);
	EXPECT_EQ(player.frameAt(1.0), 4);
	player.seek(-3, 1.0);
	EXPECT_EQ(player.frameAt(1.0), 0);
}

TEST(Player, EveryFrameWaitsUntilTheLastWasShown)
{
	Player player(5, 10.0);
	player.setPace(Pace::every_frame, 0.0);
	player.play(0.0);
	EXPECT_EQ(player.frameAt(0.05), 0);
	EXPECT_EQ(framesFrom(player, 0.1, 3.0, 4), (Frames{1, 1, 1, 1}));
	// A slow machine: each picture takes a second, none is left out.
	Frames shown;
	for (int i = 0; i < 7; ++i)
	{
		shown.push_back(player.frameAt(1.0 + i));
		player.shown(1.0 + i);
	}
	EXPECT_EQ(shown, (Frames{1, 2, 3, 4, 0, 1, 2}));
	// A fast one does not go before its time.
	int changes = 0;
	for (int i = 1, last = player.frameAt(7.0); i <= 1000; ++i)
	{
		const int frame = player.frameAt(7.0 + 0.001 * i);
		player.shown(7.0 + 0.001 * i);
		changes += frame != last;
		last = frame;
	}
	EXPECT_EQ(changes, 10);
}

TEST(Player, OneFrameIsNoFilm)
{
	Player player(1);
	player.play(0.0);
	EXPECT_FALSE(player.playing(0.5));
	player.setThereAndBack(true, 1.0);
	player.step(1, 1.0);
	EXPECT_EQ(player.frameAt(9.0), 0);
}

} // namespace vp::interact
