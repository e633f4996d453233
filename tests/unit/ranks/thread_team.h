#pragma once

#include "ranks/team.h"

#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <queue>
#include <thread>
#include <utility>
#include <vector>

namespace vp::ranks
{

// Messages that threads of one process send each other.
class Mailboxes
{
public:
	void put(int from, int to, const Bytes& bytes)
	{
		const std::lock_guard lock(mutex_);
		boxes_[{from, to}].push(bytes);
		changed_.notify_all();
	}
	Bytes take(int from, int to)
	{
		std::unique_lock lock(mutex_);
		std::queue<Bytes>& box = boxes_[{from, to}];
		changed_.wait(lock, [&] { return !box.empty(); });
		Bytes bytes = std::move(box.front());
		box.pop();
		return bytes;
	}

private:
	std::mutex mutex_;
	std::condition_variable changed_;
	std::map<std::pair<int, int>, std::queue<Bytes>> boxes_;
};

// A team of threads.
class ThreadTeam : public Team
{
public:
	ThreadTeam(Mailboxes& mail, int rank, int size) : mail_(mail), rank_(rank), size_(size) {}

	int rank() const override { return rank_; }
	int size() const override { return size_; }
	Bytes sendReceive(int to, const Bytes& bytes, int from) override
	{
		if (to >= 0)
			mail_.put(rank_, to, bytes);
		return from >= 0 ? mail_.take(from, rank_) : Bytes();
	}

private:
	Mailboxes& mail_;
	int rank_;
	int size_;
};

// Runs `work` for each rank on a thread of its own.
inline void withTeam(int ranks, const std::function<void(Team& team)>& work)
{
	Mailboxes mail;
	std::vector<std::jthread> threads;
	for (int rank = 0; rank < ranks; ++rank)
		threads.emplace_back(
		    [&, rank]
		    {
			    ThreadTeam team(mail, rank, ranks);
			    work(team);
		    });
}

} // namespace vp::ranks
