#pragma once

#include "base/ids.h"
#include "base/vec.h"
#include "mesh/sheet_mesh.h"
#include "vectors/runge_kutta.h"
#include "vectors/traces.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace vp::vectors
{

enum class Direction : std::uint8_t
{
	forward,
	backward,
	both
};

// What of a vector moves a particle.
enum class VectorPart : std::uint8_t
{
	whole,
	tangential, // in the sheet
	normal      // through it
};

// What holds for all particles of a call.
struct Motion
{
	double steps; // may end in a fraction
	double dt;
	double tolerance; // of a cell, per substep
	VectorPart part;
	Vec3 normal; // unit
	bool steady; // else a vector may be zero for a while

	double total() const { return steps * dt; }
	std::size_t wholeSteps() const { return static_cast<std::size_t>(steps); }
	// When the point after so many others is due.
	double due(std::size_t points) const { return points <= wholeSteps() ? static_cast<double>(points) * dt : total(); }

	Vec3 moving(const Vec3& vector) const
	{
		if (part == VectorPart::whole)
			return vector;
		const Vec3 through = glm::dot(vector, normal) * normal;
		return part == VectorPart::normal ? through : vector - through;
	}
};

struct PathPoint
{
	Vec3 place;
	double time;
	Vec3 vector; // whole
	std::uint32_t block;
	CellId cell;
};

// A place on a face through which a particle left its block.
struct Exit
{
	int face;    // of the cell, its axes those of the source (cell_field.h)
	double rate; // cells a unit of time, of the motion there
};

// Where in its cell a particle is, from which the search for the next place begins.
struct CellStand
{
	Vec3 u;        // in the cell, whose axes are those of the source
	Vec3 place;    // that it was found for
	bool in_parts; // of the cell as tetrahedra
};

// What a particle keeps from one substep to the next, but for its path. A plain struct, which may be sent as bytes: who
// goes on from there comes to the same bits.
struct ParticleState
{
	Vec3 place;
	Vec3 vector{0.0};   // whole
	double time = 0.0;  // since its launch, in either direction
	double sense = 1.0; // -1: backward
	std::uint32_t block;
	CellId cell;
	double substep = HUGE_VAL; // as long as the error last allowed
	PairChoice pair;
	std::size_t substeps = 0;         // of the present step
	std::size_t idle = 0;             // crossings since it last moved
	std::size_t points = 0;           // of its path, with the launch
	double last_time = 0.0;           // of the last of them
	std::optional<CellStand> stand{}; // in the midst of a block; else it enters the cell anew
	std::optional<Exit> exit{};       // that it stands on
	std::optional<TraceEnd> end{};    // why it is not under way any more
};

// A place beyond the end of a block that blocks of other processes may hold.
struct AskedPlace
{
	Vec3 place;
	double reach;                       // of the place from the particle
	std::vector<std::uint32_t> blocks;  // that may hold it; ascending
	std::optional<mesh::BlockCell> own; // that holds it, if none of them does
};

// One that is under way, in one direction.
struct Particle : ParticleState
{
	std::vector<PathPoint> path; // with the launch; of several processes, each has some of the points
	// What it waits for (elsewhere.h).
	std::optional<mesh::BlockCell> missing{};
	std::optional<AskedPlace> asked{};

	void record()
	{
		path.push_back({place, time, vector, block, cell});
		++points;
		last_time = time;
	}
	void stop(TraceEnd why)
	{
		if (points == 0 || last_time < time)
			record();
		end = why;
	}
};

} // namespace vp::vectors
