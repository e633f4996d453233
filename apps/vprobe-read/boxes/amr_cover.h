#pragma once

#include <array>
#include <string>
#include <vector>

class vtkImageData;
class vtkXMLDataElement;

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

// What the index says, of version 1.1 (a Block element a level, with its spacing) or 0.1 (a DataSet element a box, with
// its level as group, and the ratios by themselves).
AmrLevels readAmrLevels(vtkXMLDataElement* index);

bool hasCellsOf(const AmrBox& box, vtkImageData* image);

// Marks the cells of a box under boxes of finer levels as refined, as VTK does: where it covers any part of them.
void markCovered(const AmrLevels& levels, std::size_t level, const AmrBox& box, vtkImageData* image);
