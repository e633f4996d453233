#include "interact/player.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace vp::interact
{

namespace
{

// Times come in as sums of frame lengths; so much before it a frame is due.
constexpr double kEarly = 1e-6;

} // namespace

Player::Player(int frames, double speed) : frames_(frames), speed_(std::clamp(speed, kMinSpeed, kMaxSpeed))
{
	assert(frames >= 1);
}

int Player::cycle() const
{
	return there_and_back_ && frames_ > 1 ? 2 * frames_ - 2 : frames_;
}

double Player::placeAt(double now) const
{
	if (!playing_)
		return place_;
	double way = std::max(0.0, now - since_) * speed_;
	if (pace_ == Pace::every_frame)
		way = std::min(way, 1.0);
	const double place = place_ + way + kEarly;
	if (loops_)
		return std::fmod(place, cycle());
	// There and back it ends where it began.
	return std::min<double>(place, there_and_back_ && frames_ > 1 ? cycle() : frames_ - 1);
}

int Player::frameOf(double place) const
{
	const int at = static_cast<int>(place) % cycle();
	return at < frames_ ? at : cycle() - at;
}

int Player::frameAt(double now) const
{
	return frameOf(placeAt(now));
}

bool Player::playing(double now) const
{
	if (!playing_)
		return false;
	const double end = there_and_back_ && frames_ > 1 ? cycle() : frames_ - 1;
	return loops_ ? frames_ > 1 : placeAt(now) < end;
}

void Player::restart(double now)
{
	playing_ = playing(now);
	place_ = placeAt(now);
	since_ = now;
}

void Player::shown(double now)
{
	if (pace_ != Pace::every_frame || !playing_ || frameAt(now) == frameOf(place_))
		return;
	// The time that a frame came late is not made up for; it has begun now.
	place_ = std::floor(placeAt(now));
	since_ = now;
}

void Player::play(double now)
{
	if (playing(now))
		return;
	const double end = there_and_back_ && frames_ > 1 ? cycle() : frames_ - 1;
	place_ = !loops_ && placeAt(now) >= end ? 0.0 : std::floor(placeAt(now));
	since_ = now;
	playing_ = true;
}

void Player::pause(double now)
{
	place_ = std::floor(placeAt(now));
	since_ = now;
	playing_ = false;
}

void Player::toggle(double now)
{
	if (playing(now))
		pause(now);
	else
		play(now);
}

void Player::seek(int frame, double now)
{
	place_ = std::clamp(frame, 0, frames_ - 1);
	since_ = now;
	playing_ = false;
}

void Player::step(int by, double now)
{
	const int frame = frameAt(now) + by;
	seek(loops_ ? ((frame % frames_) + frames_) % frames_ : frame, now);
}

void Player::setFrames(int frames, double now)
{
	assert(frames >= 1);
	const bool was_playing = playing(now);
	const int frame = frameAt(now);
	frames_ = frames;
	seek(frame, now);
	playing_ = was_playing;
}

void Player::setSpeed(double speed, double now)
{
	restart(now);
	speed_ = std::clamp(speed, kMinSpeed, kMaxSpeed);
}

void Player::setLoops(bool loops, double now)
{
	restart(now);
	loops_ = loops;
}

void Player::setThereAndBack(bool there_and_back, double now)
{
	const bool was_playing = playing(now);
	const int frame = frameAt(now);
	there_and_back_ = there_and_back;
	seek(frame, now);
	playing_ = was_playing;
}

void Player::setPace(Pace pace, double now)
{
	restart(now);
	pace_ = pace;
}

} // namespace vp::interact
