#include "sweep/worker.h"

#include "base/timeline.h"

#include <utility>

namespace vp::app
{

// An error of this thread has nobody who would hear it, so the naming is its first job.
Worker::Worker(std::string name)
    : waiting_([name = std::move(name)] { nameThreadRow(name); }), thread_([this] { work(); })
{
}

Worker::~Worker()
{
	{
		const std::lock_guard lock(mutex_);
		ends_ = true;
	}
	changed_.notify_all();
	thread_.join();
}

// While this thread is busy, no other thread touches failure_.
void Worker::doJob(const std::function<void()>& job)
{
	if (failure_)
		return;
	try
	{
		job();
	}
	catch (...)
	{
		failure_ = std::current_exception();
	}
}

void Worker::work()
{
	std::unique_lock lock(mutex_);
	for (;;)
	{
		changed_.wait(lock, [&] { return waiting_ || ends_; });
		if (!waiting_)
			return;
		std::function<void()> job = std::exchange(waiting_, nullptr);
		busy_ = true;
		changed_.notify_all();
		lock.unlock();
		doJob(job);
		job = nullptr; // frees what the job holds before the next one begins
		lock.lock();
		busy_ = false;
		changed_.notify_all();
	}
}

void Worker::rethrow()
{
	if (failure_)
		std::rethrow_exception(failure_);
}

void Worker::give(std::function<void()> job)
{
	{
		std::unique_lock lock(mutex_);
		changed_.wait(lock, [&] { return !waiting_; });
		if (!busy_)
			rethrow();
		waiting_ = std::move(job);
	}
	changed_.notify_all();
}

void Worker::finish()
{
	std::unique_lock lock(mutex_);
	changed_.wait(lock, [&] { return !waiting_ && !busy_; });
	rethrow();
}

} // namespace vp::app
