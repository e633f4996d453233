#pragma once

#include "ranks/team.h"

#include <chrono>

namespace vp::app
{

// The processes that mpiexec has started. Only one object exists at a time, and only the thread that made it uses it.
class MpiTeam : public ranks::Team
{
public:
	MpiTeam(int* argc, char*** argv);
	~MpiTeam() override; // waits until all ranks end

	int rank() const override { return rank_; }
	int size() const override { return size_; }
	ranks::Bytes sendReceive(int to, const ranks::Bytes& bytes, int from) override;

	// A rank that fails calls this. It tells the ranks after it, and waits for such a message from a rank before it.
	// Returns true if no such message came, so that this rank has to print its line.
	bool failsFirst(std::chrono::milliseconds patience) const;

	// Ends all ranks at once, with an exit status.
	[[noreturn]] static void abort(int status);

private:
	int rank_ = 0;
	int size_ = 1;
};

} // namespace vp::app
