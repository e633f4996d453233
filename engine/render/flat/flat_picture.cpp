#include "render/annotate/legend.h"
#include "render/annotate/titles.h"
#include "render/flat/cairo_library.h"
#include "render/flat/flat_drawing.h"
#include "render/flat/flat_scene.h"

namespace vp::render
{

namespace
{

void addStop(cairo_pattern_t* gradient, double at, Color color)
{
	cairo().pattern_add_color_stop_rgb(gradient, at, color.r / 255.0, color.g / 255.0, color.b / 255.0);
}

} // namespace

void paintBackground(const Look& look, cairo_t* context)
{
	if (look.background.transparent())
		return;
	cairo_pattern_t* gradient = cairo().pattern_create_linear(0.0, 0.0, 0.0, look.height);
	addStop(gradient, 0.0, look.background.top);
	addStop(gradient, 1.0, look.background.bottom);
	cairo().rectangle(context, 0.0, 0.0, look.width, look.height);
	cairo().set_source(context, gradient);
	cairo().fill(context);
	cairo().pattern_destroy(gradient);
}

void drawFlat(const FlatScene& flat, cairo_t* context)
{
	Look look = flat.scene.look;
	const std::vector<LegendContent> legends = legendContents(flat.scene);
	look.axes = look.box_axes = false; // those of a picture in space
	Layout text = makeLayout(look, {});
	const FontAtlas lettering({text.small_em, text.em, text.title_em}, writtenTexts(look, legends), *look.font);
	const FlatLayout layout = makeFlatLayout(flat, legends, text, lettering);

	paintBackground(look, context);
	CairoCanvas pen(context, lettering, inksOn(look.background), text.em);
	drawFlatSheet(flat, layout, pen);
	drawFlatAxes(layout, pen);
	drawSides(flat, layout, pen);
	drawSmallView(flat, layout, pen);
	writeTitles(look, layout.text, pen);
	for (std::size_t i = 0; i < layout.text.legends.size(); ++i)
		writeLegend(legends[i], layout.text.legends[i], pen);
}

} // namespace vp::render
