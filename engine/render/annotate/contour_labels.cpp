#include "render/annotate/contour_labels.h"

#include "render/annotate/label_places.h"

#include <algorithm>
#include <cmath>

namespace vp::render
{

namespace
{

constexpr double kSceneLabelsApart = 30.0; // em, along a line
constexpr double kSoftHalo = 0.5;          // share of the plate's opacity, on translucent sheets
constexpr double kHides = 0.6;             // a sheet of this opacity hides what is behind it

// Even-odd.
bool isInside(const glm::dvec2& p, const std::vector<measure::PlaneLine>& rim)
{
	bool inside = false;
	for (const measure::PlaneLine& line : rim)
		for (std::size_t i = 0, before = line.points.size() - 1; i < line.points.size(); before = i++)
		{
			const glm::dvec2& a = line.points[before];
			const glm::dvec2& b = line.points[i];
			if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y))
				inside = !inside;
		}
	return inside;
}

} // namespace

Color labelGround(const Color& of_sheet, double opacity, const Background& background)
{
	const Color behind = groundOf(background);
	const auto mixed = [&](std::uint8_t a, std::uint8_t b) { return (opacity * a + (1.0 - opacity) * b) / 255.0; };
	return colorOf(Vec3(mixed(of_sheet.r, behind.r), mixed(of_sheet.g, behind.g), mixed(of_sheet.b, behind.b)),
	               0.92 * std::clamp(opacity, 0.3, 1.0));
}

namespace
{

class ContourLabels
{
public:
	ContourLabels(const Scene& scene, const Layout& layout, Canvas& pen) : scene_(scene), layout_(layout), pen_(pen) {}

	void write()
	{
		for (std::size_t s = 0; s < scene_.sheets.size(); ++s)
			take(s);
		if (levels_.empty())
			return;
		std::vector<Area> taken{layout_.title, layout_.caption, layout_.axes};
		for (const LegendLayout& legend : layout_.legends)
			taken.push_back(legend.column);
		const double size = layout_.small_em;
		const Area picture{glm::dvec2(0.2 * size),
		                   {layout_.frame.width - 0.2 * size, layout_.frame.height - 0.2 * size}};
		const auto seen = [&](std::size_t line, const glm::dvec2& pixel) { return isSeen(sheets_[line], pixel); };
		for (const LabelPlace& place : placeLabels(lines_, size, kSceneLabelsApart * layout_.em, picture, taken, seen))
			write(place, size);
	}

private:
	// A sheet's lines in pixels, and its rim, which labels keep off. Of what is beside or behind the eye there are
	// none.
	void take(std::size_t s)
	{
		const SheetDrawing& sheet = scene_.sheets[s];
		if (sheet.contours.empty())
			return;
		const int digits = digitsApart(valueStyle(scene_, sheet).lines);
		for (const LevelLine& line : sheet.contours)
			add(s, line.line, line.level, shortNumber(line.level, digits));
		for (const measure::PlaneLine& line : sheet.rim_lines)
			add(s, line, 0.0, "");
	}

	void add(std::size_t s, const measure::PlaneLine& line, double level, std::string words)
	{
		LabeledLine labeled{{}, line.closed, pen_.lettering().width(words, layout_.small_em)};
		for (const glm::dvec2& uv : line.points)
		{
			const Vec3 at = scene_.sheets[s].inWorld(uv);
			if (glm::dot(at - scene_.camera.position, scene_.camera.forward()) < scene_.camera.near)
				return;
			labeled.points.push_back(scene_.camera.project(at, layout_.frame));
		}
		lines_.push_back(std::move(labeled));
		levels_.push_back(level);
		words_.push_back(std::move(words));
		sheets_.push_back(s);
	}

	bool isSeen(std::size_t s, const glm::dvec2& pixel) const
	{
		const Camera& camera = scene_.camera;
		const Vec3 ray = camera.ray(pixel, layout_.frame);
		const auto meets = [&](const SheetDrawing& sheet)
		{
			const double falls = glm::dot(ray, sheet.sheet.normal);
			return glm::dot(sheet.sheet.origin - camera.position, sheet.sheet.normal) / falls;
		};
		const double own = meets(scene_.sheets[s]);
		for (std::size_t other = 0; other < scene_.sheets.size(); ++other)
		{
			const SheetDrawing& sheet = scene_.sheets[other];
			const double there = meets(sheet);
			if (other == s || sheet.opacity < kHides || !(there > 0.0 && there < (1.0 - 1e-6) * own))
				continue;
			if (isInside(sheet.inRecords(camera.position + there * ray), sheet.rim_lines))
				return false;
		}
		return true;
	}

	void write(const LabelPlace& place, double size)
	{
		const SheetDrawing& sheet = scene_.sheets[sheets_[place.line]];
		const double level = levels_[place.line];
		const ValueStyle style = valueStyle(scene_, sheet);
		Color halo = labelGround(style.colors->at(style.part(level)), sheet.opacity, scene_.look.background);
		Color ink = inkOver(halo);
		ink.a = 255;
		const Color plate = halo;
		// Letters have several halos, each over the other.
		halo.a = static_cast<std::uint8_t>(halo.a * (sheet.opacity < 1.0 ? kSoftHalo : 1.0));
		// The line ends before the words: else it would pass for a minus sign.
		const glm::dvec2 along =
		    (0.5 * lines_[place.line].width + 0.3 * size) * glm::dvec2(std::cos(place.angle), std::sin(place.angle));
		const glm::dvec2 across = 0.18 * size * glm::normalize(glm::dvec2(-along.y, along.x));
		pen_.filled({place.center - along - across, place.center + along - across, place.center + along + across,
		             place.center - along + across},
		            plate);
		pen_.turnedText(place.center, place.angle, size, ink, halo, words_[place.line]);
	}

	const Scene& scene_;
	const Layout& layout_;
	Canvas& pen_;
	std::vector<LabeledLine> lines_;
	std::vector<double> levels_; // per line
	std::vector<std::string> words_;
	std::vector<std::size_t> sheets_;
};

} // namespace

void writeContourLabels(const Scene& scene, const Layout& layout, Canvas& pen)
{
	if (scene.look.labels && scene.values)
		ContourLabels(scene, layout, pen).write();
}

} // namespace vp::render
