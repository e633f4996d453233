#pragma once

#include "exhaustive.h"
#include "raw_grid.h"

#include "grid/field.h"
#include "grid/field_choice.h"

#include <functional>
#include <utility>
#include <vector>

namespace vp::test
{

// The point fields of withFields().
inline const grid::FieldChoice kScalarField{"u", grid::Association::point, 0};
inline const grid::FieldChoice kVectorField{"flow", grid::Association::point, 0};

// The values at a place.
struct AtPlace
{
	double scalar;
	Vec3 vector;
};
using FieldsAt = std::function<AtPlace(const Vec3&)>;

// A finished set with a scalar and a vector at its points.
inline grid::BlockSet withFields(const RawSet& raw, const FieldsAt& fields)
{
	grid::BlockSet set = build(raw);
	for (grid::Block& block : set.blocks)
	{
		std::vector<double> scalars;
		std::vector<double> vectors;
		visitGrid(block,
		          [&](const auto& grid)
		          {
			          scalars.resize(grid.pointCount());
			          vectors.resize(3 * grid.pointCount());
			          for (PointId p = 0; p < grid.pointCount(); ++p)
			          {
				          const AtPlace here = fields(grid.point(p));
				          const std::size_t source = grid.sourcePoint(p);
				          scalars[source] = here.scalar;
				          for (int c = 0; c < 3; ++c)
					          vectors[3 * source + static_cast<std::size_t>(c)] = here.vector[c];
			          }
		          });
		block.fields.push_back(grid::makeField("u", grid::Association::point, 1, std::move(scalars)));
		block.fields.push_back(grid::makeField("flow", grid::Association::point, 3, std::move(vectors)));
	}
	return set;
}

} // namespace vp::test
