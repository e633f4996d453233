#include "render/color/color_map_file.h"
#include "render/color/opacity_points.h"
#include "view/input_title.h"
#include "view/resolve.h"

#include <fmt/format.h>

namespace vp::view
{

namespace
{

// A map of categories has no values in between.
Status checkCategories(const LookSpec& spec, const render::ColorMap& colors)
{
	if (colors.categories.empty())
		return Nothing{};
	const char* key = spec.logarithmic               ? "log"
	                  : spec.lines > 0               ? "lines"
	                  : spec.bands > 0               ? "bands"
	                  : spec.range                   ? "range"
	                  : spec.symmetric               ? "symmetric"
	                  : !spec.opacity_points.empty() ? "opacity_points"
	                                                 : nullptr;
	if (!key)
		return Nothing{};
	return Error{ErrorKind::usage, fmt::format("`{}`: means nothing to the categories of `colormap` {}; leave it out",
	                                           key, spec.colormap)};
}

} // namespace

Result<ResolvedLook> resolveLook(const ViewSpec& spec)
{
	const LookSpec& from = spec.look;
	ResolvedLook resolved;
	resolved.spec = from;
	resolved.spec.camera = render::projected(from.camera, from.projection);
	render::Look& look = resolved.look;
	Result<render::ColorMap> colors = render::chooseColorMap(from.colormap.empty() ? "viridis" : from.colormap);
	if (!colors)
		return colors.error();
	look.colors = std::move(*colors);
	if (Status fits = checkCategories(from, look.colors); !fits)
		return fits.error();
	look.colors = render::withOpacity(std::move(look.colors), render::opacityPoints(from.opacity_points));
	look.width = from.size.width;
	look.height = from.size.height;
	look.samples = from.samples;
	look.range = from.range;
	look.marks_out_of_range = from.mark_out_of_range;
	look.logarithmic = from.logarithmic;
	look.lines = from.lines;
	look.bands = from.bands;
	look.mesh = from.mesh;
	look.lit = from.lit;
	look.legend = !from.no_legend;
	look.small_view = !from.no_inset;
	look.text_size = from.text_size;
	if (!from.font.empty())
	{
		Result<const render::Typeface*> font = render::Typeface::find(from.font);
		if (!font)
			return Error{font.error().kind, fmt::format("`font` {}: {}", from.font, font.error().message)};
		look.font = *font;
	}
	resolved.captions = !from.no_footer;
	look.labels = !from.no_labels;
	look.length_units = from.length_units;
	look.background = from.background;
	look.outline = from.outline;
	look.axes = from.axes == AxesStyle::corner;
	look.box_axes = from.axes == AxesStyle::box;
	look.title = from.title.value_or(inputTitle(spec.input.files));
	// The paddlewheel's own window reaches around everything.
	resolved.window_rims = spec.probe.window || spec.probe.shape != ProbeShape::paddlewheel;
	if (!from.vectors.colormap.empty())
	{
		Result<render::ColorMap> vector_colors = render::chooseColorMap(from.vectors.colormap);
		if (!vector_colors)
			return Error{vector_colors.error().kind,
			             fmt::format("`vector_colormap`: {}", vector_colors.error().message)};
		resolved.vector_colors = std::move(*vector_colors);
	}
	return resolved;
}

} // namespace vp::view
