#include "cases/face_pairs.h"

#include <algorithm>
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
	const auto negative = std::ranges::partition(terms_, [](double term) { return term > 0.0; });
	negative_terms_.assign(negative.begin(), negative.end());
	terms_.erase(negative.begin(), negative.end());
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

bool FacePairs::seesAll(std::span<const FacePoint> face)
{
	const Vec3 origin = lowest(face);
	const Vec3 mean = sumOf(face, [&](const FacePoint& p, const FacePoint&) { return p.place - origin; }) /
	                  static_cast<double>(face.size());
	const auto turn = [&](const FacePoint& p, const FacePoint& q)
	{ return glm::cross((p.place - origin) - mean, (q.place - origin) - mean); };
	const Vec3 normal = sumOf(face, turn);
	for (std::size_t i = 0; i < face.size(); ++i)
		if (glm::dot(turn(face[i], face[i + 1 < face.size() ? i + 1 : 0]), normal) < 0.0)
			return false;
	return true;
}

bool FacePairs::isMeanPositive(std::span<const FacePoint> face)
{
	terms_.clear();
	for (const FacePoint& p : face)
		terms_.push_back(p.height);
	std::ranges::sort(terms_);
	double heights = 0.0;
	for (const double height : terms_)
		heights += height;
	return heights >= 0.0;
}

Vec3 FacePairs::traceOf(std::span<const FacePoint> face)
{
	Vec3 along = sumOf(face, [](const FacePoint& p, const FacePoint& q)
	                   { return (p.height + q.height) * (q.place - p.place); });
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
		sorted.push_back(
		    {glm::dot(placed_[i].place - origin, along), glm::dot(placed_[i].shift, along), crossings[i]});
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
