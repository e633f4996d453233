#include "text_end.h"

#include <cctype>
#include <fstream>

namespace vp::reader::text
{

bool endsInsideALine(const std::string& file)
{
	std::ifstream in(file, std::ios::binary | std::ios::ate);
	in.seekg(-1, std::ios::end);
	return !std::isspace(in.get());
}

} // namespace vp::reader::text
