#pragma once

#include <new>
#include <stdexcept>
#include <string>

namespace vp::reader
{

// Says why an input cannot be used, in words that follow "FILE: " on the user's line.
class Refusal : public std::runtime_error
{
public:
	using std::runtime_error::runtime_error;
};

constexpr const char* kNoRoom = "cannot be written: its disk is full, or files may not grow so large; make room or "
                                "choose another place";

// Thrown if the shared memory has no room for the arrays.
class NoSharedMemory : public std::bad_alloc
{
public:
	const char* what() const noexcept override { return "there is no room in shared memory to hand its values over"; }
};

// Thrown if there is no room for a file that the parent wants written. The words follow the name of that file.
class NoRoom : public std::runtime_error
{
public:
	using std::runtime_error::runtime_error;
};

inline Refusal damaged(const std::string& reason)
{
	return Refusal("truncated or damaged: " + reason);
}

} // namespace vp::reader
