#pragma once

#include "base/result.h"

namespace vp::app
{

// The program's exit codes; scripts rely on the numbers.
enum class ExitCode
{
	done = 0,
	usage = 1,     // unknown option, a value that cannot be
	input = 2,     // input that cannot be used
	no_device = 3, // no usable Vulkan device
	output = 4,    // output that cannot be written, and everything else
	findings = 5,
	differs = 6, // not as expected
	interrupted = 130
};

constexpr ExitCode exitCodeOf(ErrorKind kind)
{
	switch (kind)
	{
	case ErrorKind::usage:
		return ExitCode::usage;
	case ErrorKind::input:
		return ExitCode::input;
	case ErrorKind::device:
		return ExitCode::no_device;
	case ErrorKind::found:
		return ExitCode::findings;
	case ErrorKind::cancelled:
		return ExitCode::interrupted;
	case ErrorKind::output:
	case ErrorKind::out_of_memory:
	case ErrorKind::internal:
		break;
	}
	return ExitCode::output;
}

} // namespace vp::app
