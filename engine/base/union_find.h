#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace vp
{

// Sets of things that are numbered from 0, joined two by two. The least of a set stands for it.
class UnionFind
{
public:
	explicit UnionFind(std::size_t things) : parent_(things), count_(things)
	{
		std::iota(parent_.begin(), parent_.end(), 0u);
	}

	void join(std::uint32_t a, std::uint32_t b)
	{
		a = root(a);
		b = root(b);
		if (a == b)
			return;
		parent_[std::max(a, b)] = std::min(a, b);
		--count_;
	}
	std::uint32_t root(std::uint32_t v)
	{
		while (parent_[v] != v)
			v = parent_[v] = parent_[parent_[v]]; // path halving
		return v;
	}
	std::size_t count() const { return count_; }
	std::size_t size() const { return parent_.size(); }

private:
	std::vector<std::uint32_t> parent_;
	std::size_t count_;
};

} // namespace vp
