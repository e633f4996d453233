#include "door.h"

#include "landlock.h"
#include "seccomp.h"

#include <sys/prctl.h>
#include <sys/stat.h>

namespace vp::reader::door
{

namespace
{

bool is_execution_open = false; // behind a closed door

// The folder of the tasks has a link for each, and two of its own. 1 where the system does not tell.
unsigned threadsOfThis()
{
	struct stat about = {};
	return stat("/proc/self/task", &about) == 0 && about.st_nlink > 2 ? static_cast<unsigned>(about.st_nlink) - 2 : 1;
}

} // namespace

std::string holdText(const Hold& hold)
{
	std::string text = hold.landlock > 0 ? "landlock " + std::to_string(hold.landlock) : "";
	if (hold.seccomp)
		text += text.empty() ? "seccomp" : ", seccomp";
	if (hold.threads > 1 && !kSanitized)
		text += text.empty() ? "" : ", but for " + std::to_string(hold.threads - 1) + " threads";
	return text.empty() ? "nothing" : text;
}

Hold closeDoor(const Opening& opening)
{
	Hold hold;
	hold.threads = threadsOfThis();
	// Without it, only root may do what follows. It also keeps programs from gaining rights when they are started.
	prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
	hold.landlock = holdByLandlock(opening);
	hold.seccomp = holdBySeccomp({!opening.write.empty(), !opening.execute.empty()});
	is_execution_open = hold.seccomp && !opening.execute.empty();
	return hold;
}

void refuseExec()
{
	if (is_execution_open && !kSanitized)
		refuseExecBySeccomp();
	is_execution_open = false;
}

} // namespace vp::reader::door
