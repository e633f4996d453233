#pragma once

#include "grid/check/memory.h"
#include "session/session.h"

#include <string>
#include <utility>
#include <vector>

namespace vp::app
{

// Describes the data that a window shows. It is a copy, because the session belongs to the thread that cuts.
struct DatasetInfo
{
	struct Array
	{
		std::string word; // as --array takes it: point:NAME, cell:NAME
		std::string name;
		grid::Association association = grid::Association::point;
		int components = 1;
	};
	static bool isVector(const Array& array) { return array.components == 3; }

	std::vector<std::string> inputs;
	std::string kind; // kind of the grid, in the words of `vprobe info`
	std::size_t cells = 0;
	std::size_t points = 0;
	std::size_t blocks = 0;
	Box bounds;
	std::vector<Vec3> extent; // points close around the data, which a fitted camera must show
	std::vector<Array> arrays;
	std::vector<double> times; // ascending; empty if the input has none
	std::vector<std::string> patches;
	grid::Memory memory; // memory of the blocks right after loading
	std::string device;
	std::string classifier;  // gpu or cpu
	bool structured = false; // cells have subscripts i, j, k
};

DatasetInfo factsOf(const session::Session& session, const std::vector<std::string>& inputs);

} // namespace vp::app
