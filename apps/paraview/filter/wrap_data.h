#pragma once

#include <vprobe/dataset.h>

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDataObject;
class vtkDataSet;

// Data sets of VTK as blocks of the library, which share their arrays.
namespace vprobe_paraview
{

// Input that cannot be cut. The text is one line that names the remedy.
struct Refused : std::runtime_error
{
	using std::runtime_error::runtime_error;
};

// A surface, a line, points: it has no volume. In a composite it is left out.
struct NoVolume : Refused
{
	using Refused::Refused;
};

// Somebody asked to abort.
struct Cancelled : std::exception
{
};

// A data set of a composite, or the only one.
struct Leaf
{
	std::uint32_t index = 0; // as the composite numbers its parts (flat index)
	std::string name;
	vtkDataSet* data = nullptr;
};

// The data sets that there are; those without points and cells are left out.
std::vector<Leaf> leavesOf(vtkDataObject& input);

// Says of what a grid, or arrays, are made: addresses and modification times. Equal stamps mean equal contents.
using Stamps = std::vector<std::uint64_t>;
void addGridStamps(const Leaf& leaf, Stamps& stamps);
void addFieldStamps(const Leaf& leaf, Stamps& stamps);

// The grid with its arrays; throws Refused.
vprobe::Block blockOf(const Leaf& leaf, double tolerance);
// Numeric arrays, without ghost marks.
std::vector<vprobe::Field> fieldsOf(vtkDataSet& data);

// Numbers that share the array's memory and keep it alive. An array of another layout is copied.
vprobe::Numbers numbersOf(vtkDataArray& array);

// A mark for each cell that is not to be shown: a ghost, refined or hidden; of a lattice also cells at hidden points.
// Nothing where all are shown; throws NoVolume where none is.
std::optional<std::vector<bool>> hiddenCells(vtkDataSet& data, const int* lattice);

} // namespace vprobe_paraview
