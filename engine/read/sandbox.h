#pragma once

#include "base/result.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace vp::read
{

// Says what keeps the reader from doing more than reading its files. VPROBE_SANDBOX sets it before anyone calls
// setSandbox().
enum class Sandbox : std::uint8_t
{
	automatic, // what the system has of it
	require,   // an error where the system has not all of it
	off
};
void setSandbox(Sandbox sandbox);
Result<Sandbox> parseSandbox(const std::string& text); // "auto", "require" or "off"

// Sets the folders with files that inputs may name, besides their own folder, for all readings from now on; "anywhere"
// is every folder. VPROBE_FOLLOW names more, with colons between. No setting: a state must not open the sandbox.
void setFollow(std::vector<std::string> folders);
Status checkFollow(const std::string& folder); // a usage error unless it is a folder, or "anywhere"

// Returns what held the readers so far, at the least: "landlock 7, seccomp", "seccomp", "nothing". Empty before the
// first.
std::string sandboxText();

// Starts a reader that reads no file. Returns what holds it, in the words of sandboxText().
Result<std::string> tryOutSandbox();

// For runReader(): the SANDBOX argument, an error where VPROBE_SANDBOX is no such word; the FOLLOW argument, with more
// folders for this reading; and the variables that the reader gets as NAME=VALUE, those for libraries, language and
// time zone.
Result<std::string> sandboxArgument();
std::string followArgument(const std::vector<std::string>& more);
std::vector<std::string> readerEnvironment();

// Remembers what held a reader, and tells the user once where that is not all.
void noteSandbox(std::string_view held);

} // namespace vp::read
