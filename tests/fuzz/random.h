#pragma once

#include <cstddef>
#include <cstdint>

namespace fuzz
{

// Splitmix64 (Steele, Lea and Flood 2014): the same numbers on every machine, which the standard's distributions do not
// promise.
class Random
{
public:
	explicit Random(std::uint64_t seed) : state_(seed) {}
	// Makes the numbers of one case of a seed.
	Random(std::uint64_t seed, std::uint64_t number) : state_(seed * 0x9E3779B97F4A7C15u ^ (number << 20))
	{
		state_ = next();
	}

	std::uint64_t next()
	{
		std::uint64_t z = state_ += 0x9E3779B97F4A7C15u;
		z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
		z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
		return z ^ (z >> 31);
	}
	// 0 to count - 1; 0 where there is none.
	std::size_t below(std::size_t count) { return count == 0 ? 0 : static_cast<std::size_t>(next() % count); }
	bool oneIn(std::size_t count) { return below(count) == 0; }

private:
	std::uint64_t state_;
};

} // namespace fuzz
