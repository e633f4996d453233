#pragma once

#include "exhaustive.h"
#include "raw_grid.h"

namespace vp::test
{

// Draws numbers, the same for a seed.
class Draw
{
public:
	explicit Draw(unsigned seed) : random_(seed) {}

	double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
	int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
	bool chance(double probability) { return real(0.0, 1.0) < probability; }
	Vec3 around(double reach)
	{
		const double x = real(-reach, reach);
		const double y = real(-reach, reach);
		return {x, y, real(-reach, reach)};
	}
	Vec3 direction() { return randomDirection(random_); }

private:
	std::mt19937 random_;
};

// How far from a lattice the points lie: all of them, and a few that fold the cells about them.
struct Disorder
{
	double jitter = 0.0;
	int bumps = 0;
	double bump = 0.0;
};

// Sets over a lattice of random size.
enum class LatticeKind
{
	plain,      // image or rectilinear
	ring,       // closes on itself, perhaps about an axis
	degenerate, // points drawn together
	blocks,     // two that abut, overlap or miss each other
	curvilinear,
	blanked,
	mixed,     // hexahedra, pyramids, polyhedra and columns of wedges
	doubles,   // polyhedra of two lattice cells
	hexagonal, // polyhedra over hexagons
	hexahedra,
	wedges,
	tetrahedra,
	pyramids,
	polyhedra
};
constexpr int kLatticeKinds = 14;

// Cells along each axis; the default for tests that cut many.
struct LatticeSize
{
	int least = 2;
	int most = 6;
};

// A lattice as explicit hexahedra.
RawBlock asHexahedra(RawBlock lattice);

RawSet latticeSet(LatticeKind kind, Draw& draw, const Disorder& disorder, const LatticeSize& size = {});

} // namespace vp::test
