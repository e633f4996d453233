#include "render/flat/cairo_canvas.h"

#include "render/annotate/valid_utf8.h"
#include "render/flat/cairo_library.h"

#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <stdexcept>

namespace vp::render
{

namespace
{

// FontAtlas's sizes are from the highest letter's top to the lowest one's bottom, cairo's are the font's em.
constexpr double kEm = 1.0 / kLetterHeight;
constexpr double kBaseline = kLetterAscent / kLetterHeight;

cairo_font_face_t* makeFace(const Typeface& font)
{
	static FT_Library library = nullptr;
	FT_Face face = nullptr;
	const auto file = font.bytes();
	if ((!library && FT_Init_FreeType(&library) != 0) ||
	    FT_New_Memory_Face(library, reinterpret_cast<const FT_Byte*>(file.data()), static_cast<FT_Long>(file.size()),
	                       font.number(), &face) != 0)
		throw std::logic_error("a font that was read before cannot be read again");
	return cairo().ft_font_face_create_for_ft_face(face, FT_LOAD_NO_HINTING);
}

// cairo may keep a face longer than a context lives: these live as long as the program.
cairo_font_face_t* fontFace(const Typeface& font)
{
	static std::mutex mutex;
	static std::map<const Typeface*, cairo_font_face_t*> faces;
	const std::lock_guard lock(mutex);
	cairo_font_face_t*& face = faces[&font];
	if (!face)
		face = makeFace(font);
	return face;
}

} // namespace

CairoCanvas::CairoCanvas(cairo_t* context, const FontAtlas& lettering, const Inks& inks, double em)
    : Canvas(lettering, inks, em), context_(context)
{
	cairo_font_options_t* options = cairo().font_options_create();
	cairo().font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
	cairo().font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
	cairo().font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
	cairo().set_font_options(context_, options);
	cairo().font_options_destroy(options);
	cairo().set_line_join(context_, CAIRO_LINE_JOIN_ROUND);
	cairo().set_line_cap(context_, CAIRO_LINE_CAP_ROUND);
}

void CairoCanvas::setColor(Color color)
{
	cairo().set_source_rgba(context_, color.r / 255.0, color.g / 255.0, color.b / 255.0, color.a / 255.0);
}

void CairoCanvas::path(const std::vector<glm::dvec2>& points, bool closed)
{
	if (points.empty())
		return;
	cairo().move_to(context_, points.front().x, points.front().y);
	for (std::size_t i = 1; i < points.size(); ++i)
		cairo().line_to(context_, points[i].x, points[i].y);
	if (closed)
		cairo().close_path(context_);
}

void CairoCanvas::stroke(Color color, double width)
{
	setColor(color);
	cairo().set_line_width(context_, width);
	cairo().stroke(context_);
}

void CairoCanvas::text(const glm::dvec2& top_left, double size, Color color, const std::string& words)
{
	setColor(color);
	cairo().set_font_size(context_, kEm * size);
	cairo().move_to(context_, top_left.x, top_left.y + kBaseline * size);
	show(words);
}

// Each call goes on where the one before has ended.
void CairoCanvas::show(const std::string& words)
{
	for (const FontAtlas::Run& run : lettering().runs(validUtf8(words)))
	{
		cairo().set_font_face(context_, fontFace(*run.font));
		cairo().show_text(context_, run.text.c_str());
	}
}

double CairoCanvas::advance(const std::string& words)
{
	double sum = 0.0;
	for (const FontAtlas::Run& run : lettering().runs(validUtf8(words)))
	{
		cairo_text_extents_t extents;
		cairo().set_font_face(context_, fontFace(*run.font));
		cairo().text_extents(context_, run.text.c_str(), &extents);
		sum += extents.x_advance;
	}
	return sum;
}

void CairoCanvas::turnedText(const glm::dvec2& center, double angle, double size, Color color, Color halo,
                             const std::string& words)
{
	cairo().save(context_);
	cairo().translate(context_, center.x, center.y);
	cairo().rotate(context_, angle);
	cairo().set_font_size(context_, kEm * size);
	const glm::dvec2 start(-0.5 * advance(words), (kBaseline - 0.5) * size);
	if (halo.a > 0)
	{
		cairo().move_to(context_, start.x, start.y);
		for (const FontAtlas::Run& run : lettering().runs(validUtf8(words)))
		{
			cairo().set_font_face(context_, fontFace(*run.font));
			cairo().text_path(context_, run.text.c_str());
		}
		stroke(halo, 2.0 * kHalo * size);
	}
	setColor(color);
	cairo().move_to(context_, start.x, start.y);
	show(words);
	cairo().restore(context_);
}

void CairoCanvas::line(const glm::dvec2& a, const glm::dvec2& b, Color color, double width)
{
	path({a, b}, false);
	stroke(color, width);
}

void CairoCanvas::closedLine(const std::vector<glm::dvec2>& corners, Color color, double width)
{
	path(corners, true);
	stroke(color, width);
}

void CairoCanvas::filled(const std::vector<glm::dvec2>& convex, Color color)
{
	path(convex, true);
	setColor(color);
	cairo().fill(context_);
}

// On whole pixels, so that neighbors meet.
void CairoCanvas::filled(const Area& area, Color color)
{
	const glm::dvec2 lo = glm::round(area.lo);
	const glm::dvec2 size = glm::round(area.hi) - lo;
	cairo().rectangle(context_, lo.x, lo.y, size.x, size.y);
	setColor(color);
	cairo().fill(context_);
}

void CairoCanvas::dot(const glm::dvec2& center, double radius, Color color)
{
	cairo().new_sub_path(context_);
	cairo().arc(context_, center.x, center.y, radius, 0.0, 2.0 * std::numbers::pi);
	setColor(color);
	cairo().fill(context_);
}

void CairoCanvas::colorBar(const Area& bar, const ColorMap& colors)
{
	cairo_pattern_t* gradient = cairo().pattern_create_linear(0.0, bar.hi.y, 0.0, bar.lo.y);
	for (int i = 0; i < kColorMapSize; ++i)
	{
		const Color& c = colors.colors[i];
		cairo().pattern_add_color_stop_rgba(gradient, i / double(kColorMapSize - 1), c.r / 255.0, c.g / 255.0,
		                                    c.b / 255.0, c.a / 255.0);
	}
	cairo().rectangle(context_, bar.lo.x, bar.lo.y, bar.size().x, bar.size().y);
	cairo().set_source(context_, gradient);
	cairo().fill(context_);
	cairo().pattern_destroy(gradient);
}

} // namespace vp::render
