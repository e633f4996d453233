#pragma once

#include <cstring>
#include <string>
#include <vector>

// Text of an OpenFOAM file of that class.
inline std::string foamFile(const std::string& type, const std::string& body, const std::string& format = "ascii",
                            const std::string& arch = "LSB;label=32;scalar=64")
{
	return "/*--*\\ a banner \\*--*/\nFoamFile\n{\n    version 2.0; // a word\n    format " + format +
	       ";\n    arch \"" + arch + "\";\n    class " + type +
	       ";\n    location \"1\";\n    object grad(T);\n}\n// * * //\n" + body;
}

template <class Number>
std::string bytesOfNumbers(const std::vector<Number>& numbers)
{
	std::string bytes(numbers.size() * sizeof(Number), '\0');
	std::memcpy(bytes.data(), numbers.data(), bytes.size());
	return bytes;
}
