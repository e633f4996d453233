#include "find/curved_sheet.h"

#include "grid/shown_value.h"

#include <algorithm>
#include <cmath>

namespace vp::find
{

namespace
{

// A surface that cuts nothing, since every point is above it.
const surface::BlockSurface kNowhere(surface::Quadric({0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}));

surface::BlockSurface isoSurface(std::size_t number, const grid::Block& block, double value,
                                 const std::optional<grid::FieldChoice>& choice, ValueRanges* ranges)
{
	const grid::Field* field = choice ? choice->in(block) : nullptr;
	if (!field || field->association != grid::Association::point || choice->component >= field->components)
		return kNowhere;
	return surface::BlockSurface(surface::BlockValues{
	    field, choice->component, value, ranges ? ranges->of(number, block, *field, choice->component) : nullptr});
}

} // namespace

std::shared_ptr<const surface::LeafValues> ValueRanges::of(std::size_t number, const grid::Block& block,
                                                           const grid::Field& field, int component)
{
	const std::lock_guard lock(mutex_);
	Kept& kept = kept_[number];
	if (!kept.ranges || kept.values != field.identity() || kept.component != component)
		kept = {field.identity(), component, std::make_shared<surface::LeafValues>(block, field, component)};
	return kept.ranges;
}

void ValueRanges::forget()
{
	const std::lock_guard lock(mutex_);
	for (Kept& kept : kept_)
		kept = {};
}

std::size_t ValueRanges::bytes() const
{
	const std::lock_guard lock(mutex_);
	std::size_t sum = 0;
	for (const Kept& kept : kept_)
		sum += kept.ranges ? kept.ranges->bytes() : 0;
	return sum;
}

std::vector<surface::BlockSurface> isoSurfaces(const grid::BlockSet& blocks, double value,
                                               const std::optional<grid::FieldChoice>& field, ValueRanges* ranges)
{
	std::vector<surface::BlockSurface> surfaces;
	for (std::size_t b = 0; b < blocks.blocks.size(); ++b)
		surfaces.push_back(isoSurface(b, blocks.blocks[b], value, field, ranges));
	return surfaces;
}

std::vector<surface::BlockSurface> surfacesOf(const grid::BlockSet& blocks, const probe::Sheet& sheet,
                                              const std::optional<grid::FieldChoice>& field, ValueRanges* ranges)
{
	if (const surface::IsoValue* iso = sheet.form->isoValue())
		return isoSurfaces(blocks, iso->value, field, ranges);
	const auto one =
	    std::visit([](auto&& placed) { return surface::BlockSurface(placed); }, sheet.form->placed(sheet.axes()));
	return std::vector(blocks.blocks.size(), one);
}

grid::CellFilter finiteCells(const grid::Block& block, const surface::BlockSurface& surface)
{
	const surface::BlockValues* values = surface.values();
	if (!values || (values->leaves && values->leaves->allFinite()))
		return {};
	return [&block, field = values->field, component = values->component](CellId cell)
	{
		const auto isFinite = [&](const auto& grid)
		{
			grid::CellFaces faces;
			grid.cellFaces(cell, faces);
			return std::ranges::all_of(
			    faces.points,
			    [&](PointId p) { return std::isfinite(grid::shownValue(*field, grid.sourcePoint(p), component)); });
		};
		return std::visit(isFinite, block.grid);
	};
}

} // namespace vp::find
