#pragma once

#include "mfix_restart.h"
#include "vprobe-read/base/mapped_text.h"

#include <deque>
#include <string>
#include <vector>

namespace vp::reader::codes
{

// A variable of MFIX: some of those in a file make one with components.
struct MfixVariable
{
	std::string name;
	std::vector<std::size_t> parts; // places among the variables of its file
};

// The file of some variables at some times: case.SP1, case.SP2 and so on, 9, A, B.
class MfixValues
{
public:
	// Reads a file that is there. `parts`: the number of its variables.
	MfixValues(const std::string& path, std::size_t parts, std::vector<MfixVariable> variables,
	           const MfixRestart& mesh);

	const std::vector<MfixVariable>& variables() const { return variables_; }
	const std::vector<double>& times() const { return times_; }
	// The last step of the greatest time that is not after `time`, or else of the least time: a run that was started
	// again may have written a time twice, or gone back.
	std::size_t stepAt(double time) const;
	// Returns the values of all cells, with the ghosts.
	std::vector<float> values(std::size_t part, std::size_t step) const;

private:
	MappedText file_;
	std::size_t parts_;
	std::size_t cells_;
	std::size_t records_; // those of a variable
	std::vector<MfixVariable> variables_;
	std::vector<double> times_;
};

// The files that lie beside a restart file. `empty`: the endings of those that hold no time.
std::deque<MfixValues> mfixValuesBeside(const std::string& restart, const MfixRestart& mesh,
                                        std::vector<std::string>& empty);

} // namespace vp::reader::codes
