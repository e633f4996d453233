// In vprobe-read: the formats whose libraries take longer to load than most files take to read. vprobe-read-more has
// them.

#include "formats.h"
#include "read/protocol.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/checks/file_head.h"
#include "vprobe-read/convert/convert.h"
#include "vprobe-read/door/opening.h"

#include <unistd.h>

namespace vp::reader
{

namespace
{

// Becomes vprobe-read-more, which begins anew with the same arguments and limits.
[[noreturn]] void continueWithMore(const Request& request)
{
	for (const int fd : {read::kArraysFd, read::kCellsFd})
		if (request.unpack.empty() && // else a list of parts may stand there already
		    (ftruncate(fd, 0) != 0 || lseek(fd, 0, SEEK_SET) != 0))
			throw Refusal("the shared memory for its arrays cannot be emptied; try again");
	const std::string program = door::programWithMore();
	execv(program.c_str(), request.arguments);
	throw Refusal("needs " + program + ", which cannot be started; install it beside vprobe-read");
}

} // namespace

void formats::needHdf5(const Request& request)
{
	continueWithMore(request);
}

std::set<std::string> checks::hdf5Names(const std::string&)
{
	return {}; // HDF5 files have gone to vprobe-read-more
}

void volumes::unpackParts(const Request&, const std::function<void(std::string_view)>&)
{
	throw Refusal("parts are unpacked by vprobe-read-more"); // which this process has become by then
}

void convert::writeVtkHdf(vtkDataSet*, const std::string&, int)
{
	throw Refusal("VTKHDF is written by vprobe-read-more"); // which this process has become by then
}

std::vector<std::string> convert::writePack(const std::vector<KeptBlock>&, const TimesToPack&, const std::string&,
                                            const Request&)
{
	throw Refusal("packs are written by vprobe-read-more"); // likewise
}

#define VP_IN_base(ROOM, FUNCTION)
#define VP_IN_more(ROOM, FUNCTION)                                                                                     \
	void ROOM::read##FUNCTION(const Request& request, manifest::Writer&)                                               \
	{                                                                                                                  \
		continueWithMore(request);                                                                                     \
	}
#define VP_FORMAT(NAME, ENDINGS, WHAT, READ, BY, FILES, SIGN, PROGRAM, ROOM, FUNCTION) VP_IN_##PROGRAM(ROOM, FUNCTION)
#include "read/format_table.inl"
#undef VP_FORMAT

} // namespace vp::reader
