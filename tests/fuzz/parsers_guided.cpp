// For libFuzzer, which finds inputs that reach new code. Seeds come from fuzz_parsers --write-seeds.
// VPROBE_FUZZ_PARSER=E keeps to one parser: its letter (parsers.h) is put before each input.
#include "parsers.h"

#include <cstdlib>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
	static const char* const parser = std::getenv("VPROBE_FUZZ_PARSER");
	if (!parser)
	{
		feedParser(data, size);
		return 0;
	}
	std::vector<std::uint8_t> input{static_cast<std::uint8_t>(*parser)};
	input.insert(input.end(), data, data + size);
	feedParser(input.data(), input.size());
	return 0;
}
