#include "write/flush.h"

#include <cerrno>

#include <fcntl.h>
#include <unistd.h>

namespace vp::write
{

int flushFile(int descriptor)
{
	while (fsync(descriptor) != 0)
		if (errno != EINTR)
			return errno == EINVAL || errno == ENOSYS || errno == ENOTSUP || errno == EROFS ? 0 : errno;
	return 0;
}

int flushFileOrFolder(const std::string& path)
{
	const int opened = open(path.c_str(), O_RDONLY | O_CLOEXEC);
	if (opened < 0)
		return errno == EACCES ? 0 : errno; // one may write into a folder without reading it
	const int error = flushFile(opened);
	close(opened);
	return error;
}

} // namespace vp::write
