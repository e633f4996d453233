#include "precision_sets.h"

#include "lattice_sets.h"

namespace vp::test
{

RawSet nearWall(const Vec3& offset, bool as_hexahedra)
{
	constexpr std::uint32_t kSide = 9;
	constexpr std::uint32_t kLayers = 60;
	RawBlock block;
	block.kind = RawKind::curvilinear;
	block.points_along = {kSide, kSide, kLayers};
	double height = 0.0;
	double step = 1e-6;
	for (std::uint32_t k = 0; k < kLayers; ++k)
	{
		for (std::uint32_t j = 0; j < kSide; ++j)
			for (std::uint32_t i = 0; i < kSide; ++i)
			{
				const double x = 30.0 * i / (kSide - 1);
				const double y = 30.0 * j / (kSide - 1);
				block.points.push_back(offset + Vec3(x, y, 0.1 * std::sin(x + 2 * y) + height));
			}
		height += step;
		step *= 1.3;
	}
	return {"near wall", {as_hexahedra ? asHexahedra(block) : block}};
}

RawSet farAway(bool as_hexahedra)
{
	Draw draw(23);
	const LatticeKind kind = as_hexahedra ? LatticeKind::hexahedra : LatticeKind::curvilinear;
	RawSet set = latticeSet(kind, draw, {0.1}, {12, 12});
	for (Vec3& p : set.blocks[0].points)
		p = Vec3(1e7, -1e7, 2e7) + 0.01 * p;
	return set;
}

} // namespace vp::test
