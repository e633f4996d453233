#include "picture/context_mesh.h"

#include "find/listed.h"
#include "mesh/boundary_surface.h"
#include "mesh/listed_mesh.h"

#include <fmt/format.h>

namespace vp::picture
{

namespace
{

Error refused(const view::ContextSpec& context, const Error& why)
{
	return {why.kind, fmt::format("`context` {}: {}", view::contextText(context), why.message)};
}

Result<mesh::SheetMesh> gridSurface(const grid::BlockSet& blocks, const view::ContextSpec& context)
{
	view::ContextSpec surface = view::contextOf(context.kind);
	surface.argument = context.argument;
	const Result<surface::GridIndexRange> range = surface::parseGridIndex(view::contextText(surface));
	if (!range)
		return refused(context, range.error());
	if (Status fits = find::checkGridIndex(blocks, *range); !fits)
		return refused(context, fits.error());
	const surface::GridIndex at = range->at(0.0);
	return mesh::gridIndexMesh(blocks, at, find::gridIndexCells(blocks, at));
}

Result<mesh::SheetMesh> patch(const grid::BlockSet& blocks, const view::ContextSpec& context)
{
	if (Status known = find::checkPatch(blocks, context.argument); !known)
		return refused(context, known.error());
	return mesh::patchMesh(blocks, context.argument, find::patchCells(blocks, context.argument));
}

} // namespace

Result<mesh::SheetMesh> contextMesh(const grid::BlockSet& blocks, const view::ContextSpec& context)
{
	switch (context.kind)
	{
	case view::ContextKind::patch:
		return patch(blocks, context);
	case view::ContextKind::boundary:
		return mesh::boundarySurface(blocks);
	default:
		return gridSurface(blocks, context);
	}
}

} // namespace vp::picture
