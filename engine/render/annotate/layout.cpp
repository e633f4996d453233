#include "render/annotate/layout.h"

#include "render/annotate/legend_layout.h"

#include <algorithm>
#include <cmath>

namespace vp::render
{

namespace
{

constexpr double kSmallestText = 9.0; // pixels; DejaVu is legible from there

// A size that the user gives is exact: on a page it is that of the text around the picture. Otherwise whole pixels keep
// the letters' stems sharp.
void layOutText(const Look& look, Layout& layout)
{
	if (look.text_size > 0.0)
	{
		layout.em = kLetterHeight * look.text_size;
		layout.title_em = 1.3 * layout.em;
		layout.small_em = 0.85 * layout.em;
	}
	else
	{
		layout.em = std::max(kSmallestText, std::round(std::min(look.height / 44.0, look.width / 48.0)));
		layout.title_em = std::round(1.3 * layout.em);
		layout.small_em = std::max(kSmallestText, std::round(0.85 * layout.em));
	}
	layout.margin = std::round(1.1 * layout.em);
}

} // namespace

Layout makeLayout(const Look& look, const std::vector<LegendContent>& legends)
{
	const double width = look.width;
	const double height = look.height;
	Layout layout{};
	layOutText(look, layout);

	double right = width - layout.margin;
	if (look.legend && !legends.empty())
	{
		layOutLegends(look, legends, layout);
		if (!layout.legends.empty())
			right = layout.legends.front().column.lo.x - 1.5 * layout.margin;
	}
	double top = layout.margin;
	if (!look.title.empty())
	{
		layout.title = {{layout.margin, layout.margin}, {right, layout.margin + kLineHeight * layout.title_em}};
		top = layout.title.hi.y + 0.3 * layout.margin;
	}
	if (look.axes)
	{
		const double side = 5.4 * layout.em;
		layout.axes = {{0.6 * layout.margin, height - 0.6 * layout.margin - side},
		               {0.6 * layout.margin + side, height - 0.6 * layout.margin}};
	}
	double bottom = height - layout.margin;
	if (!look.caption.empty())
	{
		const double left = look.axes ? layout.axes.hi.x + layout.margin : layout.margin;
		const double base = height - 0.7 * layout.margin;
		layout.caption = {{left, base - kLineHeight * layout.small_em}, {right, base}};
		bottom = layout.caption.lo.y - 0.5 * layout.margin;
	}

	layout.frame.width = width;
	layout.frame.height = height;
	layout.frame.free_lo = {layout.margin, top};
	layout.frame.free_hi = {std::max(right, layout.margin + 0.25 * width), std::max(bottom, top + 0.25 * height)};
	if (look.box_axes)
	{
		// Numbers of usual length, and the axes' names, find room around the box.
		const glm::dvec2 room =
		    glm::min(glm::dvec2(4.6, 3.0) * layout.em, 0.2 * (layout.frame.free_hi - layout.frame.free_lo));
		layout.frame.free_lo += room;
		layout.frame.free_hi -= room;
	}
	if (look.axes)
		layout.frame.corner = {layout.axes.hi.x, layout.axes.lo.y};
	return layout;
}

Layout makeLayout(const Scene& scene)
{
	return makeLayout(scene.look, legendContents(scene));
}

Frame pictureFrame(const Scene& scene)
{
	return makeLayout(scene).frame;
}

} // namespace vp::render
