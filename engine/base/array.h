#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace vp
{

// A read-only array whose memory may be a vector or a mapping that the file reader left in shared memory; copies share
// it.
template <class T>
class Array
{
public:
	Array() = default;
	Array(std::vector<T> values)
	{
		auto owned = std::make_shared<const std::vector<T>>(std::move(values));
		data_ = owned->data();
		size_ = owned->size();
		owner_ = std::move(owned);
	}
	// `data` stays valid as long as `owner` does.
	Array(std::shared_ptr<const void> owner, const T* data, std::size_t size)
	    : owner_(std::move(owner)), data_(data), size_(size)
	{
	}

	const T& operator[](std::size_t i) const { return data_[i]; }
	const T* data() const { return data_; }
	std::size_t size() const { return size_; }
	bool empty() const { return size_ == 0; }
	std::span<const T> span() const { return {data_, size_}; }
	const std::shared_ptr<const void>& owner() const { return owner_; }

private:
	std::shared_ptr<const void> owner_;
	const T* data_ = nullptr;
	std::size_t size_ = 0;
};

} // namespace vp
