#pragma once

#include "profile/child_program.h"
#include "profile/profile_log.h"
#include "profile/profile_options.h"

#include <optional>
#include <string>
#include <vector>

namespace vp::app
{

// One of the settings or builds that are measured in turns. Each runs in a process of its own: so all are alike, each
// has its own number of threads, and a program of another build is no special case.
class Contender
{
public:
	enum class Kind
	{
		first,   // the options of the command line
		setting, // with others on top
		build    // the options of the command line by another program
	};

	// text: the options of a setting, or the path of another build.
	Contender(Kind kind, std::string text) : kind_(kind), text_(std::move(text)) {}

	// Starts the program, anew if it runs.
	Status start();
	// Waits until the program has read the input and built what it needs. If its build cannot measure plane by plane,
	// answersPlanes() is false afterwards.
	Status waitUntilReady();
	bool answersPlanes() const { return child_.has_value(); }
	std::size_t planes() const { return planes_; }

	// Measures a plane.
	Result<std::vector<StageTime>> measure(std::size_t plane);

	struct Whole
	{
		std::vector<StageTime> medians;
		double first_ms; // the first cut, or the first frame if planes are drawn
	};
	// Runs the program from beginning to end.
	Result<Whole> runWhole() const;

	Kind kind() const { return kind_; }
	const std::string& text() const { return text_; }
	std::string option() const; // as the command line names it: --versus '...'
	// Lines on standard error of the start. They are about the input or the settings.
	const std::vector<std::string>& remarks() const { return remarks_; }

private:
	std::string program() const;
	std::vector<std::string> arguments() const;
	Error failure(ChildProgram::End end) const;

	Kind kind_;
	std::string text_;
	std::optional<ChildProgram> child_;
	std::size_t planes_ = 0;
	std::vector<std::string> remarks_;
};

// Carries out the other side in a process of its own: reads lines with numbers of planes from standard input, and
// answers with the times of each as a line of JSON.
Status answerPlanes(const ProfileOptions& options);

} // namespace vp::app
