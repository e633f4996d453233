#include "damage.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <limits>
#include <string_view>

namespace fuzz
{

namespace
{

constexpr std::size_t kHeadBytes = 2048;

std::size_t placeIn(const std::string& contents, Random& random)
{
	return random.below(random.oneIn(2) ? contents.size() : std::min(contents.size(), kHeadBytes));
}

// Up to a 16th of the file, often a few bytes only.
std::size_t lengthFrom(const std::string& contents, std::size_t at, Random& random)
{
	const std::size_t most = random.oneIn(2) ? 16 : contents.size() / 16 + 1;
	return std::min(1 + random.below(most), contents.size() - at);
}

template <class T>
std::string bytesOf(T value, bool swapped)
{
	std::string bytes(sizeof(T), '\0');
	std::memcpy(bytes.data(), &value, sizeof(T));
	if (swapped)
		std::reverse(bytes.begin(), bytes.end());
	return bytes;
}

std::string extremeBytes(Random& random)
{
	constexpr double kInf = std::numeric_limits<double>::infinity();
	const bool swapped = random.oneIn(2);
	switch (random.below(6))
	{
	case 0:
		return bytesOf(std::array<std::uint8_t, 4>{0, 1, 127, 255}[random.below(4)], false);
	case 1:
		return bytesOf(std::array<std::int16_t, 4>{0, -1, 32767, -32768}[random.below(4)], swapped);
	case 2:
		return bytesOf(std::array<std::int32_t, 6>{0, 1, -1, 65536, std::numeric_limits<std::int32_t>::max(),
		                                           std::numeric_limits<std::int32_t>::min()}[random.below(6)],
		               swapped);
	case 3:
		return bytesOf(std::array<std::int64_t, 6>{0, -1, std::int64_t(1) << 32, std::int64_t(1) << 40,
		                                           std::numeric_limits<std::int64_t>::max(),
		                                           std::numeric_limits<std::int64_t>::min()}[random.below(6)],
		               swapped);
	case 4:
		return bytesOf(std::array<float, 5>{std::numeric_limits<float>::quiet_NaN(), static_cast<float>(kInf), -3.4e38f,
		                                    1e-40f, 0.0f}[random.below(5)],
		               swapped);
	default:
		return bytesOf(std::array<double, 5>{std::numeric_limits<double>::quiet_NaN(), -kInf, 1.7e308, 5e-324,
		                                     1e200}[random.below(5)],
		               swapped);
	}
}

bool isNumberPart(char c)
{
	return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

std::string cutShort(std::string& contents, Random& random)
{
	contents.resize(random.below(contents.size()));
	return "cut to " + std::to_string(contents.size()) + " bytes";
}

std::string flipBits(std::string& contents, Random& random)
{
	const std::size_t count = 1 + random.below(8);
	std::size_t at = 0;
	for (std::size_t i = 0; i < count; ++i)
	{
		at = placeIn(contents, random);
		contents[at] = static_cast<char>(contents[at] ^ (1 << random.below(8)));
	}
	return std::to_string(count) + " bits flipped, the last at byte " + std::to_string(at);
}

std::string overwrite(std::string& contents, Random& random)
{
	std::string bytes = extremeBytes(random);
	std::size_t at = placeIn(contents, random);
	if (random.oneIn(2))
		at -= at % bytes.size();
	bytes.resize(std::min(bytes.size(), contents.size() - at));
	contents.replace(at, bytes.size(), bytes);
	return std::to_string(bytes.size()) + " bytes overwritten at " + std::to_string(at);
}

// A digit, or the whole number it is part of.
std::string changeNumber(std::string& contents, Random& random)
{
	std::size_t at = placeIn(contents, random);
	while (at < contents.size() && !isNumberPart(contents[at]))
		++at;
	if (at == contents.size())
		return overwrite(contents, random);
	const std::string where = " at byte " + std::to_string(at);
	const char digit = static_cast<char>('0' + random.below(10));
	switch (random.below(4))
	{
	case 0:
		contents[at] = digit;
		return std::string("a digit replaced by ") + digit + where;
	case 1:
		contents.insert(at, 1 + random.below(12), digit);
		return "digits inserted" + where;
	default:
		break;
	}
	constexpr std::array<std::string_view, 18> kNumbers = {"0",
	                                                       "1",
	                                                       "-1",
	                                                       "2",
	                                                       "255",
	                                                       "65536",
	                                                       "2147483647",
	                                                       "-2147483648",
	                                                       "4294967296",
	                                                       "9223372036854775807",
	                                                       "nan",
	                                                       "-inf",
	                                                       "1e308",
	                                                       "-1e40",
	                                                       "1e-320",
	                                                       "100000",
	                                                       "18446744073709551615",
	                                                       "1e999"};
	std::size_t end = at;
	while (end < contents.size() && isNumberPart(contents[end]))
		++end;
	const std::string_view number = kNumbers[random.below(kNumbers.size())];
	contents.replace(at, end - at, number);
	return "a number replaced by " + std::string(number) + where;
}

std::string loseStretch(std::string& contents, Random& random)
{
	const std::size_t at = placeIn(contents, random);
	const std::size_t length = lengthFrom(contents, at, random);
	contents.erase(at, length);
	return std::to_string(length) + " bytes lost at " + std::to_string(at);
}

std::string doubleStretch(std::string& contents, Random& random)
{
	const std::size_t at = placeIn(contents, random);
	const std::string stretch = contents.substr(at, lengthFrom(contents, at, random));
	contents.insert(placeIn(contents, random), stretch);
	return std::to_string(stretch.size()) + " bytes from " + std::to_string(at) + " inserted elsewhere";
}

std::string blankStretch(std::string& contents, Random& random)
{
	const std::size_t at = placeIn(contents, random);
	const std::size_t length = lengthFrom(contents, at, random);
	const bool noise = random.oneIn(2);
	for (std::size_t i = at; i < at + length; ++i)
		contents[i] = noise ? static_cast<char>(random.below(256)) : '\0';
	return std::to_string(length) + (noise ? " bytes of noise at " : " zeros at ") + std::to_string(at);
}

std::string loseLine(std::string& contents, Random& random)
{
	const std::size_t at = placeIn(contents, random);
	const std::size_t start = contents.rfind('\n', at);
	const std::size_t end = contents.find('\n', at);
	if (start == contents.npos || end == contents.npos || end - start > 4096)
		return loseStretch(contents, random);
	contents.erase(start, end - start);
	return "a line lost at byte " + std::to_string(start);
}

std::string damageOnce(std::string& contents, Random& random)
{
	switch (random.below(11))
	{
	case 0:
		return cutShort(contents, random);
	case 1:
	case 2:
		return flipBits(contents, random);
	case 3:
	case 4:
		return overwrite(contents, random);
	case 5:
	case 6:
	case 7:
		return changeNumber(contents, random);
	case 8:
		return random.oneIn(2) ? loseStretch(contents, random) : loseLine(contents, random);
	case 9:
		return doubleStretch(contents, random);
	default:
		return blankStretch(contents, random);
	}
}

} // namespace

std::string damage(std::string& contents, Random& random)
{
	std::string done;
	for (std::size_t left = 1 + random.below(6) / 3 + random.below(6) / 5; left > 0 && !contents.empty(); --left)
		done += (done.empty() ? "" : "; ") + damageOnce(contents, random);
	return done.empty() ? "nothing: the file is empty" : done;
}

} // namespace fuzz
