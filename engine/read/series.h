#pragma once

#include "read/read.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vp::read
{

/// How several inputs belong together.
enum class InputsAs : std::uint8_t
{
	automatic, // stack, if they are pictures of two dimensions; times if their names differ by a number alone and their
	           // grids are the same; otherwise blocks
	blocks,    // all together are one data set
	times,     // each is one time of a series
	stack      // each is a slice of one volume
};

/// Files that are times of one series: one input for readInputs() and the other functions of read.h, which read the
/// file of the time that they are asked for.
struct FileSeries
{
	std::vector<std::string> files; // at least two
	std::vector<double> times;      // ascending, one of each file
};

/// Returns the series as a name of an input. It begins with "series:", as no file's name does that is given by a user.
std::string seriesInput(const FileSeries& series);
std::optional<FileSeries> parseSeries(const std::string& input);

/// Returns files that are slices of one volume, from the first to the last, as the name of an input for the same
/// functions.
std::string stackInput(const std::vector<std::string>& files);
std::vector<std::string> parseStack(const std::string& input); // nothing for other inputs

/// Returns the inputs as the functions of read.h take them: as they are, one series or one stack. Times of a series are
/// those in the files, else the numbers in the names, else counted from 0. Slices come in the order of the numbers in
/// their names, else as they are given. With `automatic`, the first two files are opened if their names are alike, or
/// if they are DICOM, TIFF or PNG files; a line tells the user that a series was found. Returns an input error if a
/// file cannot be read, and a usage error if built-in data sets or files of several times are to be times or slices.
Result<std::vector<std::string>> takeInputs(const std::vector<std::string>& inputs, InputsAs as,
                                            const ReadOptions& options);

/// Returns the number in which the names differ, for names that are the same but for one number: {2, 3, 10} for
/// a_02.vti, a_03.vti and a_10.vti. Returns nothing for other names, or if two numbers are the same.
std::optional<std::vector<double>> numbersOfNames(const std::vector<std::string>& names);

} // namespace vp::read
