#include "viewer/file_jobs.h"

namespace vp::app
{

Notice noticeOf(const Status& status, std::string words)
{
	return status ? Notice{std::move(words), false, {}} : Notice{status.error().message, true, {}};
}

FileJobs::~FileJobs()
{
	for (std::future<Notice>& job : jobs_)
		job.wait();
}

void FileJobs::run(std::function<Notice()> job)
{
	jobs_.push_back(std::async(std::launch::async,
	                           [job = std::move(job), wake = wake_]
	                           {
		                           Notice notice = job();
		                           wake();
		                           return notice;
	                           }));
}

std::vector<Notice> FileJobs::takeDone()
{
	std::vector<Notice> done;
	const auto take = [&](std::future<Notice>& job)
	{
		if (job.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
			return false;
		done.push_back(job.get());
		return true;
	};
	std::erase_if(jobs_, take);
	return done;
}

} // namespace vp::app
