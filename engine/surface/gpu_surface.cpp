#include "surface/gpu_surface.h"

#include "surface/expression_glsl.h"

namespace vp::surface
{

std::optional<Curved> gpuSurfaceOf(const BlockSurface& surface)
{
	// Half a second with a software driver, once for a surface and a kind of grid.
	constexpr int kMaxCost = 256;
	if (const Quadric* quadric = surface.quadric())
		return *quadric;
	const PlacedExpression* placed = surface.expression();
	if (!placed || shaderCost(placed->expression()) > kMaxCost)
		return std::nullopt;
	return *placed;
}

} // namespace vp::surface
