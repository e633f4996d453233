#include "cases/face_pairs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <tuple>

namespace vp::cases
{

namespace
{

struct OnTrace
{
	double at;
	double shift;
	Crossing crossing;

	std::tuple<double, double> key() const { return {at, shift}; }
};

} // namespace

double FacePairs::sum()
{
	const auto negative = std::partition(terms_.begin(), terms_.end(), [](double term) { return term > 0.0; });
	negative_terms_.assign(negative, terms_.end());
	terms_.erase(negative, terms_.end());
	std::ranges::sort(terms_);
	std::ranges::sort(negative_terms_, std::greater<>());
	double positive_sum = 0.0;
	double negative_sum = 0.0;
	for (const double term : terms_)
		positive_sum += term;
	for (const double term : negative_terms_)
		negative_sum += term;
	return positive_sum + negative_sum;
}

template <class Term>
Vec3 FacePairs::sumOf(std::span<const FacePoint> face, Term&& term)
{
	Vec3 sums;
	for (int axis = 0; axis < 3; ++axis)
	{
		terms_.clear();
		for (std::size_t i = 0; i < face.size(); ++i)
			terms_.push_back(term(face[i], face[i + 1 < face.size() ? i + 1 : 0])[axis]);
		sums[axis] = sum();
	}
	return sums;
}

bool FacePairs::isMeanEnough(std::span<const FacePoint> face)
{
	const Vec3 origin = lowest(face);
	const Vec3 mean = sumOf(face, [&](const FacePoint& p, const FacePoint&) { return p.place - origin; }) /
	                  static_cast<double>(face.size());
	const auto spoke = [&](const FacePoint& p) { return (p.place - origin) - mean; };
	const auto turn = [&](const FacePoint& p, const FacePoint& q) { return glm::cross(spoke(p), spoke(q)); };
	const Vec3 normal = sumOf(face, turn);
	bool sees_all = true;
	double off = 0.0;
	double size = 0.0;
	for (std::size_t i = 0; i < face.size(); ++i)
	{
		const FacePoint& next = face[i + 1 < face.size() ? i + 1 : 0];
		sees_all = sees_all && glm::dot(turn(face[i], next), normal) >= 0.0;
		off = std::max(off, std::abs(glm::dot(spoke(face[i]), normal)));
		size = std::max(size, glm::length(spoke(face[i])));
	}
	return sees_all || !(off <= kMaxWarp * size * glm::length(normal));
}

Pairing FacePairs::byMean(std::span<const FacePoint> face)
{
	terms_.clear();
	for (const FacePoint& p : face)
		terms_.push_back(p.height);
	std::ranges::sort(terms_);
	double heights = 0.0;
	for (const double height : terms_)
		heights += height;
	return heights >= 0.0 ? Pairing::negative_apart : Pairing::positive_apart;
}

Vec3 FacePairs::traceOf(std::span<const FacePoint> face)
{
	Vec3 along =
	    sumOf(face, [](const FacePoint& p, const FacePoint& q) { return (p.height + q.height) * (q.place - p.place); });
	for (int axis = 0; axis < 3; ++axis)
		if (along[axis] != 0.0)
			return along[axis] < 0.0 ? -along : along;
	return along;
}

Vec3 FacePairs::lowest(std::span<const FacePoint> face)
{
	Vec3 low = face.front().place;
	for (const FacePoint& p : face)
		low = glm::min(low, p.place);
	return low;
}

void FacePairs::sort(std::span<Crossing> crossings, const Vec3& along, const Vec3& origin)
{
	std::vector<OnTrace> sorted;
	for (std::size_t i = 0; i < crossings.size(); ++i)
		sorted.push_back({glm::dot(placed_[i].place - origin, along), glm::dot(placed_[i].shift, along), crossings[i]});
	std::ranges::sort(sorted, {}, &OnTrace::key);
	// Two that nothing tells apart, as on an edge that the face runs along both ways: what is open is closed first.
	int open = 0;
	for (std::size_t i = 0; i < sorted.size(); ++i)
	{
		if (i + 1 < sorted.size() && sorted[i].key() == sorted[i + 1].key() && open != 0 &&
		    (open > 0) == sorted[i].crossing.leaves)
			std::swap(sorted[i], sorted[i + 1]);
		open += sorted[i].crossing.leaves ? 1 : -1;
		crossings[i] = sorted[i].crossing;
	}
}

} // namespace vp::cases
