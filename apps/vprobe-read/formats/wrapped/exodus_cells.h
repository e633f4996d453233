#pragma once

#include <cstdint>
#include <string>
#include <vector>

class vtkExodusIIReader;
class vtkMultiBlockDataSet;

namespace vp::reader::wrapped
{

// A block of elements whose nodes VTK's reader mixes up.
struct OddExodusBlock
{
	std::int64_t id;
	std::string connectivity; // the name of its variable
	std::size_t form;         // in the table of element types
};

// Finds such blocks by their element type and number of nodes. Throws a Refusal that names the type where there is no
// way to read it.
std::vector<OddExodusBlock> oddExodusBlocks(const std::string& file);

// Returns true if a block lists the faces of its cells.
bool hasExodusPolyhedra(const std::string& file);

// Leaves out the points that a block does not use, where the reader has kept all points of the file in each block.
// numbers_nodes: whether the others get the numbers of their nodes (numberExodusNodes()).
void leaveOutExodusPoints(vtkMultiBlockDataSet* objects, bool numbers_nodes);

// Replaces the cells of these blocks by what the file lists. The reader must have kept all points of the file in each
// block; the points that a block does not use are left out. A node that the element lacks, and VTK's cell has, is
// placed where the element's shape functions put it.
void putExodusCellsRight(const std::string& file, const std::vector<OddExodusBlock>& odd, vtkExodusIIReader* reader,
                         vtkMultiBlockDataSet* objects);

} // namespace vp::reader::wrapped
