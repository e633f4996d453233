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

// The part of a vector that moves a particle.
enum class VectorPart : std::uint8_t
{
	whole,
	tangential, // in the sheet
	normal      // through it
};

// The settings that hold for all particles of a call.
struct Motion
{
	double steps; // may end in a fraction
	double dt;
	double tolerance; // allowed error of a substep, as a share of a cell
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
	int face;    // the cell's face, by the axes of the source (cell_field.h)
	double rate; // speed there, in cells per unit of time
};

// Where in its cell a particle is, from which the search for the next place begins.
struct CellStand
{
	Vec3 u;        // in the cell, whose axes are those of the source
	Vec3 place;    // the place for which `u` was found
	bool in_parts; // the cell was searched as tetrahedra
};

// The state that a particle keeps from one substep to the next, without its path. It is a plain struct and can be sent
// as bytes. A process that continues from it gets the same bits.
struct ParticleState
{
	Vec3 place;
	Vec3 vector{0.0};   // whole
	double time = 0.0;  // since its launch, in either direction
	double sense = 1.0; // -1: backward
	std::uint32_t block;
	CellId cell;
	double substep = HUGE_VAL; // length that the error last allowed
	PairChoice pair;
	std::size_t substeps = 0;         // substeps of the present step so far
	std::size_t idle = 0;             // crossings since it last moved
	std::size_t points = 0;           // number of points of its path, with the launch
	double last_time = 0.0;           // time of the last of them
	std::optional<CellStand> stand{}; // set within a block; else the particle enters the cell anew
	std::optional<Exit> exit{};       // the exit at which the particle stands
	std::optional<TraceEnd> end{};    // why the particle has stopped
};

// A place beyond the end of a block that blocks of other processes may hold.
struct AskedPlace
{
	Vec3 place;
	double reach;                       // distance of the place from the particle
	std::vector<std::uint32_t> blocks;  // blocks that may contain the place; ascending
	std::optional<mesh::BlockCell> own; // own cell that contains the place if no other block does
};

// A particle that moves in one direction.
struct Particle : ParticleState
{
	std::vector<PathPoint> path; // with the launch; each of several processes has some of the points
	// The cell or the place that the particle waits for (elsewhere.h).
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
