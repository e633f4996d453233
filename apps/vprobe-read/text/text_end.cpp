#include "text_end.h"

#include <cctype>
#include <fstream>

bool endsInsideALine(const std::string& file)
{
	std::ifstream in(file, std::ios::binary | std::ios::ate);
	in.seekg(-1, std::ios::end);
	return !std::isspace(in.get());
}
