#include "work.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <iterator>
#include <mutex>
#include <thread>
#include <vector>

#include <pthread.h>
#include <unistd.h>

namespace binding
{

namespace
{

using namespace std::chrono_literals;
constexpr auto kLook = 20ms;   // how often signals are looked at
constexpr auto kGrace = 120ms; // how long work may take to stop, before it is left alone

struct Job
{
	std::function<void(std::stop_token)> work;
	std::stop_source stop{};
	std::mutex mutex{}; // guards what follows
	std::condition_variable changed{};
	bool done = false;
	bool told = true; // what it is busy with has been passed on
	std::string busy{};
	std::vector<std::string> warnings{};
};

thread_local Job* running = nullptr;

// Messages of the library come from the thread that works, or from threads that help it; these do not know the job.
struct Strays
{
	std::mutex mutex;
	std::vector<std::string> warnings;
};
Strays& strays()
{
	static auto* all = new Strays; // lives to the end
	return *all;
}

std::atomic<int> under_way = 0; // calls of the library, in any thread
bool is_cut_off = false;        // this process was forked while threads were at work, which it lacks

// Counts a call.
class UnderWay
{
public:
	UnderWay() { ++under_way; }
	~UnderWay() { --under_way; }
	UnderWay(const UnderWay&) = delete;
	UnderWay& operator=(const UnderWay&) = delete;
};

void perform(Job& job)
{
	{
		const UnderWay counted;
		running = &job;
		job.work(job.stop.get_token());
		running = nullptr;
		job.work = {}; // may let go of arrays, which waits for the GIL
	}
	const std::lock_guard lock(job.mutex);
	job.done = true;
	job.changed.notify_all();
}

// Threads that wait for jobs. One that a caller has left alone comes back when it is done.
class Workers
{
public:
	void start(std::shared_ptr<Job> job)
	{
		const std::lock_guard lock(mutex_);
		if (waiting_.size() >= idle_)
			threads_.emplace_back([this] { serve(); }); // throws where there can be no more
		waiting_.push_back(std::move(job));
		++busy_;
		wake_.notify_one();
	}
	// Ends the threads that wait. Returns false where one is at work.
	bool endIdle()
	{
		{
			std::unique_lock lock(mutex_);
			// A thread whose call has returned may not yet have noted that it is done.
			if (!idle_now_.wait_for(lock, kGrace, [&] { return busy_ == 0; }))
				return false;
			ends_ = true;
			wake_.notify_all();
		}
		for (std::thread& thread : threads_)
			thread.join();
		threads_.clear();
		ends_ = false;
		return true;
	}
	void stopAll()
	{
		std::unique_lock lock(mutex_);
		for (const std::weak_ptr<Job>& each : started_)
			if (const std::shared_ptr<Job> job = each.lock())
				job->stop.request_stop();
		idle_now_.wait(lock, [&] { return busy_ == 0; });
	}

private:
	void serve()
	{
		std::unique_lock lock(mutex_);
		while (true)
		{
			++idle_;
			wake_.wait(lock, [&] { return !waiting_.empty() || ends_; });
			--idle_;
			if (waiting_.empty())
				return;
			std::shared_ptr<Job> job = std::move(waiting_.back());
			waiting_.pop_back();
			std::erase_if(started_, [](const std::weak_ptr<Job>& each) { return each.expired(); });
			started_.push_back(job);
			lock.unlock();
			perform(*job);
			job.reset();
			lock.lock();
			if (--busy_ == 0)
				idle_now_.notify_all();
		}
	}

	std::mutex mutex_;
	std::condition_variable wake_, idle_now_;
	std::vector<std::thread> threads_;
	bool ends_ = false;
	std::vector<std::shared_ptr<Job>> waiting_;
	std::vector<std::weak_ptr<Job>> started_;
	std::size_t idle_ = 0;
	std::size_t busy_ = 0;
};

Workers* workers = new Workers; // lives to the end; a child process has threads of its own

// A child has none of the threads that wait for work, so they end before. Where one is at work, as one that reads a
// file by a process of its own, they stay: that child has no use for them.
bool is_ready_to_fork = false;

void beforeFork()
{
	is_ready_to_fork = !is_cut_off && under_way == 0 && workers->endIdle() && vprobe::endIdleThreads();
}

void afterForkInChild()
{
	workers = new Workers;
	under_way = 0;
	is_cut_off = !is_ready_to_fork;
}

void warnAll(std::vector<std::string> lines)
{
	{
		const std::lock_guard lock(strays().mutex);
		std::move(strays().warnings.begin(), strays().warnings.end(), std::back_inserter(lines));
		strays().warnings.clear();
	}
	if (lines.empty())
		return;
	const py::object category = py::module_::import("vprobe._errors").attr("VprobeWarning");
	for (const std::string& line : lines)
		if (PyErr_WarnEx(category.ptr(), line.c_str(), 2) != 0)
			throw py::error_already_set(); // the user turns warnings into errors
}

// Passes on what the job is busy with.
void tell(Job& job, std::unique_lock<std::mutex>& lock, const py::object& progress)
{
	if (job.told)
		return;
	job.told = true;
	const std::string busy = job.busy;
	lock.unlock();
	if (!busy.empty())
		progress(busy);
	lock.lock();
}

void watch(Job& job, const py::object& progress)
{
	const bool tells = !progress.is_none();
	std::unique_lock lock(job.mutex);
	while (!job.done)
	{
		{
			lock.unlock();
			const py::gil_scoped_release released;
			lock.lock();
			job.changed.wait_for(lock, kLook, [&] { return job.done || (tells && !job.told); });
			lock.unlock(); // nobody waits for the GIL with the lock
		}
		if (PyErr_CheckSignals() != 0)
			throw py::error_already_set();
		lock.lock();
		if (tells)
			tell(job, lock, progress);
	}
}

void awaitStop(Job& job)
{
	job.stop.request_stop();
	const py::gil_scoped_release released;
	std::unique_lock lock(job.mutex);
	job.changed.wait_for(lock, kGrace, [&] { return job.done; });
}

// A text of bytes that need not be UTF-8, such as names of files.
py::object textOf(const std::string& bytes)
{
	return py::reinterpret_steal<py::object>(
	    PyUnicode_DecodeUTF8(bytes.data(), static_cast<py::ssize_t>(bytes.size()), "replace"));
}

} // namespace

void raise(const vprobe::Error& error)
{
	const py::object errors = py::module_::import("vprobe._errors");
	const py::object kind = errors.attr("BY_KIND")[py::int_(static_cast<int>(error.kind))];
	// One line, whatever the names in it hold.
	std::string line = error.message;
	std::replace_if(
	    line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
	PyErr_SetObject(kind.ptr(), textOf(line).ptr());
	throw py::error_already_set();
}

namespace
{

void requireThreads()
{
	if (is_cut_off)
		raise({vprobe::ErrorKind::usage,
		       "this process was forked while threads of vprobe were at work, which it lacks; "
		       "start it with multiprocessing.get_context(\"spawn\")"});
}

} // namespace

BriefCall::BriefCall()
{
	requireThreads();
	++under_way;
}

BriefCall::~BriefCall()
{
	--under_way;
}

void runInterruptibly(std::function<void(std::stop_token)> work, const py::object& progress)
{
	requireThreads();
	const auto job = std::make_shared<Job>();
	job->work = std::move(work);
	const bool is_main_thread = gettid() == getpid(); // which alone is told of signals
	if (is_main_thread || !progress.is_none())
	{
		workers->start(job);
		try
		{
			watch(*job, progress);
		}
		catch (...)
		{
			awaitStop(*job);
			throw;
		}
	}
	else
	{
		const py::gil_scoped_release released;
		perform(*job);
	}
	warnAll(std::move(job->warnings));
}

void startListening(py::module_& module)
{
	// Neither ends before the program does.
	new vprobe::MessageListener(
	    [](std::string_view line)
	    {
		    if (running)
		    {
			    const std::lock_guard lock(running->mutex);
			    running->warnings.emplace_back(line);
			    return;
		    }
		    const std::lock_guard lock(strays().mutex);
		    strays().warnings.emplace_back(line);
	    });
	new vprobe::ProgressListener(
	    [](std::string_view what)
	    {
		    if (!running)
			    return;
		    const std::lock_guard lock(running->mutex);
		    running->busy = what;
		    running->told = false;
		    running->changed.notify_all();
	    });
	pthread_atfork(beforeFork, nullptr, afterForkInChild);
	py::module_::import("atexit").attr("register")(py::cpp_function(
	    []
	    {
		    const py::gil_scoped_release released;
		    workers->stopAll();
	    }));
	module.attr("__version__") = vprobe::version();
}

} // namespace binding
