#pragma once

#include "grid/block.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

// A folder of its own for a test, gone with it.
class TemporaryFolder
{
public:
	TemporaryFolder();
	~TemporaryFolder();
	TemporaryFolder(const TemporaryFolder&) = delete;
	TemporaryFolder& operator=(const TemporaryFolder&) = delete;

	std::string operator/(const std::string& name) const { return (path_ / name).string(); }

private:
	std::filesystem::path path_;
};

// A small file of one of the formats, with point array "f" = x + 10 y + 100 z, and cell array "g", the same of the mean
// of the cell's points, where the format has cell arrays.
struct SampleFile
{
	std::string name;
	std::function<void(const std::string& path)> write; // and files beside it
	std::string kind;
	std::size_t cells;
	std::size_t points;
	bool cell_array = true;
	std::string beside; // the file that holds the data, where it is not this one; cut in its place
	bool point_array = true;
};

const std::vector<SampleFile>& sampleFiles();

constexpr std::array<int, 3> kSamplePoints = {5, 4, 6}; // along the axes of the lattices

double sampleValue(const vp::Vec3& point);

// EXPECTs that f and g have their values all over the block.
void expectSampleValues(const vp::grid::Block& block, bool cell_array, bool point_array = true);

std::string contentsOf(const std::string& path);
void writeContents(const std::string& path, const std::string& contents);
