#pragma once

#include "grid/link/face_key.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace vp::grid
{

constexpr std::uint32_t kNoSlot = 0xFFFFFFFFu;

// Up to this many faces with one lowest point are compared with each other. In a mesh of tetrahedra there are about 24.
// At the tip of a fan there may be thousands, which are sorted.
constexpr std::size_t kMaxCompared = 128;

struct KeyedSlot
{
	FaceKey key;
	std::uint32_t slot;
};

// Faces with the same points.
struct Meeting
{
	FaceKey key;
	std::uint32_t first;
	std::uint32_t second = kNoSlot;
};

// The faces about one point, by their other points; at most kMaxCompared of them.
class Meetings
{
public:
	Meetings() { places_.fill(kFree); }

	// Calls crowd(meeting, slot) for every third and further face of a meeting.
	template <class Crowd>
	void meet(const FaceKey& key, std::uint32_t slot, Crowd&& crowd)
	{
		std::size_t place = key.hash() >> (32 - kPlaceBits);
		for (; places_[place] != kFree; place = (place + 1) % places_.size())
		{
			Meeting& known = meetings_[places_[place]];
			if (!(known.key == key))
				continue;
			if (known.second == kNoSlot)
				known.second = slot;
			else
				crowd(static_cast<std::uint32_t>(places_[place]), slot);
			return;
		}
		places_[place] = static_cast<std::uint8_t>(count_);
		taken_[count_] = static_cast<std::uint8_t>(place);
		meetings_[count_++] = {key, slot};
	}
	const Meeting& operator[](std::size_t m) const { return meetings_[m]; }
	std::span<const Meeting> all() const { return {meetings_.data(), count_}; }
	void clear()
	{
		for (std::size_t m = 0; m < count_; ++m)
			places_[taken_[m]] = kFree;
		count_ = 0;
	}

private:
	static constexpr int kPlaceBits = 8;
	static constexpr std::uint8_t kFree = 0xFF;

	std::array<std::uint8_t, 1 << kPlaceBits> places_; // hash table of indices of meetings
	std::array<std::uint8_t, kMaxCompared> taken_;     // per meeting: its place in the hash table
	std::array<Meeting, kMaxCompared> meetings_;
	std::size_t count_ = 0;
};

} // namespace vp::grid
