#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace view
{

// A program that runs beside the test, and ends with it whatever becomes of the test.
class Process
{
public:
	struct Setting
	{
		std::map<std::string, std::string> environment{}; // set on top of ours
		std::string in = "/dev/null";
		std::string out = "/dev/null";
		std::string err = "/dev/null";
		int kept = -1; // a descriptor that it has too
	};

	Process(const std::vector<std::string>& command, const Setting& setting);
	~Process(); // asks it to end, and makes it end
	Process(const Process&) = delete;
	Process& operator=(const Process&) = delete;

	bool runs();
	// How it ended, 128 + signal where one killed it; none after so many seconds.
	std::optional<int> waitFor(double seconds);
	void interrupt(int signal) const;
	// Returns the bytes of memory that the process uses, or 0 if it does not run.
	std::size_t residentBytes() const;

private:
	pid_t process_ = -1;
	std::optional<int> status_;
};

bool isInstalled(const std::string& program); // in PATH

} // namespace view
