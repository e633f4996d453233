#pragma once

#include <cassert>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

/// Marks the functions and classes that the library exports. Nothing else is exported.
#define VPROBE_API __attribute__((visibility("default")))

namespace vprobe
{

/// The kinds of errors.
enum class ErrorKind : std::uint8_t
{
	usage,         // an impossible setting or argument
	input,         // input that cannot be used
	device,        // no usable Vulkan device, or one that was lost; the next call may open another
	output,        // output that cannot be written
	found,         // the search found something that should not exist
	cancelled,     // the caller asked to stop
	out_of_memory, // the machine or the device has too little memory
	internal       // a bug in the library
};

/// One line that names the file or the setting, and the remedy. Settings stand between backquotes as the keys of a
/// state file: "`color_by` speed: takes array or generation".
struct Error
{
	ErrorKind kind = ErrorKind::internal;
	std::string message;
};

/// A value, or the reason why there is none. No function of the library throws.
template <class T>
class [[nodiscard]] Result
{
public:
	Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
	Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

	explicit operator bool() const { return state_.index() == 0; }
	/// A result with a value. It is true.
	T& value() { return std::get<0>(state_); }
	const T& value() const { return std::get<0>(state_); }
	T& operator*() { return value(); }
	const T& operator*() const { return value(); }
	T* operator->() { return &value(); }
	const T* operator->() const { return &value(); }
	/// A result without a value. It is false.
	const Error& error() const { return std::get<1>(state_); }

private:
	std::variant<T, Error> state_;
};

struct Nothing
{
};
using Status = Result<Nothing>;

/// While a listener lives, the library's warnings go to its function, one at a time, from any thread. Only the newest
/// listener gets them. Without a listener they are dropped, since the library never writes to the screen. Listeners
/// must be destroyed in the reverse order of their creation.
class VPROBE_API MessageListener
{
public:
	explicit MessageListener(std::function<void(std::string_view line)> sink);
	~MessageListener();
	MessageListener(const MessageListener&) = delete;
	MessageListener& operator=(const MessageListener&) = delete;

private:
	struct State;
	std::unique_ptr<State> state_;
};

/// A listener for what the library is doing, such as "reading FILE". It gets an empty text when that ends.
class VPROBE_API ProgressListener
{
public:
	explicit ProgressListener(std::function<void(std::string_view what)> sink);
	~ProgressListener();
	ProgressListener(const ProgressListener&) = delete;
	ProgressListener& operator=(const ProgressListener&) = delete;

private:
	struct State;
	std::unique_ptr<State> state_;
};

} // namespace vprobe
