#include "traverse/visited.h"

namespace vp::traverse
{

VisitedPool::Loan VisitedPool::borrow()
{
	std::unique_ptr<VisitedMarks> marks;
	{
		const std::lock_guard lock(mutex_);
		if (!idle_.empty())
		{
			marks = std::move(idle_.back());
			idle_.pop_back();
		}
		else
			++made_;
	}
	if (!marks)
		marks = std::make_unique<VisitedMarks>(cells_);
	marks->beginSlice();
	return {marks.release(), [this](VisitedMarks* returned)
	        {
		        const std::lock_guard lock(mutex_);
		        idle_.emplace_back(returned);
	        }};
}

std::size_t VisitedPool::bytes() const
{
	const std::lock_guard lock(mutex_);
	return made_ * cells_;
}

} // namespace vp::traverse
