#pragma once

#include <vprobe/vprobe.h>

#include <pybind11/pybind11.h>

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>

namespace binding
{

namespace py = pybind11;

// Throws the Python exception of this error's kind.
[[noreturn]] void raise(const vprobe::Error& error);

template <class T>
T valueOf(vprobe::Result<T>&& result)
{
	if (!result)
		raise(result.error());
	return std::move(*result);
}

// Runs `work` without the GIL. In the main thread, signals are looked at meanwhile: after Ctrl-C the work is asked to
// stop, and KeyboardInterrupt is raised soon after, whether the work has ended by then or not. What `work` uses it
// shares or owns, so it may end later.
//
// progress: called with a line when the library begins something that takes its time; None: nobody is told.
// Afterwards the library's warnings go to Python's.
void runInterruptibly(std::function<void(std::stop_token)> work, const py::object& progress);

// The same for work that gives a Result: its value, or the exception.
template <class Work>
auto run(Work work, const py::object& progress = py::none())
{
	using Outcome = std::invoke_result_t<Work&, std::stop_token>;
	auto outcome = std::make_shared<std::optional<Outcome>>();
	runInterruptibly(
	    [outcome, work = std::move(work)](std::stop_token stop) mutable
	    {
		    try
		    {
			    outcome->emplace(work(std::move(stop)));
		    }
		    catch (const std::exception& error) // in a thread that has nobody to catch it
		    {
			    outcome->emplace(vprobe::Error{vprobe::ErrorKind::internal, error.what()});
		    }
	    },
	    progress);
	return valueOf(std::move(**outcome));
}

// Counts a call as under way; throws UsageError in a process that lacks the library's threads.
class BriefCall
{
public:
	BriefCall();
	~BriefCall();
	BriefCall(const BriefCall&) = delete;
	BriefCall& operator=(const BriefCall&) = delete;
};

// Runs what takes little time, without the GIL.
template <class Work>
auto runBriefly(Work&& work)
{
	const BriefCall counted;
	const py::gil_scoped_release released;
	return work();
}

// Listens to the library from now on, and makes the end of the program wait for work that was left alone.
void startListening(py::module_& module);

} // namespace binding
