// In vprobe-read: the formats whose libraries take longer to load than most files take to read. vprobe-read-more has
// them.

#include "formats.h"
#include "read/protocol.h"
#include "refusal.h"

#include <filesystem>

#include <unistd.h>

namespace
{

// Becomes vprobe-read-more, which begins anew with the same arguments and limits.
[[noreturn]] void continueWithMore(const Request& request)
{
	for (const int fd : {vp::read::kArraysFd, vp::read::kCellsFd})
		if (ftruncate(fd, 0) != 0 || lseek(fd, 0, SEEK_SET) != 0)
			throw Refusal("the shared memory for its arrays cannot be emptied; try again");
	const std::string program = std::filesystem::read_symlink("/proc/self/exe").string() + "-more";
	execv(program.c_str(), request.arguments);
	throw Refusal("needs " + program + ", which cannot be started; install it beside vprobe-read");
}

} // namespace

void readCgns(const Request& request, ManifestWriter&)
{
	continueWithMore(request);
}

void readExodus(const Request& request, ManifestWriter&)
{
	continueWithMore(request);
}

void readFoam(const Request& request, ManifestWriter&)
{
	continueWithMore(request);
}

void readHdf(const Request& request, ManifestWriter&)
{
	continueWithMore(request);
}

void readPlot3d(const Request& request, ManifestWriter&)
{
	continueWithMore(request);
}
