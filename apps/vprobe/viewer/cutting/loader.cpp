#include "viewer/cutting/loader.h"

#include <fmt/format.h>

#include <atomic>
#include <new>

namespace vp::app
{

struct Loader::Job
{
	view::ViewSpec spec;
	std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
	std::optional<Result<std::unique_ptr<session::Session>>> opened;
	std::atomic<bool> done = false; // `opened` is there
	std::jthread thread;            // must be the last member
};

Loader::Loader(std::shared_ptr<gpu::Device> device, std::function<void()> wake, Timeline::Keep keep)
    : device_(std::move(device)), wake_(std::move(wake)), keep_(keep)
{
}

Loader::~Loader()
{
	cancel();
}

void Loader::begin(view::ViewSpec spec)
{
	cancel();
	job_ = std::make_unique<Job>();
	job_->spec = std::move(spec);
	job_->thread = std::jthread(
	    [job = job_.get(), device = device_, wake = wake_, keep = keep_](const std::stop_token& stop)
	    {
		    nameThreadRow("loader");
		    try
		    {
			    job->opened = session::Session::open(job->spec, {.use = session::DeviceUse::draw,
			                                                     // The first picture comes before the neighbors do.
			                                                     .expect = session::Expect::first_of_many,
			                                                     .frames_alone = true,
			                                                     .keep = keep,
			                                                     .device = device,
			                                                     .stop = stop});
		    }
		    catch (const std::bad_alloc&)
		    {
			    job->opened = Error{ErrorKind::input, fmt::format("{}: does not fit into memory; close what is shown, "
			                                                      "or use a machine with more memory",
			                                                      job->spec.input.files.front())};
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
	return job_ ? fmt::format("{}", fmt::join(job_->spec.input.files, ", ")) : std::string();
}

std::optional<Loader::Loaded> Loader::take()
{
	drop();
	if (!job_ || !job_->done)
		return std::nullopt;
	const std::unique_ptr<Job> job = std::move(job_);
	job->thread.join();
	return Loaded{std::move(job->spec), std::move(*job->opened)};
}

} // namespace vp::app
