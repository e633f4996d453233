#include "gpu/vulkan.h"

#include "pixel_lists.h"

#include "render/passes/picture_geometry.h"

#include <algorithm>
#include <cmath>

namespace vp::render::test
{

namespace
{

using vp::shared::PolygonRecord;

// Depths are floats: nearer than this nobody can tell which is in front.
constexpr double kCrossingReach = 1e-5; // in units of near / w

glm::dvec2 place(const PolygonRecord& record, std::uint32_t k)
{
	return {record.uv[2 * k], record.uv[2 * k + 1]};
}

double cross(const glm::dvec2& a, const glm::dvec2& b)
{
	return a.x * b.y - a.y * b.x;
}

double distanceToSegment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b)
{
	const glm::dvec2 along = b - a;
	const double square = glm::dot(along, along);
	const double part = square > 0.0 ? std::clamp(glm::dot(p - a, along) / square, 0.0, 1.0) : 0.0;
	return glm::length(p - a - part * along);
}

// The value at `at` if it lies in the record's fan of triangles.
std::optional<double> valueAt(const PolygonRecord& record, const glm::dvec2& at)
{
	const glm::dvec2 a = place(record, 0);
	for (std::uint32_t k = 1; k + 1 < record.vertices; ++k)
	{
		const glm::dvec2 b = place(record, k);
		const glm::dvec2 c = place(record, k + 1);
		const double area = cross(b - a, c - a);
		const double in_b = cross(at - a, c - a) / area;
		const double in_c = cross(b - a, at - a) / area;
		if (in_b >= 0.0 && in_c >= 0.0 && in_b + in_c <= 1.0)
			return (1.0 - in_b - in_c) * record.value[0] + in_b * record.value[k] + in_c * record.value[k + 1];
	}
	return std::nullopt;
}

struct Fragment
{
	double depth;       // near / w
	std::size_t number; // number of the sheet; surfaces are numbered behind all sheets
	double value;
	glm::dvec2 slope; // slope of the depth, per pixel
};

class Rasterizer
{
public:
	Rasterizer(const Scene& scene, double edge_reach)
	    : scene_(scene),
	      edge_reach_(edge_reach), frame_{double(scene.look.width), double(scene.look.height), {}, {}, {}},
	      fragments_(std::size_t(scene.look.width) * scene.look.height), on_edge_(fragments_.size())
	{
	}

	void add(std::size_t number, const KnownSheet& known)
	{
		const WindowRect& w = known.drawing.window.value();
		const glm::dvec2 corners[] = {{w.x0, w.y0}, {w.x1, w.y0}, {w.x1, w.y1}, {w.x0, w.y1}};
		for (int i = 0; i < 4; ++i)
			markEdge(pixel(known, corners[i]), pixel(known, corners[(i + 1) % 4]));
		for (const PolygonRecord& record : known.records)
			if (record.vertices > 0)
				addPolygon(number, known, record);
	}

	// Each polygon is a sheet of its own.
	void add(std::size_t number, const KnownSurface& known)
	{
		for (std::size_t p = 0; p < known.mesh.polygons(); ++p)
		{
			const auto polygon = known.mesh.polygon(p);
			const Vec3 area = mesh::doubleArea(known.mesh, polygon);
			KnownSheet plane;
			plane.drawing.sheet = probe::makeSheet(known.mesh.positions[polygon[0]], area);
			PolygonRecord record{};
			for (const std::uint32_t v : polygon)
			{
				const Vec3 from_origin = known.mesh.positions[v] - plane.drawing.sheet.origin;
				record.uv[2 * record.vertices] = static_cast<float>(glm::dot(from_origin, plane.drawing.sheet.xAxis()));
				record.uv[2 * record.vertices + 1] = static_cast<float>(glm::dot(from_origin, plane.drawing.sheet.up));
				record.value[record.vertices++] =
				    static_cast<float>(known.vertex_values.empty() ? known.polygon_values[p] : known.vertex_values[v]);
			}
			addPolygon(number, plane, record);
		}
	}

	std::vector<PixelList> blended() const
	{
		std::vector<PixelList> lists;
		for (std::size_t i = 0; i < fragments_.size(); ++i)
			lists.push_back(blend(fragments_[i], on_edge_[i]));
		return lists;
	}

private:
	glm::dvec2 pixel(const KnownSheet& known, const glm::dvec2& uv) const
	{
		const probe::Sheet& s = known.drawing.sheet;
		const glm::dvec2 drawn = known.drawing.magnification * uv;
		return scene_.camera.project(s.origin + drawn.x * s.xAxis() + drawn.y * s.up, frame_);
	}

	template <class F>
	void forPixels(const glm::dvec2& lo, const glm::dvec2& hi, F&& f)
	{
		const int x1 = std::min(static_cast<int>(hi.x + 1.0), static_cast<int>(scene_.look.width) - 1);
		const int y1 = std::min(static_cast<int>(hi.y + 1.0), static_cast<int>(scene_.look.height) - 1);
		for (int y = std::max(0, static_cast<int>(lo.y - 1.0)); y <= y1; ++y)
			for (int x = std::max(0, static_cast<int>(lo.x - 1.0)); x <= x1; ++x)
				f(std::size_t(y) * scene_.look.width + x, glm::dvec2(x + 0.5, y + 0.5));
	}

	void markEdge(const glm::dvec2& a, const glm::dvec2& b)
	{
		forPixels(glm::min(a, b), glm::max(a, b),
		          [&](std::size_t i, const glm::dvec2& center)
		          {
			          if (distanceToSegment(center, a, b) < edge_reach_)
				          on_edge_[i] = true;
		          });
	}

	void addPolygon(std::size_t number, const KnownSheet& known, const PolygonRecord& record)
	{
		glm::dvec2 lo(1e9);
		glm::dvec2 hi(-1e9);
		std::vector<glm::dvec2> corners;
		for (std::uint32_t k = 0; k < record.vertices; ++k)
		{
			corners.push_back(pixel(known, place(record, k)));
			lo = glm::min(lo, corners.back());
			hi = glm::max(hi, corners.back());
		}
		const auto whole = PicturePart::whole({scene_.look.width, scene_.look.height});
		const auto [rise_x, rise_y, start] = planeDepth(known.drawing.sheet, scene_.camera, whole);
		const glm::dvec2 slope(rise_x, rise_y);
		for (std::size_t k = 0; k < corners.size(); ++k)
			markEdge(corners[k], corners[(k + 1) % corners.size()]);
		forPixels(lo, hi,
		          [&, slope](std::size_t i, const glm::dvec2& center)
		          {
			          const auto found = hit(scene_, known.drawing.sheet, 1e9, center.x, center.y);
			          if (!found)
				          return;
			          const glm::dvec2 at = glm::dvec2(found->u, found->v) / known.drawing.magnification;
			          const WindowRect w = known.drawing.window.value_or(WindowRect{-1e9, 1e9, -1e9, 1e9});
			          if (at.x < w.x0 || at.x > w.x1 || at.y < w.y0 || at.y > w.y1)
				          return;
			          if (const auto value = valueAt(record, at))
				          fragments_[i].push_back({scene_.camera.near / found->distance, number, *value, slope});
		          });
	}

	bool inOnePlane(std::size_t a, std::size_t b) const
	{
		if (std::max(a, b) >= scene_.sheets.size())
			return false;
		const probe::Sheet& s = scene_.sheets[a].sheet;
		const probe::Sheet& t = scene_.sheets[b].sheet;
		return glm::length(glm::cross(s.normal, t.normal)) < 1e-12 &&
		       std::abs(glm::dot(s.origin - t.origin, s.normal)) < 1e-12;
	}

	double opacity(std::size_t number) const
	{
		const std::size_t sheets = scene_.sheets.size();
		return number < sheets ? scene_.sheets[number].opacity : scene_.surfaces[number - sheets].opacity;
	}

	// Returns true if both are so close that a small shift of the place changes their order.
	bool mayCross(const Fragment& a, const Fragment& b) const
	{
		const double reach = kCrossingReach + edge_reach_ * glm::length(a.slope - b.slope);
		return std::abs(a.depth - b.depth) < reach && !inOnePlane(a.number, b.number);
	}

	PixelList blend(std::vector<Fragment> list, bool on_edge) const
	{
		std::sort(list.begin(), list.end(),
		          [&](const Fragment& a, const Fragment& b)
		          { return inOnePlane(a.number, b.number) ? a.number < b.number : a.depth > b.depth; });
		PixelList pixel{{255.0, 255.0, 255.0}, list.size(), on_edge};
		for (std::size_t i = list.size(); i-- > 0;)
		{
			const Fragment& f = list[i];
			if (i > 0 && mayCross(list[i - 1], f))
				pixel.on_edge = true;
			pixel.color = over(rgb(scene_.look.colors.at(f.value)), opacity(f.number), pixel.color);
		}
		return pixel;
	}

	const Scene& scene_;
	double edge_reach_;
	Frame frame_;
	std::vector<std::vector<Fragment>> fragments_;
	std::vector<bool> on_edge_;
};

} // namespace

std::vector<PixelList> blendedLists(const Scene& scene, const std::vector<KnownSheet>& sheets,
                                    const std::vector<KnownSurface>& surfaces, double edge_reach)
{
	Rasterizer rasterizer(scene, edge_reach);
	for (std::size_t i = 0; i < sheets.size(); ++i)
		rasterizer.add(i, sheets[i]);
	for (std::size_t i = 0; i < surfaces.size(); ++i)
		rasterizer.add(sheets.size() + i, surfaces[i]);
	return rasterizer.blended();
}

ListComparison compareLists(const std::vector<PixelList>& lists, const Picture& picture)
{
	ListComparison result;
	result.pixels = lists.size();
	for (std::size_t i = 0; i < lists.size(); ++i)
	{
		const std::uint8_t* p = &picture.rgba[4 * i];
		const double off = difference(lists[i].color, {p[0], p[1], p[2], p[3]});
		result.several += lists[i].fragments > 1;
		if (lists[i].on_edge)
		{
			++result.edges;
			result.edge_off += off > kBlendTolerance;
		}
		else
			result.worst = std::max(result.worst, off);
	}
	return result;
}

} // namespace vp::render::test
