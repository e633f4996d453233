#pragma once

#include <glm/vec2.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace vp::measure
{

// A line in the plane of a sheet. A closed line ends where it begins, and does not repeat this point.
struct PlaneLine
{
	std::vector<glm::dvec2> points;
	bool closed = false;
};

// A piece of a line between two named places.
struct PlaneStep
{
	std::uint64_t from;
	std::uint64_t to;
};

// Chains steps into lines, each step once: those that begin where no step ends first, then closed ones. Where several
// steps begin at a place, any follows; steps around areas give closed lines all the same, since as many begin
// there as end.
std::vector<std::vector<std::uint64_t>> chained(std::vector<PlaneStep> steps);

// A directed edge between two points of a mesh.
struct NetEdge
{
	std::uint32_t from;
	std::uint32_t to;
};

// Returns the directed edges that remain when opposite edges cancel. They bound the triangles whose sides are given.
std::vector<NetEdge> netEdges(std::vector<NetEdge> edges);

// The edges chained, through the places of their ends.
std::vector<PlaneLine> linesOf(std::span<const NetEdge> edges, std::span<const glm::dvec2> points);

} // namespace vp::measure
