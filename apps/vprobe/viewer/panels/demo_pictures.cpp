#include "viewer/panels/demo_pictures.h"

#include "picture/sheet_values.h"
#include "render/color/color_map.h"
#include "render/scene/outline.h"
#include "session/frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace vp::app
{

namespace
{

constexpr ImU32 kEdge = IM_COL32(0, 0, 0, 50);
constexpr int kCells = 10; // cells each way: as many as a hundred pixels can show

// Looks from above and one side, without perspective.
class Projection
{
public:
	explicit Projection(const Box& box) : center_(box.center()), radius_(0.5 * glm::length(box.hi - box.lo)) {}

	double depth(const Vec3& p) const { return glm::dot(p - center_, kForward); }
	ImVec2 place(const Vec3& p) const
	{
		const Vec3 from = p - center_;
		const Vec3 right = glm::normalize(glm::cross(kForward, Vec3{0.0, 0.0, 1.0}));
		const Vec3 up = glm::cross(right, kForward);
		return {static_cast<float>(0.5 + 0.5 * glm::dot(from, right) / radius_),
		        static_cast<float>(0.5 - 0.5 * glm::dot(from, up) / radius_)};
	}

private:
	static inline const Vec3 kForward = glm::normalize(Vec3{-0.5, 0.75, -0.45});
	Vec3 center_;
	double radius_;
};

// Scales everything into 0 to 1, as large as possible.
void fit(DemoPicture& picture)
{
	ImVec2 lo{1.0f, 1.0f};
	ImVec2 hi{0.0f, 0.0f};
	const auto each = [&](const auto& visit)
	{
		for (auto& line : picture.box)
			for (ImVec2& end : line)
				visit(end);
		for (ImVec2& corner : picture.corners)
			visit(corner);
	};
	each(
	    [&](const ImVec2& p)
	    {
		    lo = {std::min(lo.x, p.x), std::min(lo.y, p.y)};
		    hi = {std::max(hi.x, p.x), std::max(hi.y, p.y)};
	    });
	const float side = std::max({hi.x - lo.x, hi.y - lo.y, 1e-6f});
	each(
	    [&](ImVec2& p) {
		    p = {0.5f + (p.x - 0.5f * (lo.x + hi.x)) / side, 0.5f + (p.y - 0.5f * (lo.y + hi.y)) / side};
	    });
}

// Adds a sheet's polygons to the picture, and their depths to `depths`.
void addSheet(DemoPicture& picture, std::vector<double>& depths, const Projection& projection,
              const mesh::SheetMesh& mesh, const std::vector<double>& values)
{
	static const render::ColorMap kMap = *render::makeColorMap("viridis");
	constexpr double kLow = -1.6;
	constexpr double kHigh = 1.6;
	for (std::size_t p = 0; p + 1 < mesh.polygon_starts.size(); ++p)
	{
		const std::uint32_t first = mesh.polygon_starts[p];
		const std::uint32_t count = mesh.polygon_starts[p + 1] - first;
		picture.polygons.push_back({static_cast<std::uint32_t>(picture.corners.size()), count});
		double depth = 0.0;
		for (std::uint32_t i = first; i < first + count; ++i)
		{
			const std::uint32_t v = mesh.polygon_vertices[i];
			const render::Color color = kMap.at((values[v] - kLow) / (kHigh - kLow));
			picture.corners.push_back(projection.place(mesh.positions[v]));
			picture.colors.push_back(IM_COL32(color.r, color.g, color.b, 255));
			depth += projection.depth(mesh.positions[v]) / count;
		}
		depths.push_back(depth);
	}
}

} // namespace

DemoPicture makeDemoPicture(std::string_view name)
{
	view::ViewSpec spec;
	spec.input.files = {fmt::format("demo:{}:{}", name, kCells)};
	spec.machine.classify = view::Classify::cpu;
	spec.probe.shape = view::ProbeShape::trihedral;
	const auto opened = session::Session::open(std::move(spec), {.expect = session::Expect::first_of_many});
	if (!opened)
		return {};
	session::Session& session = **opened;
	const Result<std::shared_ptr<const session::Frame>> made = session.frame({});
	if (!made)
		return {};
	const session::Frame& frame = **made;
	DemoPicture picture;
	const Projection projection(session.blocks().bounds());
	for (const render::Segment& line : render::outlineOf(session.blocks(), render::Outline::box))
		picture.box.push_back({projection.place(line.a), projection.place(line.b)});
	std::vector<double> depths;
	for (std::size_t s = 0; s < frame.sheets.size(); ++s)
	{
		const mesh::SheetMesh& mesh = frame.sheets[s].mesh;
		addSheet(picture, depths, projection, mesh,
		         picture::sheetValues(session.blocks(), frame.slice.sheets[s], mesh, false).of_vertices);
	}
	std::vector<std::size_t> order(depths.size());
	std::iota(order.begin(), order.end(), std::size_t(0));
	std::ranges::sort(order, std::greater(), [&](std::size_t i) { return depths[i]; });
	std::vector<DemoPicture::Polygon> sorted;
	for (const std::size_t i : order)
		sorted.push_back(picture.polygons[i]);
	picture.polygons = std::move(sorted);
	fit(picture);
	return picture;
}

void DemoPicture::draw(ImDrawList& list, const ImVec2& lo, const ImVec2& size) const
{
	const float side = std::min(size.x, size.y);
	const ImVec2 from{lo.x + 0.5f * (size.x - side), lo.y + 0.5f * (size.y - side)};
	const auto placed = [&](const ImVec2& p) { return ImVec2{from.x + side * p.x, from.y + side * p.y}; };
	for (const auto& [a, b] : box)
		list.AddLine(placed(a), placed(b), ImGui::GetColorU32(ImGuiCol_Border));
	const ImVec2 white = ImGui::GetFontTexUvWhitePixel();
	for (const Polygon& polygon : polygons)
	{
		const auto corners = static_cast<int>(polygon.count);
		list.PrimReserve(3 * (corners - 2), corners);
		const auto base = static_cast<ImDrawIdx>(list._VtxCurrentIdx);
		for (std::uint32_t i = polygon.first; i < polygon.first + polygon.count; ++i)
			list.PrimWriteVtx(placed(this->corners[i]), white, colors[i]);
		for (int i = 1; i + 1 < corners; ++i)
			for (const int corner : {0, i, i + 1})
				list.PrimWriteIdx(static_cast<ImDrawIdx>(base + corner));
		// The edges show whether cells are hexahedra or tetrahedra.
		for (int i = 0; i < corners; ++i)
			list.AddLine(placed(this->corners[polygon.first + static_cast<std::uint32_t>(i)]),
			             placed(this->corners[polygon.first + static_cast<std::uint32_t>((i + 1) % corners)]), kEdge);
	}
}

} // namespace vp::app
