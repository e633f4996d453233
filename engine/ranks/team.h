#pragma once

#include "ranks/message.h"

#include <cstdint>
#include <functional>
#include <span>
#include <type_traits>
#include <vector>

namespace vp::ranks
{

/// Processes that hold the parts of a data set together, one rank each. All ranks run the same program with the same
/// settings, and make these calls in the same order. A rank that fails ends all (apps/vprobe-mpi); so no call fails.
///
/// Only the first three functions know how bytes travel. The others go along trees, so their time grows with the
/// logarithm of the number of ranks, but for exchange(), which has a message for each pair.
/// ranks/neighborhood.h says which pairs are enough.
class Team
{
public:
	virtual ~Team() = default;

	virtual int rank() const = 0;
	virtual int size() const = 0;
	/// Sends bytes to one rank and receives from another at the same time. A negative rank stands for none; what comes
	/// from there is empty.
	virtual Bytes sendReceive(int to, const Bytes& bytes, int from) = 0;

	bool isFirst() const { return rank() == 0; }
	void send(int to, const Bytes& bytes) { sendReceive(to, bytes, -1); }
	Bytes receive(int from) { return sendReceive(-1, {}, from); }

	/// Brings what all ranks have together at the first one: add(into, other) adds what came from higher ranks. The
	/// other ranks are left with a part.
	void reduce(Bytes& own, const std::function<void(Bytes& into, const Bytes& other)>& add);
	/// Gives all ranks what the first one has.
	void broadcast(Bytes& bytes);
	/// Gives every rank what each has, by rank.
	std::vector<Bytes> gatherAll(const Bytes& own);
	/// Sends to[r] to rank r. Returns what came from each.
	std::vector<Bytes> exchange(std::vector<Bytes> to);
	/// The same with some other ranks only (ascending). Who names one is named by it.
	std::vector<Bytes> exchange(std::vector<Bytes> to, std::span<const int> with);
};

/// Gives every rank the sum of what all have, by add(into, other).
template <class T, class Add>
requires std::is_trivially_copyable_v<T>
void sumOverAll(Team& team, T& value, const Add& add)
{
	const auto bytesOf = [](const T& of)
	{
		MessageWriter message;
		message.put(of);
		return message.take();
	};
	Bytes bytes = bytesOf(value);
	team.reduce(bytes,
	            [&](Bytes& into, const Bytes& other)
	            {
		            T sum = MessageReader(into).get<T>();
		            add(sum, MessageReader(other).get<T>());
		            into = bytesOf(sum);
	            });
	team.broadcast(bytes);
	value = MessageReader(bytes).get<T>();
}

/// Returns true if it is true at any rank.
bool anyOf(Team& team, bool own);

} // namespace vp::ranks
