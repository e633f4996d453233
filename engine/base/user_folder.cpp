#include "base/user_folder.h"

#include <cstdlib>
#include <system_error>

namespace vp
{

namespace fs = std::filesystem;

fs::path userFolder(const char* variable, const char* usual)
{
	const char* set = std::getenv(variable);
	const char* home = std::getenv("HOME");
	if (set && *set == '/')
		return fs::path(set) / "volume-probes";
	return home && *home == '/' ? fs::path(home) / usual / "volume-probes" : fs::path();
}

fs::path madeFolder(const fs::path& wanted)
{
	std::error_code failed;
	if (!wanted.empty())
		fs::create_directories(wanted, failed);
	return failed ? fs::path() : wanted;
}

} // namespace vp
