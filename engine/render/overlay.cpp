#include "render/overlay.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vp::render
{

namespace
{

ImU32 packed(Color c, double opacity = 1.0)
{
	return IM_COL32(c.r, c.g, c.b, static_cast<int>(std::lround(opacity * c.a)));
}

ImVec2 at(const glm::dvec2& p)
{
	return {static_cast<float>(p.x), static_cast<float>(p.y)};
}

// Dark on light, light on dark.
struct Inks
{
	Color text;
	Color faint; // captions
	Color x;
	Color y;
	Color z;
};

constexpr Inks kOnLight{{38, 43, 50}, {92, 99, 108}, {196, 48, 43}, {38, 132, 66}, {38, 92, 190}};
constexpr Inks kOnDark{{236, 238, 241}, {172, 178, 186}, {255, 116, 106}, {110, 209, 130}, {122, 168, 255}};

class Writer
{
public:
	Writer(const Scene& scene, const Layout& layout, const Lettering& lettering)
	    : scene_(scene), look_(scene.look), layout_(layout), lettering_(lettering),
	      inks_(scene.look.background.dark() ? kOnDark : kOnLight), list_(lettering.shared())
	{
		list_._ResetForNewFrame();
		list_.PushClipRectFullScreen();
		list_.PushTextureID(nullptr);
	}

	void write()
	{
		if (!look_.title.empty())
			text(layout_.title.lo, layout_.title_em, inks_.text,
			     lettering_.elided(look_.title, layout_.title_em, layout_.title.size().x));
		if (!look_.caption.empty())
			text(layout_.caption.lo, layout_.small_em, inks_.faint,
			     lettering_.elided(look_.caption, layout_.small_em, layout_.caption.size().x));
		if (look_.axes)
			axes();
		if (look_.legend && scene_.values)
			legend();
	}

	const ImDrawList& list() const { return list_; }

private:
	void text(const glm::dvec2& top_left, double size, Color color, const std::string& words)
	{
		const glm::dvec2 pixel = glm::round(top_left);
		list_.AddText(lettering_.font(size), static_cast<float>(size), at(pixel), packed(color), words.data(),
		              words.data() + words.size());
	}

	// Text beside a mark: vertically centred on it.
	void label(double x, double y, const std::string& words)
	{
		text({x, y - 0.5 * layout_.em}, layout_.em, inks_.text, words);
	}

	void legend()
	{
		const double em = layout_.em;
		const Area& bar = layout_.bar;
		const double label_x = bar.hi.x + 0.6 * em;
		const auto title = lettering_.wrapped(scene_.values->title, em, layout_.legend_title.size().x, 3);
		double y = layout_.legend_title.hi.y - 1.25 * em * static_cast<double>(title.size());
		for (const std::string& line : title)
		{
			text({layout_.legend_title.lo.x, y}, em, inks_.text, line);
			y += 1.25 * em;
		}
		if (!layout_.ticks.factor.empty())
			text(layout_.factor.lo, em, inks_.text, layout_.ticks.factor);

		colors();
		const auto [lo, hi] = colorRange(*scene_.values, look_);
		for (const Tick& tick : layout_.ticks.marks)
		{
			const double part = hi != lo ? (tick.value - lo) / (hi - lo) : 0.5;
			const double tick_y = bar.hi.y - part * bar.size().y;
			line({bar.hi.x, tick_y}, {bar.hi.x + 0.3 * em, tick_y});
			label(label_x, tick_y, tick.label);
		}
		if (scene_.values->has_nan)
		{
			list_.AddRectFilled(at(layout_.nan.lo), at(layout_.nan.hi), packed(look_.colors.nan));
			list_.AddRect(at(layout_.nan.lo), at(layout_.nan.hi), packed(inks_.text, 0.6), 0.0f, 0, hairline());
			label(label_x, 0.5 * (layout_.nan.lo.y + layout_.nan.hi.y), "NaN");
		}
	}

	void colors()
	{
		const Area& bar = layout_.bar;
		const auto color = [this](int i) { return packed(look_.colors.colors[i]); };
		for (int i = 0; i + 1 < kColorMapSize; ++i)
		{
			const auto y = [&](int step) { return bar.hi.y - step * bar.size().y / (kColorMapSize - 1); };
			list_.AddRectFilledMultiColor(at({bar.lo.x, y(i + 1)}), at({bar.hi.x, y(i)}), color(i + 1), color(i + 1),
			                              color(i), color(i));
		}
		// One line around the bar and its ends.
		const glm::dvec2 top{0.5 * (bar.lo.x + bar.hi.x), bar.lo.y - layout_.cap};
		const glm::dvec2 bottom{top.x, bar.hi.y + layout_.cap};
		std::vector<ImVec2> rim{at(bar.lo), at({bar.hi.x, bar.lo.y}), at(bar.hi), at({bar.lo.x, bar.hi.y})};
		if (layout_.cap > 0.0)
		{
			list_.AddTriangleFilled(at(bar.lo), at(top), at({bar.hi.x, bar.lo.y}), packed(look_.colors.above));
			list_.AddTriangleFilled(at({bar.lo.x, bar.hi.y}), at(bar.hi), at(bottom), packed(look_.colors.below));
			rim = {at(bar.lo), at(top), at({bar.hi.x, bar.lo.y}), at(bar.hi), at(bottom), at({bar.lo.x, bar.hi.y})};
		}
		list_.AddPolyline(rim.data(), static_cast<int>(rim.size()), packed(inks_.text, 0.6), ImDrawFlags_Closed,
		                  hairline());
	}

	void axes()
	{
		struct Axis
		{
			glm::dvec2 tip; // from the centre, in lengths of the axis
			double depth;
			Color color;
			const char* name;
		};
		const Camera& camera = scene_.camera;
		const auto axis = [&](const Vec3& direction, Color color, const char* name)
		{
			return Axis{{glm::dot(direction, camera.right()), -glm::dot(direction, camera.trueUp())},
			            glm::dot(direction, camera.forward()),
			            color,
			            name};
		};
		std::array<Axis, 3> axes{axis({1.0, 0.0, 0.0}, inks_.x, "x"), axis({0.0, 1.0, 0.0}, inks_.y, "y"),
		                         axis({0.0, 0.0, 1.0}, inks_.z, "z")};
		std::sort(axes.begin(), axes.end(), [](const Axis& a, const Axis& b) { return a.depth > b.depth; });

		const double em = layout_.em;
		const glm::dvec2 centre = 0.5 * (layout_.axes.lo + layout_.axes.hi);
		const double length = 1.9 * em;
		for (const Axis& a : axes)
		{
			const double seen = glm::length(a.tip);
			const glm::dvec2 tip = centre + length * a.tip;
			if (seen > 0.15)
			{
				const glm::dvec2 along = a.tip / seen;
				const glm::dvec2 across{-along.y, along.x};
				const double head = std::min(0.55 * em, 0.7 * length * seen);
				list_.AddLine(at(centre), at(tip - head * along), packed(a.color),
				              static_cast<float>(std::max(1.5, 0.14 * em)));
				const std::array<ImVec2, 3> triangle{at(tip), at(tip - head * along + 0.42 * head * across),
				                                     at(tip - head * along - 0.42 * head * across)};
				list_.AddConvexPolyFilled(triangle.data(), 3, packed(a.color));
			}
			else
				list_.AddCircleFilled(at(centre), static_cast<float>(0.2 * em), packed(a.color));
			// Beside an axis that points at the eye or away from it, its name goes where the others rarely are.
			const glm::dvec2 place =
			    seen > 0.15 ? tip + 0.55 * em * a.tip / seen : centre + glm::dvec2(-0.6 * em, 0.65 * em);
			text(place - glm::dvec2(0.5 * lettering_.width(a.name, em), 0.55 * em), em, a.color, a.name);
		}
	}

	void line(const glm::dvec2& a, const glm::dvec2& b)
	{
		list_.AddLine(at(a), at(b), packed(inks_.text, 0.6), hairline());
	}
	float hairline() const { return static_cast<float>(std::max(1.0, layout_.em / 16.0)); }

	const Scene& scene_;
	const Look& look_;
	const Layout& layout_;
	const Lettering& lettering_;
	const Inks& inks_;
	ImDrawList list_;
};

} // namespace

Overlay makeOverlay(const Scene& scene)
{
	const Layout layout = makeLayout(scene.look, scene.values);
	std::vector<std::string> texts{scene.look.title, scene.look.caption, layout.ticks.factor};
	if (scene.values)
		texts.push_back(scene.values->title);
	for (const Tick& tick : layout.ticks.marks)
		texts.push_back(tick.label);

	Overlay overlay;
	overlay.lettering =
	    std::make_unique<Lettering>(std::vector<double>{layout.small_em, layout.em, layout.title_em}, texts);
	Writer writer(scene, layout, *overlay.lettering);
	writer.write();
	const ImDrawList& list = writer.list();
	overlay.vertices.assign(list.VtxBuffer.begin(), list.VtxBuffer.end());
	// ImGui starts a new base vertex with a new command once 16 bits are used up.
	for (const ImDrawCmd& command : list.CmdBuffer)
		for (unsigned i = 0; i < command.ElemCount; ++i)
			overlay.indices.push_back(command.VtxOffset + list.IdxBuffer[static_cast<int>(command.IdxOffset + i)]);
	return overlay;
}

} // namespace vp::render
