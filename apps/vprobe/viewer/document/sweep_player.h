#pragma once

#include "interact/player.h"
#include "probe/transform.h"
#include "viewer/cutting/dataset_info.h"
#include "viewer/cutting/spec_edits.h"

#include <optional>
#include <vector>

namespace vp::app
{

// Follows the probe's path as a window plays it: it finds the state for each frame. Only the window's thread uses it.
class SweepPlayer
{
public:
	static constexpr int kFrames = 100; // number of frames if the path does not say it

	// Takes the path and its starting place from the state, unless this sweep has made the state. Returns an error if
	// the probe cannot follow the path.
	Status follow(const view::ViewSpec& state, const DatasetInfo& facts, double now);
	// Returns the state in a frame.
	view::ViewSpec at(int frame, const view::ViewSpec& state);

	interact::Player player{1};

private:
	bool isPlaced(const view::ViewSpec& state) const;

	bool over_times_ = false;
	std::vector<probe::Frame> poses_;
	std::optional<view::ViewSpec> start_;
	std::optional<view::ViewSpec> placed_; // made by the last at(); set if start_ is set
	Box bounds_;
};

} // namespace vp::app
