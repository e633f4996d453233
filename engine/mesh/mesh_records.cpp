#include "mesh/mesh_records.h"

#include "base/parallel_for.h"
#include "base/parallel_reduce.h"
#include "mesh/bridges.h"
#include "mesh/mesh_values.h"
#include "mesh/polygon_fans.h"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <cmath>

namespace vp::mesh
{

namespace
{

// Polygons or vertices that one thread takes at a time: some 100 kB of either.
constexpr std::size_t kRecordChunk = 1024;

template <class F>
void forAll(std::size_t count, const F& f)
{
	tracedFor(tbb::blocked_range<std::size_t>(0, count, kRecordChunk),
	          [&](const auto& range)
	          {
		          for (std::size_t i = range.begin(); i < range.end(); ++i)
			          f(i);
	          });
}

// Records that a fan of so many corners makes.
std::size_t recordsOfFan(std::size_t corners)
{
	return corners < 3 ? 0 : (corners - 2 + shared::kMaxRecordVertices - 3) / (shared::kMaxRecordVertices - 2);
}

// A width of the whole cell, as a multiple of the polygon's, in the bits of a record.
std::uint32_t widthBits(float width)
{
	const double steps = std::clamp(shared::kRecordWidthSteps * std::log2(std::max(width, 1.0f)), 0.0f, 65535.0f);
	return static_cast<std::uint32_t>(std::lround(steps)) << shared::kRecordWidthShift;
}

} // namespace

float drawnValue(double value)
{
	// Infinite data would overrun the marks for NaN and for an empty pixel.
	constexpr double kLargest = 2.0e38;
	return std::isnan(value) ? shared::kNanValue : static_cast<float>(std::clamp(value, -kLargest, kLargest));
}

MeshRecords::MeshRecords(const grid::BlockSet& blocks, const probe::Sheet& sheet, const SheetMesh& mesh,
                         const std::optional<grid::FieldChoice>& field, PartEdges part_edges)
    : mesh_(mesh), part_edges_(std::move(part_edges)),
      of_vertices_(field && field->association == grid::Association::point)
{
	takePlaces(sheet);
	const auto fields = field ? field->inEach(blocks) : std::vector<const grid::Field*>();
	values_.resize(of_vertices_ ? mesh.positions.size() : mesh.polygons());
	if (!field)
		std::fill(values_.begin(), values_.end(), 0.0f);
	else if (of_vertices_)
	{
		const RawVector<double> values = vertexValues(blocks, mesh, fields, field->component);
		forAll(values.size(), [&](std::size_t v) { values_[v] = drawnValue(values[v]); });
	}
	else
		forAll(values_.size(),
		       [&](std::size_t p)
		       {
			       const auto [b, cell] = mesh.polygon_cells[p];
			       values_[p] = fields[b] ? drawnValue(cellValue(blocks.blocks[b], *fields[b], field->component, cell))
			                              : shared::kNanValue;
		       });
	countRecords();
}

MeshRecords::MeshRecords(const probe::Sheet& sheet, const SheetMesh& mesh, std::span<const double> polygon_values,
                         PartEdges part_edges)
    : mesh_(mesh), part_edges_(std::move(part_edges))
{
	takePlaces(sheet);
	values_.resize(polygon_values.size());
	std::transform(polygon_values.begin(), polygon_values.end(), values_.begin(), drawnValue);
	countRecords();
}

void MeshRecords::takePlaces(const probe::Sheet& sheet)
{
	const Vec3 x_axis = sheet.xAxis();
	places_.resize(mesh_.positions.size());
	bounds_ = parallelReduce(
	    places_.size(), kRecordChunk, UvBounds(),
	    [&](const auto& range, UvBounds bounds)
	    {
		    for (std::size_t v = range.begin(); v < range.end(); ++v)
		    {
			    const Vec3 from_origin = mesh_.positions[v] - sheet.origin;
			    places_[v] = {glm::dot(from_origin, x_axis), glm::dot(from_origin, sheet.up)};
			    bounds = bounds.with(places_[v]);
		    }
		    return bounds;
	    },
	    [](const UvBounds& a, const UvBounds& b) { return a.with(b); });
}

bool MeshRecords::hasInnerSide(std::size_t polygon) const
{
	const std::vector<std::uint8_t>& inner = mesh_.is_inner;
	return !inner.empty() &&
	       std::find(inner.begin() + mesh_.polygon_starts[polygon], inner.begin() + mesh_.polygon_starts[polygon + 1],
	                 1) != inner.begin() + mesh_.polygon_starts[polygon + 1];
}

// Notes whether the polygon is one record, with lines along all sides. places: room to work in.
std::size_t MeshRecords::recordsOf(std::size_t polygon, std::vector<glm::dvec2>& places)
{
	places.clear();
	for (const std::uint32_t v : mesh_.polygon(polygon))
		places.push_back(places_[v]);
	const bool is_fan = isFan(places);
	is_one_[polygon] = is_fan && places.size() <= shared::kMaxRecordVertices && !hasInnerSide(polygon);
	if (is_fan)
		return recordsOfFan(places.size());
	std::size_t records = 0;
	for (const std::vector<std::uint32_t>& fan : cutIntoFans(places))
		records += recordsOfFan(fan.size());
	return records;
}

void MeshRecords::countRecords()
{
	const std::size_t chunks = (mesh_.polygons() + kRecordChunk - 1) / kRecordChunk;
	is_one_.resize(mesh_.polygons());
	chunk_starts_.assign(chunks + 1, 0);
	std::vector<double> longest(chunks, 0.0);
	tracedFor(std::size_t(0), chunks,
	          [&](std::size_t chunk)
	          {
		          std::vector<glm::dvec2> places;
		          const std::size_t end = std::min((chunk + 1) * kRecordChunk, mesh_.polygons());
		          for (std::size_t p = chunk * kRecordChunk; p < end; ++p)
		          {
			          chunk_starts_[chunk + 1] += recordsOf(p, places);
			          UvBounds bounds;
			          for (const glm::dvec2& place : places)
				          bounds = bounds.with(place);
			          longest[chunk] = std::max(longest[chunk], glm::distance(bounds.lo, bounds.hi));
		          }
	          });
	for (const double of_chunk : longest)
		longest_ = std::max(longest_, of_chunk);
	for (std::size_t chunk = 0; chunk < chunks; ++chunk)
		chunk_starts_[chunk + 1] += chunk_starts_[chunk];
	findParts();
}

void MeshRecords::findParts()
{
	std::vector<glm::dvec2> places;
	for (std::size_t p = 1; p < mesh_.polygons(); ++p)
	{
		if (mesh_.polygon_cells[p].block == mesh_.polygon_cells[p - 1].block)
			continue;
		std::size_t record = chunk_starts_[p / kRecordChunk];
		for (std::size_t before = p / kRecordChunk * kRecordChunk; before < p; ++before)
			record += is_one_[before] ? 1 : recordsOf(before, places);
		parts_.push_back(record);
	}
}

// emit(record) for each of the polygon's records.
template <class Emit>
void MeshRecords::writePolygon(std::size_t polygon, std::vector<glm::dvec2>& places, Emit&& emit) const
{
	const auto corners = mesh_.polygon(polygon);
	const auto add = [&](shared::PolygonRecord& record, std::uint32_t corner)
	{
		const std::uint32_t v = corners[corner];
		record.uv[2 * record.vertices] = static_cast<float>(places_[v].x);
		record.uv[2 * record.vertices + 1] = static_cast<float>(places_[v].y);
		record.value[record.vertices] = values_[of_vertices_ ? v : polygon];
		++record.vertices;
	};
	const auto cell = static_cast<std::uint32_t>(mesh_.polygon_cells[polygon].cell);
	const std::uint32_t start = mesh_.polygon_starts[polygon];
	const std::uint32_t width_bits = widthBits(part_edges_.widthOf(polygon));
	if (is_one_[polygon])
	{
		shared::PolygonRecord record{cell, 0, {}, {}};
		std::uint32_t hidden = 0;
		for (std::uint32_t i = 0; i < corners.size(); ++i)
		{
			add(record, i);
			hidden |= part_edges_.isInner(start + i) ? shared::kHiddenRecordEdge << i : 0u;
		}
		record.vertices |= hidden | width_bits;
		return emit(record);
	}
	places.clear();
	for (const std::uint32_t v : corners)
		places.push_back(places_[v]);
	const std::vector<std::uint8_t> is_hidden_side = hiddenSidesOf(mesh_, polygon);
	const auto isHidden = [&](std::uint32_t from, std::uint32_t to)
	{
		return to != (from + 1) % corners.size() || (!is_hidden_side.empty() && is_hidden_side[from]) ||
		       part_edges_.isInner(start + from);
	};
	for (const std::vector<std::uint32_t>& fan : cutIntoFans(places))
		for (std::size_t next = 1; next + 1 < fan.size();)
		{
			const std::size_t first = next;
			shared::PolygonRecord record{cell, 0, {}, {}};
			add(record, fan[0]);
			add(record, fan[next]);
			while (record.vertices < shared::kMaxRecordVertices && next + 1 < fan.size())
				add(record, fan[++next]);
			std::uint32_t hidden = 0;
			const std::uint32_t count = record.vertices;
			const auto cornerAt = [&](std::uint32_t i) { return i % count == 0 ? fan[0] : fan[first + i % count - 1]; };
			for (std::uint32_t i = 0; i < count; ++i)
				if (isHidden(cornerAt(i), cornerAt(i + 1)))
					hidden |= shared::kHiddenRecordEdge << i;
			record.vertices |= hidden | width_bits;
			emit(record);
		}
}

void MeshRecords::write(std::size_t first, std::span<shared::PolygonRecord> to) const
{
	const std::size_t last = first + to.size();
	const auto chunkOf = [&](std::size_t record)
	{ return std::ranges::upper_bound(chunk_starts_, record) - chunk_starts_.begin() - 1; };
	if (to.empty())
		return;
	tracedFor(chunkOf(first), chunkOf(last - 1) + 1,
	          [&](std::ptrdiff_t chunk)
	          {
		          std::vector<glm::dvec2> places;
		          std::size_t next = chunk_starts_[chunk];
		          const std::size_t end = std::min<std::size_t>((chunk + 1) * kRecordChunk, mesh_.polygons());
		          for (std::size_t p = chunk * kRecordChunk; p < end; ++p)
			          writePolygon(p, places,
			                       [&](const shared::PolygonRecord& record)
			                       {
				                       if (next >= first && next < last)
					                       to[next - first] = record;
				                       ++next;
			                       });
	          });
}

} // namespace vp::mesh
