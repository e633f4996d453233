#pragma once

#include "base/ids.h"
#include "base/vec.h"
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

// One that is under way, in one direction.
struct Particle
{
	Vec3 place;
	Vec3 vector{0.0};   // whole
	double time = 0.0;  // since its launch, in either direction
	double sense = 1.0; // -1: backward
	std::uint32_t block;
	CellId cell;
	double substep = HUGE_VAL; // as long as the error last allowed
	PairChoice pair;
	std::size_t substeps = 0;    // of the present step
	std::size_t idle = 0;        // crossings since it last moved
	std::optional<TraceEnd> end; // why it is not under way any more
	std::vector<PathPoint> path; // with the launch

	void record() { path.push_back({place, time, vector, block, cell}); }
	void stop(TraceEnd why)
	{
		if (path.empty() || path.back().time < time)
			record();
		end = why;
	}
};

} // namespace vp::vectors
