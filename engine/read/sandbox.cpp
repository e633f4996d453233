#include "read/sandbox.h"

#include "base/messages.h"
#include "read/child.h"
#include "read/manifest.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <optional>
#include <sstream>

#include <unistd.h>

namespace vp::read
{

namespace
{

constexpr std::array<std::string_view, 3> kSandboxes = {"auto", "require", "off"};

struct SandboxState
{
	std::mutex mutex;
	std::optional<Sandbox> chosen;
	std::vector<std::string> follow;
	std::string held;
	bool is_told = false;
};

SandboxState& sandboxState()
{
	static SandboxState state;
	return state;
}

// Keys, addresses and paths of other programs are nobody's business but the user's.
bool isForReader(std::string_view variable)
{
	constexpr std::array<std::string_view, 7> names = {
	    "LD_LIBRARY_PATH=", "LANG=", "TZ=", "HDF5_PLUGIN_PATH=", "HDF5_USE_FILE_LOCKING=", "LC_", "VPROBE_READ_"};
	const std::string_view name = variable.substr(0, variable.find('='));
	return name.ends_with("SAN_OPTIONS") || name.ends_with("SAN_SYMBOLIZER_PATH") ||
	       std::ranges::any_of(names, [&](std::string_view start) { return variable.starts_with(start); });
}

bool holdsAll(std::string_view held)
{
	return held.find("landlock") != held.npos && held.find("seccomp") != held.npos;
}

} // namespace

void setSandbox(Sandbox sandbox)
{
	const std::lock_guard lock(sandboxState().mutex);
	sandboxState().chosen = sandbox;
}

Result<Sandbox> parseSandbox(const std::string& text)
{
	const auto found = std::ranges::find(kSandboxes, text);
	if (found == kSandboxes.end())
		return Error{ErrorKind::usage, fmt::format("must be auto, require or off, not {}", text)};
	return static_cast<Sandbox>(found - kSandboxes.begin());
}

Result<std::string> sandboxArgument()
{
	const std::lock_guard lock(sandboxState().mutex);
	if (const char* set = std::getenv("VPROBE_SANDBOX"); !sandboxState().chosen && set && *set)
	{
		const Result<Sandbox> sandbox = parseSandbox(set);
		if (!sandbox)
			return Error{ErrorKind::usage, "VPROBE_SANDBOX " + sandbox.error().message};
		sandboxState().chosen = *sandbox;
	}
	return std::string(kSandboxes.at(static_cast<std::size_t>(sandboxState().chosen.value_or(Sandbox::automatic))));
}

void setFollow(std::vector<std::string> folders)
{
	const std::lock_guard lock(sandboxState().mutex);
	sandboxState().follow = std::move(folders);
}

Status checkFollow(const std::string& folder)
{
	std::error_code unknown;
	if (folder == "anywhere" || std::filesystem::is_directory(folder, unknown))
		return Nothing{};
	return Error{ErrorKind::usage, folder + ": no such folder; name one, or anywhere"};
}

std::string followArgument(const std::vector<std::string>& more)
{
	std::vector<std::string> folders = more;
	if (const char* set = std::getenv("VPROBE_FOLLOW"))
		for (std::istringstream all(set); std::getline(all, folders.emplace_back(), ':');)
		{
		}
	const std::lock_guard lock(sandboxState().mutex);
	folders.insert(folders.end(), sandboxState().follow.begin(), sandboxState().follow.end());
	return fmt::format("{}", fmt::join(folders, "\n"));
}

std::vector<std::string> readerEnvironment()
{
	std::vector<std::string> variables;
	for (char** variable = environ; variable && *variable; ++variable)
		if (isForReader(*variable))
			variables.emplace_back(*variable);
	return variables;
}

void noteSandbox(std::string_view held)
{
	SandboxState& state = sandboxState();
	const std::lock_guard lock(state.mutex);
	if (state.held.empty() || !holdsAll(held))
		state.held = held;
	if (state.is_told || holdsAll(held) || state.chosen == Sandbox::off)
		return;
	state.is_told = true;
	warn("the reader's sandbox is not complete on this system ({}): open only files that you trust, or use Linux 5.13 "
	     "or newer with Landlock",
	     held);
}

Result<std::string> tryOutSandbox()
{
	const Result<HandedOver> handed = runReader("demo:shell:1", {}, limitsWithoutFile());
	if (!handed)
		return handed.error();
	const Result<CheckedInput> checked = checkManifest(handed->manifest, handed->arrays, handed->cells);
	return checked ? Result<std::string>(checked->sandbox) : checked.error();
}

std::string sandboxText()
{
	const std::lock_guard lock(sandboxState().mutex);
	return sandboxState().held;
}

} // namespace vp::read
