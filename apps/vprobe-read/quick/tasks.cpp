#include "tasks.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>

namespace vp::reader::quick
{

void Tasks::add(std::size_t parts, Part work)
{
	jobs_.push_back({parts_, std::move(work)});
	parts_ += parts;
}

void Tasks::workOn(std::size_t part, arrays::Scratch& scratch) const
{
	const auto behind = std::upper_bound(jobs_.begin(), jobs_.end(), part,
	                                     [](std::size_t wanted, const Job& job) { return wanted < job.first; });
	behind[-1].work(part - behind[-1].first, scratch);
}

void Tasks::run()
{
	std::atomic<std::size_t> next{0};
	std::mutex mutex;
	std::exception_ptr error;
	const auto work = [&]
	{
		try
		{
			arrays::Scratch scratch;
			for (std::size_t part = next++; part < parts_; part = next++)
				workOn(part, scratch);
		}
		catch (...)
		{
			next = parts_;
			const std::lock_guard lock(mutex);
			if (!error)
				error = std::current_exception();
		}
	};
	{
		std::vector<std::jthread> others;
		const auto most = std::min<std::size_t>(static_cast<std::size_t>(std::max(threads_, 1)), parts_);
		try
		{
			while (others.size() + 1 < most)
				others.emplace_back(work);
		}
		catch (const std::system_error&)
		{
			// Fewer threads than requested are enough.
		}
		work();
	}
	jobs_.clear();
	parts_ = 0;
	if (error)
		std::rethrow_exception(error);
}

} // namespace vp::reader::quick
