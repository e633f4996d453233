#pragma once

#include "ranks/team.h"

#include <chrono>

namespace vp::app
{

// The processes that mpiexec has started. One lives at a time; only the thread that made it uses it.
class MpiTeam : public ranks::Team
{
public:
	MpiTeam(int* argc, char*** argv);
	~MpiTeam() override; // all ranks come to their end together

	int rank() const override { return rank_; }
	int size() const override { return size_; }
	ranks::Bytes sendReceive(int to, const ranks::Bytes& bytes, int from) override;

	// For a rank that fails: says so to the ranks after it, and waits to hear it of one before it. Returns whether none
	// has failed as far as it heard, so that its own line is the one to print.
	bool failsFirst(std::chrono::milliseconds patience) const;

	// Ends all ranks at once, with an exit status.
	[[noreturn]] static void abort(int status);

private:
	int rank_ = 0;
	int size_ = 1;
};

} // namespace vp::app
