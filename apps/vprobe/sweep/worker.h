#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace vp::app
{

// Runs jobs on a thread, one after the other, in the order in which they are given. At most one job waits while another
// runs. An exception of a job is thrown again by a later give() or by finish(), and the jobs after it are dropped.
class Worker
{
public:
	explicit Worker(std::string name); // name: the thread's name in traces
	~Worker();                         // waits for the jobs that were given
	Worker(const Worker&) = delete;
	Worker& operator=(const Worker&) = delete;

	void give(std::function<void()> job); // waits until no other job waits
	void finish();                        // waits until all jobs are done

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
	std::thread thread_; // must be the last member
};

} // namespace vp::app
