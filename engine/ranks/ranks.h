#pragma once

#include "ranks/team.h"

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace vp::ranks
{

struct ParticleBorders; // particles/particle_borders.h
struct Share;           // data/share.h

/// The processes that hold a data set together, as one of them sees them. This is the face of the room: code outside
/// does not ask whether there are several. With one process, which is alone(), each function that takes Ranks returns
/// at once what that process has by itself. With several, all of them make the same calls in the same order, and get
/// what one process would have that holds all of the data. Functions say so where a rank gets a part, or only the first
/// one gets the whole.
class Ranks
{
public:
	/// One process that has all of a data set.
	static Ranks alone() { return Ranks(nullptr); }
	/// The ranks of a team, which outlives them; null stands for one process. share: what readInputs() finds out.
	explicit Ranks(Team* team, std::shared_ptr<const Share> share = nullptr) : team_(team), share_(std::move(share)) {}

	/// True for the process that writes and prints.
	bool isFirst() const { return !team_ || team_->isFirst(); }

	/// Returns the sum of what all have, by add(into, other).
	template <class T, class Add>
	T sum(T own, const Add& add) const
	{
		if (team_)
			sumOverAll(*team_, own, add);
		return own;
	}
	/// Returns true if it is true anywhere.
	bool any(bool own) const { return team_ ? anyOf(*team_, own) : own; }

	/// Calls may be under way at the same time, and in any order. The calls of several ranks have one order.
	bool mayCallAtOnce() const { return !team_; }
	/// This process holds the blocks of all inputs.
	bool holdsAll() const { return !team_; }
	/// A device may classify cells. Several processes each cut on their processor.
	bool mayUseDevice() const { return !team_; }
	/// Readers build neighbors. A rank of several joins the pieces that it has read first, and builds neighbors then.
	bool buildsWhileReading() const { return !team_; }
	/// Values of another time may take the place of those that are there. Several ranks deal out parts anew: another
	/// time may have other pieces.
	bool keepsParts() const { return !team_; }

	/// Flat pictures are drawn by one process.
	bool mayDrawFlat() const { return !team_; }

	/// To be called when the blocks have changed: what is known of their borders no longer holds.
	void forgetBorders() { borders_.reset(); }
	/// Bytes of layers of pictures that were sent to others.
	std::uint64_t layerBytes() const { return layer_bytes_; }

	// For the files of this room. Null for one process.
	Team* team() const { return team_; }
	const Share& share() const { return *share_; }
	void take(std::shared_ptr<const Share> share) { share_ = std::move(share); }
	std::shared_ptr<const ParticleBorders>& knownBorders() const { return borders_; }
	std::uint64_t& sentBytes() const { return layer_bytes_; }

private:
	Team* team_;
	std::shared_ptr<const Share> share_;                       // with a team
	mutable std::shared_ptr<const ParticleBorders> borders_{}; // of the blocks as they are now, once they are asked for
	mutable std::uint64_t layer_bytes_ = 0;                    // counted while pictures are drawn
};

} // namespace vp::ranks
