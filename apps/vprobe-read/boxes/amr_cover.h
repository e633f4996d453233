#pragma once

#include <array>
#include <string>
#include <vector>

class vtkImageData;
class vtkXMLDataElement;

namespace vp::reader::boxes
{

// A box of an AMR index: cells lo to hi of its level, both included.
struct AmrBox
{
	std::array<int, 3> lo;
	std::array<int, 3> hi;
	std::string file;
	std::size_t number; // within its level
};

struct AmrLevels
{
	std::vector<std::vector<AmrBox>> boxes;
	std::vector<int> ratios; // from a level to the next finer one; empty where levels do not overlap
};

// Reads an index of version 1.1 (one Block element per level, with its spacing) or 0.1 (one DataSet element per box,
// with its level as group, and separate ratios).
AmrLevels readAmrLevels(vtkXMLDataElement* index);

bool hasCellsOf(const AmrBox& box, vtkImageData* image);

// Marks cells of a box as refined if a box of a finer level covers any part of them, as VTK does.
void markCovered(const AmrLevels& levels, std::size_t level, const AmrBox& box, vtkImageData* image);

} // namespace vp::reader::boxes
