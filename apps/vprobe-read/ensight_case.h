#pragma once

#include "ensight_cursor.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

// An EnSight Gold case file: its geometry and variables, and the time sets that number their files.
struct EnSightCase
{
	struct Entry
	{
		std::string kind;
		Words words;
	};
	Entry geometry;
	std::vector<Entry> variables;
	struct TimeSet
	{
		std::vector<double> numbers; // of the files
		std::vector<double> times;
		double start = 0.0;
		double increment = 1.0;
	};
	std::map<std::string, TimeSet> sets;
};

// Throws NotUnderstood where it is not Gold.
EnSightCase readEnSightCase(const std::string& file);

// The file that stands for a name with asterisks at the given time. Throws NotUnderstood where none follows.
std::string fileAt(const EnSightCase& about, std::string name, const std::string& set, std::optional<double> time);
