#pragma once

#include <cassert>
#include <cstddef>
#include <deque>
#include <string>
#include <utility>

namespace vp::interact
{

constexpr std::size_t kMaxSteps = 500;

// A state and the steps that led to it, to be undone and done again. What lies more than kMaxSteps back is forgotten.
// State: a value with ==.
template <class State>
class History
{
public:
	explicit History(State first) : now_(std::move(first)) {}

	const State& state() const { return now_; }

	// A step to another state, which drops what was undone; a state equal to this one is no step. label: what the user
	// did ("Move sheet"). Steps in a row with the same merge key, unless empty, are one until endMerge(): those of a
	// drag, or of a slider. A merged step that leads back to where it began is none.
	bool commit(State state, std::string label, std::string merge_key = {})
	{
		if (merge_key != open_key_)
			endMerge();
		open_key_ = std::move(merge_key);
		if (state == now_)
			return false;
		undone_.clear();
		if (!open_step_)
			push({std::exchange(now_, std::move(state)), std::move(label)});
		else
			now_ = std::move(state);
		open_step_ = !open_key_.empty();
		if (open_step_ && done_.back().state == now_)
		{
			done_.pop_back();
			open_step_ = false; // the next of the same key begins a step again
		}
		return true;
	}

	// Another state in place of this one, without a step: for what follows from it, and is no doing of the user's.
	void amend(State state) { now_ = std::move(state); }

	// The next commit is a step of its own, whatever its key.
	void endMerge()
	{
		open_key_.clear();
		open_step_ = false;
	}

	bool canUndo() const { return !done_.empty(); }
	bool canRedo() const { return !undone_.empty(); }
	std::size_t steps() const { return done_.size(); } // number of steps that can be undone

	// Return the label of the step that undo() or redo() would take. Call them only if there is one.
	const std::string& undoLabel() const
	{
		assert(canUndo());
		return done_.back().label;
	}
	const std::string& redoLabel() const
	{
		assert(canRedo());
		return undone_.back().label;
	}

	bool undo() { return step(done_, undone_); }
	bool redo() { return step(undone_, done_); }

private:
	// A state left behind, by a step of this name.
	struct Step
	{
		State state;
		std::string label;
	};

	void push(Step step)
	{
		done_.push_back(std::move(step));
		if (done_.size() > kMaxSteps)
			done_.pop_front();
	}

	bool step(std::deque<Step>& from, std::deque<Step>& to)
	{
		endMerge();
		if (from.empty())
			return false;
		Step step = std::move(from.back());
		from.pop_back();
		to.push_back({std::exchange(now_, std::move(step.state)), std::move(step.label)});
		return true;
	}

	State now_;
	std::deque<Step> done_;
	std::deque<Step> undone_;
	std::string open_key_;
	bool open_step_ = false; // the last of done_ may be merged into
};

} // namespace vp::interact
