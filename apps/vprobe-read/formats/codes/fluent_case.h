#pragma once

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

class vtkUnstructuredGrid;

namespace vp::reader::codes
{

// Cells whose numbers follow each other, from 0.
struct FluentZone
{
	std::int64_t id;
	std::string name;
	std::int64_t first;
	std::int64_t last;
};

// The mesh of a Fluent case: cells by their faces.
struct FluentCase
{
	std::vector<double> coordinates;
	std::int64_t cells = 0;
	std::vector<FluentZone> zones; // zones of cells that exist
	// Per face its corners, and the cells on both sides; -1 where there is none.
	std::vector<std::size_t> face_starts = {0};
	std::vector<std::int32_t> corners;
	std::vector<std::array<std::int32_t, 2>> sides;
};

FluentCase parseFluentCase(std::string_view text);

// The cells of a zone, with the points that they use.
vtkSmartPointer<vtkUnstructuredGrid> fluentGrid(const FluentCase& mesh, const FluentZone& zone);

} // namespace vp::reader::codes
