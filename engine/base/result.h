#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace vp
{

// The program's exit codes; scripts rely on the numbers.
enum class ExitCode
{
	done = 0,
	usage = 1,     // unknown option, a value that cannot be
	input = 2,     // input that cannot be used
	no_device = 3, // no usable Vulkan device
	output = 4,    // output that cannot be written, and everything else
	findings = 5,
	interrupted = 130
};

// One line that names the file or option and the remedy.
struct Error
{
	ExitCode code = ExitCode::output;
	std::string message;
};

// A value, or the reason there is none. For bad input and Vulkan's recoverable failures; our own mistakes are asserts.
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
