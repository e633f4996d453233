#include "render/annotate/box_axes.h"

#include "render/scene/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::render
{

namespace
{

constexpr double kTick = 0.35;        // length, em
constexpr double kAxisLabelGap = 0.3; // em
constexpr double kShortest = 3.0;     // an axis seen shorter than this, em, has no numbers
constexpr double kBetweenTicks = 3.5; // em, at least

class Numbers
{
public:
	Numbers(const Layout& layout, const std::string& units, Canvas& pen)
	    : pen_(pen), units_(units),
	      em_(layout.em), picture_{{0.0, 0.0}, {layout.frame.width, layout.frame.height}}, taken_{layout.title,
	                                                                                              layout.caption}
	{
		for (const LegendLayout& legend : layout.legends)
			taken_.push_back(legend.column);
	}

	void write(int axis, const Box& box, const AxisEdge& edge, const Camera& camera, const Frame& frame)
	{
		const glm::dvec2 from = camera.project(edge.from, frame);
		const glm::dvec2 to = camera.project(edge.to, frame);
		const double seen = glm::length(to - from);
		if (seen < kShortest * em_)
			return;
		pen_.line(from, to);
		const Ticks ticks = makeTicks(box.lo[axis], box.hi[axis],
		                              std::clamp(static_cast<int>(seen / (kBetweenTicks * em_)), 3, 7), kNarrowestAxis);
		const double extent = box.hi[axis] - box.lo[axis];
		double reach = 0.0;
		for (const Tick& tick : ticks.marks)
		{
			const double part = (tick.value - box.lo[axis]) / extent;
			const glm::dvec2 at = camera.project(edge.from + part * (edge.to - edge.from), frame);
			pen_.line(at, at + kTick * em_ * edge.outward);
			reach =
			    std::max(reach, beside(at, edge.outward, (kTick + kAxisLabelGap) * em_, tick.label, pen_.inks().text));
		}
		const Color colors[] = {pen_.inks().x, pen_.inks().y, pen_.inks().z};
		std::string name(1, static_cast<char>('x' + axis));
		if (!units_.empty())
			name += " [" + units_ + "]";
		if (!ticks.factor.empty())
			name += " " + ticks.factor;
		beside(0.5 * (from + to), edge.outward, std::max(reach, kTick * em_) + kAxisLabelGap * em_, name, colors[axis]);
	}

private:
	// Words `gap` pixels off a point; how far they reach from it, or the gap where there is no room for them.
	double beside(const glm::dvec2& at, const glm::dvec2& outward, double gap, const std::string& words, Color color)
	{
		const glm::dvec2 half{0.5 * pen_.lettering().width(words, em_), 0.5 * em_};
		const double depth = half.x * std::abs(outward.x) + half.y * std::abs(outward.y);
		const glm::dvec2 center = at + (gap + depth) * outward;
		const Area area{center - half, center + half};
		const bool inside =
		    area.lo.x >= 0.0 && area.lo.y >= 0.0 && area.hi.x <= picture_.hi.x && area.hi.y <= picture_.hi.y;
		if (!inside || std::any_of(taken_.begin(), taken_.end(), [&](const Area& a) { return a.overlaps(area); }))
			return gap;
		taken_.push_back({area.lo - 0.15 * em_, area.hi + 0.15 * em_});
		pen_.text(area.lo, em_, color, words);
		return gap + 2.0 * depth;
	}

	Canvas& pen_;
	const std::string& units_;
	double em_;
	Area picture_;
	std::vector<Area> taken_;
};

} // namespace

bool facesEye(const Box& box, const Vec3& eye, int axis, bool high)
{
	return high ? eye[axis] > box.hi[axis] : eye[axis] < box.lo[axis];
}

std::array<std::optional<AxisEdge>, 3> axisEdges(const Box& box, const Camera& camera, const Frame& frame)
{
	std::array<std::optional<AxisEdge>, 3> edges;
	glm::dvec2 middle(0.0);
	for (int i = 0; i < 8; ++i)
	{
		if (glm::dot(corner(box, i) - camera.position, camera.forward()) < camera.near)
			return edges;
		middle += camera.project(corner(box, i), frame) / 8.0;
	}
	for (int axis = 0; axis < 3; ++axis)
	{
		if (!(box.hi[axis] > box.lo[axis]))
			continue;
		double best = -std::numeric_limits<double>::infinity();
		const int b = (axis + 1) % 3;
		const int c = (axis + 2) % 3;
		for (const bool high_b : {false, true})
			for (const bool high_c : {false, true})
			{
				// On the contour one of the two faces at the edge is seen, the other is not.
				if (facesEye(box, camera.position, b, high_b) == facesEye(box, camera.position, c, high_c))
					continue;
				const int at = (high_b ? 1 << b : 0) | (high_c ? 1 << c : 0);
				const Vec3 from = corner(box, at);
				const Vec3 to = corner(box, at | 1 << axis);
				const glm::dvec2 p = camera.project(from, frame);
				const glm::dvec2 q = camera.project(to, frame);
				const glm::dvec2 off = 0.5 * (p + q) - middle;
				const double score = off.y - 0.6 * off.x;
				if (score <= best || glm::length(q - p) < 1e-6)
					continue;
				best = score;
				const glm::dvec2 across = glm::normalize(glm::dvec2(q.y - p.y, p.x - q.x));
				edges[axis] = AxisEdge{from, to, glm::dot(across, off) < 0.0 ? -across : across};
			}
	}
	return edges;
}

void writeBoxAxes(const Box& box, const Camera& camera, const Layout& layout, const std::string& units, Canvas& pen)
{
	const auto edges = axisEdges(box, camera, layout.frame);
	Numbers numbers(layout, units, pen);
	for (int axis = 0; axis < 3; ++axis)
		if (edges[axis])
			numbers.write(axis, box, *edges[axis], camera, layout.frame);
}

} // namespace vp::render
