#pragma once

#include "base/vec.h"
#include "cases/cell_walk.h"

#include <cmath>
#include <span>
#include <vector>

namespace vp::cases
{

// A point of a face: its place, and its height over the surface.
struct FacePoint
{
	Vec3 place;
	double height;
};

// Tells which crossings of a face belong together, if the surface cuts more than two of its edges.
//
// The mean of the face's points decides if it sees all of them: the mean of their heights is the height there. That is
// exact for a plane and the fan of triangles about the mean. Otherwise the order of the crossings along the surface's
// trace in the face decides. It is right for a plane and any simple polygon that is flat, and for a bent surface whose
// trace does not turn back. A face whose points are off its plane by more than kMaxWarp has no such trace, and the mean
// decides again.
//
// Both cells of a face get the same answer to the last bit, although they list its points the other way round, or from
// another one on.
class FacePairs
{
public:
	// face: in order around. crossings: of the face. placeOf(crossing) is where it lies. Puts the crossings in order if
	// that is the answer.
	template <class PlaceOf>
	Pairing of(std::span<const FacePoint> face, std::span<Crossing> crossings, PlaceOf&& placeOf)
	{
		if (isMeanEnough(face))
			return byMean(face);
		const Vec3 along = traceOf(face);
		const double square = glm::dot(along, along);
		if (!(square > 0.0 && std::isfinite(square))) // NaN too
			return byMean(face);
		placed_.clear();
		for (const Crossing& crossing : crossings)
			placed_.push_back(placeOf(crossing));
		sort(crossings, along, lowest(face));
		return Pairing::in_order;
	}

	// A crossing lies at `place`, and moves by `shift` if the surface sinks: that tells the order of those at one
	// point.
	struct Placed
	{
		Vec3 place;
		Vec3 shift;
	};

private:
	static constexpr double kMaxWarp = 0.1; // share of the points' distance from the mean

	// Returns true if all triangles about the mean of the points run the same way, or the face is far from flat.
	bool isMeanEnough(std::span<const FacePoint> face);
	Pairing byMean(std::span<const FacePoint> face);
	// Returns where the trace of the surface in the face leads, either way: the integral of the height around the face.
	Vec3 traceOf(std::span<const FacePoint> face);
	static Vec3 lowest(std::span<const FacePoint> face);
	void sort(std::span<Crossing> crossings, const Vec3& along, const Vec3& origin);

	// Sums that do not depend on the order of the terms. If all terms change their sign, so does the sum.
	double sum();
	template <class Term>
	Vec3 sumOf(std::span<const FacePoint> face, Term&& term);

	std::vector<double> terms_;
	std::vector<double> negative_terms_;
	std::vector<Placed> placed_;
};

} // namespace vp::cases
