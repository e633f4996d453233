#pragma once

#include "base/result.h"
#include "verify/figures.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vp::app
{

enum class Verdict : std::uint8_t
{
	passed,
	differs,
	updated, // the file was written
	failed   // it could not be judged
};

// The verdict about one file, or about a state that could not be cut.
struct Judgment
{
	std::string file; // with the expected picture or figures
	Verdict verdict = Verdict::passed;
	std::string detail;           // a line: how far it is from the expected one, or the error
	std::optional<Error> error{}; // if it could not be judged
	std::string device{};         // "cpu" if none took part
	std::string driver{};         // the name of its driver, with the version
	double seconds = 0.0;

	// For the report, if the pictures or figures differ: the bytes of PNG files.
	std::string expected_png{};
	std::string drawn_png{};
	std::string difference_png{};
	std::vector<MovedFigure> moved{};
};

inline const char* word(Verdict verdict)
{
	switch (verdict)
	{
	case Verdict::passed:
		return "passed";
	case Verdict::differs:
		return "differs";
	case Verdict::updated:
		return "updated";
	case Verdict::failed:
		break;
	}
	return "error";
}

} // namespace vp::app
