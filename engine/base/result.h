#pragma once

#include <cassert>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>

namespace vp
{

/// Why something failed, for callers that act on it.
enum class ErrorKind : std::uint8_t
{
	usage,         // a setting or an argument that cannot be
	input,         // input that cannot be used
	device,        // no usable Vulkan device, or one that was lost; the next call may open another
	output,        // output that cannot be written
	found,         // the search found something that should not exist
	cancelled,     // the caller asked to stop
	out_of_memory, // the machine or the device has too little memory
	internal       // a bug in the program
};

/// One line that names the file or the setting, and the remedy. Settings stand between backquotes as the keys of a
/// state file, as in "`color_by` array": a program shows its own word for them.
struct Error
{
	ErrorKind kind = ErrorKind::internal;
	std::string message;
};

/// A value, or the reason there is none. For bad input and Vulkan's recoverable failures; our own mistakes are asserts.
template <class T>
class [[nodiscard]] Result
{
public:
	Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
	Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

	explicit operator bool() const { return state_.index() == 0; }
	T& operator*() { return value(); }
	const T& operator*() const { return const_cast<Result*>(this)->value(); }
	T* operator->() { return &value(); }
	const T* operator->() const { return &const_cast<Result*>(this)->value(); }
	T& value()
	{
		assert(state_.index() == 0);
		return std::get<0>(state_);
	}
	const Error& error() const
	{
		assert(state_.index() == 1);
		return std::get<1>(state_);
	}

private:
	std::variant<T, Error> state_;
};

struct Nothing
{
};
using Status = Result<Nothing>;

} // namespace vp
