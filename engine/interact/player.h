#pragma once

namespace vp::interact
{

enum class Pace
{
	real_time,  // frames are left out rather than that the film slows down
	every_frame // none is left out: the next one comes when the last was shown, and is due
};

constexpr double kMinSpeed = 0.1; // frames a second
constexpr double kMaxSpeed = 1000.0;

// Plays the frames 0 to frames - 1 of a sweep. It has no clock: `now` is in seconds of any clock that never goes back.
// Frames come in cycles: there and back is 0 ... N-1 ... 1, the ends told once. Without a loop the film stops at a
// cycle's end: on the last frame, there and back on the first.
class Player
{
public:
	explicit Player(int frames = 1, double speed = 30.0); // frames >= 1

	int frames() const { return frames_; }
	double speed() const { return speed_; }
	bool loops() const { return loops_; }
	bool thereAndBack() const { return there_and_back_; }
	Pace pace() const { return pace_; }

	bool playing(double now) const; // false from a film's end on
	int frameAt(double now) const;

	// That the frame of this moment is on the screen; with Pace::every_frame the next one waits for it.
	void shown(double now);

	void play(double now); // at a film's end from its beginning
	void pause(double now);
	void toggle(double now);

	// These pause: to a frame, bounded to those there are; so many frames on (negative: back), in a loop around its
	// end.
	void seek(int frame, double now);
	void step(int by, double now);

	// These go on from the frame there is.
	void setFrames(int frames, double now);
	void setSpeed(double speed, double now); // bounded
	void setLoops(bool loops, double now);
	void setThereAndBack(bool there_and_back, double now);
	void setPace(Pace pace, double now);

private:
	int cycle() const; // its length in frames
	double placeAt(double now) const;
	int frameOf(double place) const;
	void restart(double now); // from where it is

	int frames_;
	double speed_;
	bool loops_ = true;
	bool there_and_back_ = false;
	bool playing_ = false;
	Pace pace_ = Pace::real_time;
	double place_ = 0.0; // in the cycle, in frames, at `since_`
	double since_ = 0.0;
};

} // namespace vp::interact
