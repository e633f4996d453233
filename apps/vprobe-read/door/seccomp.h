#pragma once

namespace vp::reader::door
{

// Which of the system's calls this process may still make, by a filter of Linux's seccomp. A call that it does not know
// answers ENOSYS, as on an older kernel, so that libraries take their other way. A known call with an argument that is
// not allowed answers EACCES. The functions return true if the filter holds.

struct Permits
{
	bool write = false;   // files may be opened for writing
	bool execute = false; // the process may become another program
};
bool holdBySeccomp(const Permits& permits);

// A second filter, which refuses to become another program.
bool refuseExecBySeccomp();

} // namespace vp::reader::door
