#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace vp::app
{

// A thread that does one job after the other, in the order they are given. One may wait while another is being done.
// What a job throws comes out of a later give(), or of finish(), and the jobs after it are dropped.
class Worker
{
public:
	explicit Worker(std::string name); // in traces
	~Worker();                         // after the jobs that were given
	Worker(const Worker&) = delete;
	Worker& operator=(const Worker&) = delete;

	void give(std::function<void()> job); // waits while there is one waiting
	void finish();                        // waits until all are done

private:
	void work();
	void doJob(const std::function<void()>& job);
	void rethrow();

	std::mutex mutex_;
	std::condition_variable changed_;
	std::function<void()> waiting_; // or empty
	bool busy_ = false;
	bool ends_ = false;
	std::exception_ptr failure_;
	std::thread thread_; // the last to be made
};

} // namespace vp::app
