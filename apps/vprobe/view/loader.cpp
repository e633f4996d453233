#include "view/loader.h"

#include <fmt/format.h>

#include <atomic>
#include <new>

namespace vp::app
{

struct Loader::Job
{
	ProbeOptions options;
	std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
	std::optional<Result<std::unique_ptr<Session>>> opened;
	std::atomic<bool> done = false; // `opened` is there
	std::jthread thread;            // the last to be made
};

Loader::Loader(std::shared_ptr<gpu::Device> device, std::function<void()> wake)
    : device_(std::move(device)), wake_(std::move(wake))
{
}

Loader::~Loader()
{
	cancel();
}

void Loader::begin(ProbeOptions options)
{
	cancel();
	job_ = std::make_unique<Job>();
	job_->options = std::move(options);
	job_->thread = std::jthread(
	    [job = job_.get(), device = device_, wake = wake_](const std::stop_token& stop)
	    {
		    nameThreadRow("loader");
		    try
		    {
			    ProbeOptions options = job->options;
			    options.may_scan = true; // the first picture comes before the neighbors do
			    job->opened = openSession(options, DeviceUse::draw, Timeline::Keep::sections, device, stop);
		    }
		    catch (const std::bad_alloc&)
		    {
			    job->opened = Error{ErrorKind::input, fmt::format("{}: does not fit into memory; close what is shown, "
			                                                      "or use a machine with more memory",
			                                                      job->options.inputs.front())};
		    }
		    job->done = true;
		    wake();
	    });
}

void Loader::cancel()
{
	drop();
	if (!job_)
		return;
	job_->thread.request_stop();
	cancelled_.push_back(std::move(job_));
}

void Loader::drop()
{
	std::erase_if(cancelled_, [](const auto& job) { return job->done.load(); });
}

double Loader::seconds() const
{
	return job_ ? std::chrono::duration<double>(std::chrono::steady_clock::now() - job_->start).count() : 0.0;
}

std::string Loader::what() const
{
	return job_ ? fmt::format("{}", fmt::join(job_->options.inputs, ", ")) : std::string();
}

std::optional<Loader::Loaded> Loader::take()
{
	drop();
	if (!job_ || !job_->done)
		return std::nullopt;
	const std::unique_ptr<Job> job = std::move(job_);
	job->thread.join();
	return Loaded{std::move(job->options), std::move(*job->opened)};
}

} // namespace vp::app
