#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

class vtkDataSet;

// Variables of three or more dimensions that VTK's reader fails on, or takes for something else.
struct NetcdfVolumes
{
	bool has_groups = false;
	std::vector<std::string> unread;          // whose values are texts or of a type of the file's own
	std::vector<std::string> whole;           // of types of whole numbers that VTK lacks, or takes for unsigned
	std::map<std::string, std::string> empty; // each with a dimension that is 0: VTK's reader crashes over them
};

// `name`: of a file, or an address that the netCDF library opens.
NetcdfVolumes netcdfVolumes(const std::string& name);

// Adds variables of whole numbers to the points or cells of a grid, at a time.
void addWholeNumbers(const std::string& name, const std::vector<std::string>& variables, std::optional<double> time,
                     vtkDataSet* data);
