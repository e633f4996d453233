#include "mpi_team.h"

#define OMPI_SKIP_MPICXX 1
#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <thread>
#include <vector>

namespace vp::app
{

namespace
{

constexpr int kFailed = 1; // the tag of a message without bytes; all others have 0

constexpr std::size_t kMaxAtOnce = std::size_t(1) << 30; // MPI counts bytes in an int

// MPI's own wait keeps a whole core busy. Ranks share cores with the threads of other ranks that still work.
void waitFor(std::vector<MPI_Request>& requests)
{
	std::chrono::microseconds nap(20);
	for (int done = 0;;)
	{
		MPI_Testall(static_cast<int>(requests.size()), requests.data(), &done, MPI_STATUSES_IGNORE);
		if (done)
			return requests.clear();
		std::this_thread::sleep_for(nap);
		nap = std::min(2 * nap, std::chrono::microseconds(1000));
	}
}

// Calls visit(offset, bytes) for each message.
template <class Visit>
void forMessages(std::size_t size, const Visit& visit)
{
	for (std::size_t at = 0; at < size; at += kMaxAtOnce)
		visit(at, static_cast<int>(std::min(kMaxAtOnce, size - at)));
}

} // namespace

MpiTeam::MpiTeam(int* argc, char*** argv)
{
	// hwloc, which MPI asks for the machine's topology, would look for X displays, and end the program when one ends.
	setenv("HWLOC_COMPONENTS", "-gl", 0);
	int provided = 0;
	MPI_Init_thread(argc, argv, MPI_THREAD_FUNNELED, &provided);
	MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
	MPI_Comm_size(MPI_COMM_WORLD, &size_);
}

MpiTeam::~MpiTeam()
{
	MPI_Finalize();
}

ranks::Bytes MpiTeam::sendReceive(int to, const ranks::Bytes& bytes, int from)
{
	std::vector<MPI_Request> requests;
	const std::uint64_t sent = bytes.size();
	std::uint64_t coming = 0;
	if (to >= 0)
		MPI_Isend(&sent, 1, MPI_UINT64_T, to, 0, MPI_COMM_WORLD, &requests.emplace_back());
	if (from >= 0)
		MPI_Irecv(&coming, 1, MPI_UINT64_T, from, 0, MPI_COMM_WORLD, &requests.emplace_back());
	waitFor(requests);
	ranks::Bytes received(coming);
	forMessages(to >= 0 ? bytes.size() : 0, [&](std::size_t at, int count)
	            { MPI_Isend(bytes.data() + at, count, MPI_BYTE, to, 0, MPI_COMM_WORLD, &requests.emplace_back()); });
	forMessages(received.size(),
	            [&](std::size_t at, int count) {
		            MPI_Irecv(received.data() + at, count, MPI_BYTE, from, 0, MPI_COMM_WORLD, &requests.emplace_back());
	            });
	waitFor(requests);
	return received;
}

bool MpiTeam::failsFirst(std::chrono::milliseconds patience) const
{
	using Clock = std::chrono::steady_clock;
	for (int rank = rank_ + 1; rank < size_; ++rank)
	{
		MPI_Request sent; // no one waits for it: the end of all ranks is near
		MPI_Isend(nullptr, 0, MPI_BYTE, rank, kFailed, MPI_COMM_WORLD, &sent);
		MPI_Request_free(&sent);
	}
	const Clock::time_point end = Clock::now() + patience;
	for (;;)
	{
		int heard = 0;
		MPI_Iprobe(MPI_ANY_SOURCE, kFailed, MPI_COMM_WORLD, &heard, MPI_STATUS_IGNORE);
		if (heard)
			return false;
		if (Clock::now() >= end)
			return true;
		std::this_thread::sleep_for(std::chrono::milliseconds(5));
	}
}

void MpiTeam::abort(int status)
{
	MPI_Abort(MPI_COMM_WORLD, status);
	std::abort();
}

} // namespace vp::app
