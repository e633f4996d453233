#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace vp
{

// Objects that running cuts borrow and give back. It makes as many as are lent at the same time. It is thread safe, and
// must outlive its loans.
template <class T>
class Pool
{
public:
	explicit Pool(std::function<std::unique_ptr<T>()> make) : make_(std::move(make)) {}

	using Loan = std::unique_ptr<T, std::function<void(T*)>>;

	Loan borrow()
	{
		std::unique_ptr<T> lent;
		{
			const std::lock_guard lock(mutex_);
			if (idle_.empty())
			{
				idle_.reserve(made_ + 1); // so that a loan comes back without asking for memory
				++made_;
			}
			else
			{
				lent = std::move(idle_.back());
				idle_.pop_back();
			}
		}
		if (!lent)
			lent = make_();
		return {lent.release(), [this](T* returned)
		        {
			        const std::lock_guard lock(mutex_);
			        idle_.emplace_back(returned);
		        }};
	}

	// of: a function of what lies here; what is lent is not asked.
	template <class Of>
	std::size_t sumOfIdle(Of&& of) const
	{
		const std::lock_guard lock(mutex_);
		std::size_t sum = 0;
		for (const std::unique_ptr<T>& each : idle_)
			sum += of(*each);
		return sum;
	}

	std::size_t made() const
	{
		const std::lock_guard lock(mutex_);
		return made_;
	}

private:
	std::function<std::unique_ptr<T>()> make_;
	mutable std::mutex mutex_;
	std::vector<std::unique_ptr<T>> idle_;
	std::size_t made_ = 0;
};

} // namespace vp
