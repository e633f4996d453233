// For libFuzzer, which finds inputs that reach new code. Seeds come from fuzz_parsers --write-seeds.
#include "parsers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
	feedParser(data, size);
	return 0;
}
