#include "viewer_program.h"

#include "viewer/viewer.h"

#include <filesystem>

#include <unistd.h>

namespace vp::app
{

void becomeViewer(const char* called, const std::vector<std::string>& arguments)
{
	namespace fs = std::filesystem;
	if (arguments.front() != "view")
		return;
	std::vector<char*> words{const_cast<char*>(called ? called : "vprobe")};
	for (const std::string& argument : arguments)
		words.push_back(const_cast<char*>(argument.c_str()));
	words.push_back(nullptr);
	std::error_code error;
	const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
	for (const fs::path& place : {folder / "vprobe-view", folder.parent_path() / "libexec/vprobe/vprobe-view"})
		execv(place.c_str(), words.data()); // returns only if it fails
}

// This program reads and explains the command line of the window, but opens none: see becomeViewer().
Result<ExitCode> runViewer(const ViewerOptions&)
{
	return Error{ErrorKind::device,
	             "the window is a program of its own, vprobe-view, which is not installed: install the package "
	             "vprobe-view, or draw with vprobe render"};
}

} // namespace vp::app
