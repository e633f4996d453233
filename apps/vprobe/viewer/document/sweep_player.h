#pragma once

#include "interact/player.h"
#include "probe/transform.h"
#include "viewer/cutting/dataset_info.h"
#include "viewer/cutting/spec_edits.h"

#include <optional>
#include <vector>

namespace vp::app
{

// The probe's path, as a window plays it: which state belongs to which frame. Of the window's thread.
class SweepPlayer
{
public:
	static constexpr int kFrames = 100; // of a path that does not say how many it has

	// Takes the path and the place from which it starts, unless the state is one that this sweep has made. An error
	// where the path cannot be gone.
	Status follow(const view::ViewSpec& state, const DatasetInfo& facts, double now);
	// The state in a frame.
	view::ViewSpec at(int frame, const view::ViewSpec& state);

	interact::Player player{1};

private:
	bool isPlaced(const view::ViewSpec& state) const;

	bool over_times_ = false;
	std::vector<probe::Frame> poses_;
	std::optional<view::ViewSpec> start_;
	std::optional<view::ViewSpec> placed_; // by the last at(); there where start_ is
	Box bounds_;
};

} // namespace vp::app
