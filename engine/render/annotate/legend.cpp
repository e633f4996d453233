#include "render/annotate/legend.h"

#include <fmt/format.h>

#include <algorithm>

namespace vp::render
{

namespace
{

constexpr double kColorLabelGap = 0.6; // em, between a color and its label

class Legend
{
public:
	Legend(const LegendContent& content, const LegendLayout& layout, Canvas& pen)
	    : content_(content), layout_(layout), pen_(pen), style_(content.style), em_(pen.em()), bar_(layout.bar),
	      label_x_(layout.bar.hi.x + kColorLabelGap * em_)
	{
	}

	void write()
	{
		title();
		if (!style_.colors->categories.empty())
			categories();
		else
		{
			if (style_.bands.empty())
				pen_.colorBar(bar_, *style_.colors);
			else
				bands();
			contourLines();
			frame();
			marks();
		}
		if (content_.has_nan)
			swatch(layout_.nan, style_.colors->nan, "NaN");
	}

private:
	void title()
	{
		const auto room = static_cast<std::size_t>(std::max(1.0, layout_.title.size().y / (1.25 * em_) + 0.01));
		const auto lines = pen_.lettering().wrapped(content_.title, em_, layout_.title.size().x, room);
		double y = layout_.title.hi.y - 1.25 * em_ * static_cast<double>(lines.size());
		for (const std::string& line : lines)
		{
			pen_.text({layout_.title.lo.x, y}, em_, pen_.inks().text, line);
			y += 1.25 * em_;
		}
	}

	double height(double part) const { return bar_.hi.y - part * bar_.size().y; }

	void bands()
	{
		for (std::size_t i = 0; i <= style_.bands.size(); ++i)
		{
			const double from = i > 0 ? style_.part(style_.bands[i - 1]) : 0.0;
			const double to = i < style_.bands.size() ? style_.part(style_.bands[i]) : 1.0;
			pen_.filled(Area{{bar_.lo.x, height(to)}, {bar_.hi.x, height(from)}}, style_.bandColor(i));
		}
	}

	// As they look on a sheet.
	void contourLines()
	{
		for (const double value : style_.lines)
		{
			const double y = height(style_.part(value));
			pen_.line({bar_.lo.x, y}, {bar_.hi.x, y}, inkOver(style_.colors->at(style_.part(value))),
			          std::max(1.2, em_ / 11.0));
		}
	}

	// One line around the bar and its ends.
	void frame()
	{
		const glm::dvec2 top{0.5 * (bar_.lo.x + bar_.hi.x), bar_.lo.y - layout_.cap};
		const glm::dvec2 bottom{top.x, bar_.hi.y + layout_.cap};
		std::vector<glm::dvec2> rim{bar_.lo};
		if (style_.above)
		{
			pen_.filled({bar_.lo, top, {bar_.hi.x, bar_.lo.y}}, style_.aboveColor());
			rim.push_back(top);
		}
		rim.insert(rim.end(), {{bar_.hi.x, bar_.lo.y}, bar_.hi});
		if (style_.below)
		{
			pen_.filled({{bar_.lo.x, bar_.hi.y}, bar_.hi, bottom}, style_.belowColor());
			rim.push_back(bottom);
		}
		rim.push_back({bar_.lo.x, bar_.hi.y});
		pen_.framed(rim);
	}

	void marks()
	{
		if (!layout_.ticks.factor.empty())
			pen_.text(layout_.factor.lo, em_, pen_.inks().text, layout_.ticks.factor);
		for (const Tick& tick : layout_.ticks.marks)
		{
			const double y = height(style_.part(tick.value));
			pen_.line({bar_.hi.x, y}, {bar_.hi.x + 0.3 * em_, y});
			pen_.label(label_x_, y, tick.label);
		}
	}

	void swatch(const Area& area, Color color, const std::string& name)
	{
		pen_.filled(area, color);
		pen_.framed(area);
		pen_.label(label_x_, 0.5 * (area.lo.y + area.hi.y),
		           pen_.lettering().elided(name, em_, layout_.column.hi.x - label_x_));
	}

	void categories()
	{
		const auto& all = style_.colors->categories;
		double y = bar_.lo.y;
		for (std::size_t i = 0; i < layout_.categories; ++i, y += layout_.entry)
			swatch({{bar_.lo.x, y}, {bar_.hi.x, y + em_}}, all[i].color, all[i].name);
		if (layout_.categories < all.size())
			pen_.label(bar_.lo.x, y + 0.5 * em_, fmt::format("… {} more", all.size() - layout_.categories));
	}

	const LegendContent& content_;
	const LegendLayout& layout_;
	Canvas& pen_;
	const ValueStyle& style_;
	double em_;
	Area bar_;
	double label_x_;
};

} // namespace

void writeLegend(const LegendContent& content, const LegendLayout& layout, Canvas& pen)
{
	Legend(content, layout, pen).write();
}

} // namespace vp::render
