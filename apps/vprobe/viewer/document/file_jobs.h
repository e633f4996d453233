#pragma once

#include "base/result.h"
#include "viewer/document/notice.h"

#include <functional>
#include <future>
#include <string>
#include <vector>

namespace vp::app
{

// Returns the notice of a job that is done: `words`, or why it failed.
Notice noticeOf(const Status& status, std::string words);

// Writes files on threads of their own, while the window stays responsive.
class FileJobs
{
public:
	explicit FileJobs(std::function<void()> wake) : wake_(std::move(wake)) {}
	~FileJobs(); // waits until all files are written
	FileJobs(const FileJobs&) = delete;
	FileJobs& operator=(const FileJobs&) = delete;

	void run(std::string file, std::function<Notice()> job);
	std::vector<Notice> takeDone();
	bool isIdle() const { return jobs_.empty(); }
	std::vector<std::string> files() const; // files that are being written

private:
	std::function<void()> wake_;
	struct Job
	{
		std::string file;
		std::future<Notice> notice;
	};
	std::vector<Job> jobs_; // jobs that are under way
};

} // namespace vp::app
