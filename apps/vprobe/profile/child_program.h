#pragma once

#include "base/result.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <sys/types.h>

namespace vp::app
{

// A program that runs beside this one. Lines go to its standard input and come from its standard output. It ends with
// the object.
class ChildProgram
{
public:
	// Returns an error if there is no such program, or it cannot be executed.
	static Result<ChildProgram> start(const std::string& program, const std::vector<std::string>& arguments);
	ChildProgram(ChildProgram&& other) noexcept;
	ChildProgram& operator=(ChildProgram&&) = delete;
	~ChildProgram();

	void say(std::string_view text) const; // what a program that has ended does not hear is lost
	std::optional<std::string> hearLine(); // waits for the next line; returns nothing at the end
	std::string hearAll();                 // waits for the end

	struct End
	{
		int status;                     // the exit status, or 128 + the signal
		std::vector<std::string> lines; // those of its standard error
	};
	End end();                                     // closes its standard input, and waits
	std::vector<std::string> saidOnErrors() const; // lines of its standard error until now

private:
	ChildProgram() = default;

	pid_t process_ = -1;
	int socket_ = -1; // both ways
	int errors_ = -1; // a file in memory
	std::string heard_;
};

} // namespace vp::app
