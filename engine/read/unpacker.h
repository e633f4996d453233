#pragma once

#include "read/child.h"

#include <mutex>
#include <optional>
#include <string>

namespace vp::read
{

// A reader child that unpacks parts of one array. It starts with the first parts and stays until its owner goes, since
// to start one takes longer than to unpack some megabytes. Any thread may use it; they take turns.
class Unpacker
{
public:
	// A part as the child is told of it (protocol.h), and where its bytes go, as many for each.
	struct Part
	{
		std::array<std::uint64_t, 3> told;
		std::span<std::byte> to;
	};

	// format: whose program knows how to unpack. how: the filters, or the "reader".
	Unpacker(std::string file, std::string format, std::size_t part_bytes, const std::string& how);

	// Throws parts::Unreadable. A child that was killed between two calls is replaced.
	void unpack(std::span<const Part> parts);

private:
	Status start();
	Status ask(std::span<const Part> parts);

	std::string file_;
	ReadOptions options_;
	std::mutex mutex_;
	std::optional<ReaderAtWork> child_;
	Descriptor requests_;
	pid_t owner_ = 0; // the process that started the child; one that was forked from it starts its own
};

} // namespace vp::read
