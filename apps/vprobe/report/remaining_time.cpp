#include "report/remaining_time.h"

#include <fmt/format.h>

namespace vp::app
{

std::string RemainingTime::line() const
{
	const std::size_t past = drawn_ + skipped_;
	const std::string where = fmt::format("frame {} of {}", past + 1, frames_);
	if (drawn_ == 0)
		return where;
	const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
	return fmt::format("{}, {:.0f} s left", where,
	                   elapsed.count() / static_cast<double>(drawn_) * static_cast<double>(frames_ - past));
}

} // namespace vp::app
