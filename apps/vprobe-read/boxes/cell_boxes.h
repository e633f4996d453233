#pragma once

#include "vprobe-read/base/request.h"

#include <vtkSmartPointer.h>

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

class vtkDataSet;
class vtkImageData;

namespace vp::reader::manifest
{
class Writer;
}

namespace vp::reader::boxes
{

// A box of equal cells, as codes write them that refine by boxes.
struct CellBox
{
	std::array<double, 3> lo;
	std::array<double, 3> hi;
	std::array<std::size_t, 3> cells;

	std::size_t cellCount() const { return cells[0] * cells[1] * cells[2]; }
};

// Throws a Refusal for an impossible box.
vtkSmartPointer<vtkImageData> imageOfBox(const CellBox& box);

// Adds an array of doubles to the cells. It has as many components as there are values per cell.
void addCellArray(vtkDataSet* data, const std::string& name, std::span<const double> values);

struct CellArrayName
{
	std::string name;
	int components = 1;
};

// Chooses the arrays of cells that are handed over, so that no time is lost in reading the others. The others are
// reported for each block.
class CellArrayChoice
{
public:
	CellArrayChoice(const Request& request, const std::vector<CellArrayName>& arrays);
	const std::vector<std::string>& wanted() const { return wanted_; }
	// Call this before a block is added.
	void noteLeftOut(manifest::Writer& manifest) const;

private:
	std::vector<std::string> wanted_;
	std::vector<CellArrayName> left_out_;
};

// Offers the time of a file that holds only one. time: NaN if the file does not say it.
void offerOnlyTime(double time, const Request& request, manifest::Writer& manifest);

} // namespace vp::reader::boxes
