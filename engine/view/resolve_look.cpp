#include "render/color/color_map_file.h"
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
	const char* key = spec.logarithmic ? "log"
	                  : spec.lines > 0 ? "lines"
	                  : spec.bands > 0 ? "bands"
	                  : spec.range     ? "range"
	                  : spec.symmetric ? "symmetric"
	                                   : nullptr;
	if (!key)
		return Nothing{};
	return Error{ErrorKind::usage, fmt::format("`{}`: means nothing to the categories of `colormap` {}; leave it out",
	                                           key, spec.colormap)};
}

Result<ResolvedVectorLook> resolveVectorLook(const VectorLookSpec& spec)
{
	ResolvedVectorLook look{spec.color, {}, spec.width, spec.opacity};
	if (!spec.colormap.empty())
	{
		Result<render::ColorMap> colors = render::chooseColorMap(spec.colormap);
		if (!colors)
			return Error{colors.error().kind, fmt::format("`vector_colormap`: {}", colors.error().message)};
		look.colors = std::move(*colors);
	}
	return look;
}

} // namespace

Result<ResolvedLook> resolveLook(const ViewSpec& spec)
{
	const LookSpec& from = spec.look;
	ResolvedLook resolved;
	render::Look& look = resolved.look;
	Result<render::ColorMap> colors = render::chooseColorMap(from.colormap);
	if (!colors)
		return colors.error();
	look.colors = std::move(*colors);
	if (Status fits = checkCategories(from, look.colors); !fits)
		return fits.error();
	look.width = from.size.width;
	look.height = from.size.height;
	look.samples = from.samples;
	look.range = from.range;
	look.logarithmic = from.logarithmic;
	look.lines = from.lines;
	look.bands = from.bands;
	look.mesh = from.mesh;
	look.lit = from.lit;
	look.legend = !from.no_legend;
	look.labels = !from.no_labels;
	look.length_units = from.length_units;
	look.background = from.background;
	look.outline = from.outline;
	look.axes = from.axes == AxesStyle::corner;
	look.box_axes = from.axes == AxesStyle::box;
	look.title = from.title.value_or(inputTitle(spec.input.files));
	resolved.camera = from.camera;
	resolved.context = from.context;
	resolved.contour = from.contour;
	resolved.opacity = from.opacity;
	resolved.range_of_slice = from.range_of == RangeOf::slice;
	resolved.symmetric = from.symmetric;
	resolved.by_generation = from.color_by == ColorBy::generation;
	resolved.units = from.units;
	// The paddlewheel's own window reaches around everything.
	resolved.window_rims = spec.probe.window || spec.probe.shape != ProbeShape::paddlewheel;
	Result<ResolvedVectorLook> vectors = resolveVectorLook(from.vectors);
	if (!vectors)
		return vectors.error();
	resolved.vectors = std::move(*vectors);
	return resolved;
}

} // namespace vp::view
