#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vp::reader::meshes
{

// One of the times of a case. `occurrence` counts the steps of equal times.
struct EnSightTime
{
	double time = 0.0;
	std::size_t occurrence = 0;
};

// An EnSight case file, of EnSight 6 or Gold: its geometry and variables, and how the steps lie in their files.
struct EnSightCase
{
	// Files of a geometry or a variable: asterisks stand for the number of a step.
	struct Files
	{
		std::vector<std::string> names; // two for a complex variable
		std::optional<std::int64_t> time_set;
		std::optional<std::int64_t> file_set;
	};
	struct Variable
	{
		std::string name;
		Files files;
		bool per_node = true;
		int components = 1; // 1, 3, 6 or 9
	};
	struct TimeSet
	{
		std::vector<double> times;         // in the order of the file
		std::vector<std::int64_t> numbers; // numbers of files, one for each time
	};
	struct Constant
	{
		std::string name;
		std::vector<double> values; // one, or one for each step
		std::optional<std::int64_t> time_set;
	};
	struct FileSet
	{
		struct File
		{
			std::optional<std::int64_t> number; // which stands for the asterisks
			std::size_t steps = 0;
		};
		std::vector<File> files;
	};

	bool is_gold = false;
	Files model;
	bool changes_coordinates_only = false;
	std::size_t step_of_cells = 0; // the step whose geometry has the cells then
	std::vector<Variable> variables;
	std::map<std::int64_t, TimeSet> time_sets;
	std::map<std::int64_t, FileSet> file_sets;
	std::vector<Constant> constants;
	std::vector<std::string> left_out; // what is named besides, in words of a note
	std::vector<std::string> notes;
};

// Throws a Refusal if the case is damaged or of another version.
EnSightCase readEnSightCase(const std::string& file);

// The times of all sets that are in use, ascending; equal ones of a set stand more than once.
std::vector<double> timesOf(const EnSightCase& about);

// Which step of a time set is shown at a time: the latest one that is not after it. If all are after it, the first one,
// and `is_before` is set.
std::size_t stepAt(const EnSightCase::TimeSet& set, const EnSightTime& time, bool& is_before);

// Where the values of a step lie.
struct EnSightPlace
{
	std::string file;
	std::size_t step = 0;   // within the file
	bool has_steps = false; // the case says that the file holds several
};

// `step`: of the time set of the files. `which` of the names. Throws a Refusal if the case names no such step.
EnSightPlace placeOf(const EnSightCase& about, const EnSightCase::Files& files, std::size_t which, std::size_t step);

// The time set that the files use; null if they do not change.
const EnSightCase::TimeSet* timeSetOf(const EnSightCase& about, const EnSightCase::Files& files);

} // namespace vp::reader::meshes
