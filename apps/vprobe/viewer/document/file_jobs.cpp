#include "viewer/document/file_jobs.h"

namespace vp::app
{

Notice noticeOf(const Status& status, std::string words)
{
	return status ? Notice{std::move(words), false, {}} : Notice{status.error().message, true, {}};
}

FileJobs::~FileJobs()
{
	for (const Job& job : jobs_)
		job.notice.wait();
}

void FileJobs::run(std::string file, std::function<Notice()> job)
{
	jobs_.push_back({std::move(file), std::async(std::launch::async,
	                                             [job = std::move(job), wake = wake_]
	                                             {
		                                             Notice notice = job();
		                                             wake();
		                                             return notice;
	                                             })});
}

std::vector<std::string> FileJobs::files() const
{
	std::vector<std::string> files;
	for (const Job& job : jobs_)
		files.push_back(job.file);
	return files;
}

std::vector<Notice> FileJobs::takeDone()
{
	std::vector<Notice> done;
	const auto take = [&](Job& job)
	{
		if (job.notice.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
			return false;
		done.push_back(job.notice.get());
		return true;
	};
	std::erase_if(jobs_, take);
	return done;
}

} // namespace vp::app
