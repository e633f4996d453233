#pragma once

#include "array_wish.h"

#include <cstddef>
#include <string>
#include <vector>

// Holds the parent's request.
struct Request
{
	std::string file;
	std::string format;   // its name in format_table.inl; empty where the file tells
	std::string raw;      // how the values of a raw volume are laid out, see read/raw_layout.h; may be empty
	std::string solution; // PLOT3D q file; may be empty
	enum class Time
	{
		last,
		first,
		nearest,
		index
	} time = Time::last;
	double time_value = 0.0;
	std::size_t time_index = 0;
	double displace = 0.0;       // what Exodus displacements are multiplied with; 0 leaves the points where they are
	bool patches = false;        // whether the parts of the boundary that the file names are wanted
	double refine = 0.0;         // how often the linear parts of curved cells are halved, or a tolerance
	int threads = 1;             // the most to use
	std::string convert_to;      // the file that is to be written; mostly empty
	std::string convert_folder;  // of the parent's, into which it is written
	ArrayWish arrays;            // those to hand over
	std::string sandbox = "off"; // auto, require or off
	std::vector<std::string> follow; // folders with files that the input may name, or "anywhere"
	std::string parts;               // those to hand over, see PartFilter; mostly empty
	char** arguments = nullptr;      // as the process was started with them
};
