#pragma once

#include <optional>
#include <string>

// What the parent asks for.
struct Request
{
	std::string file;
	std::string solution; // PLOT3D q file; may be empty
	enum class Time
	{
		last,
		first,
		nearest
	} time = Time::last;
	double time_value = 0.0;
	int refine = 0; // how many times the linear parts of curved cells are halved
};
