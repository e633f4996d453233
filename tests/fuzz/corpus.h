#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace fuzz
{

// A whole data set: the file that is opened, and all that lies beside it.
struct DataSet
{
	std::string name;
	std::filesystem::path folder;
	std::vector<std::filesystem::path> inputs; // within the folder; what can be opened, one for each file name ending
	std::vector<std::filesystem::path> files;  // within the folder
	std::uint64_t bytes = 0;                   // all of them
};

// Writes one small file of every format that can be written here into folders of its own below `folder`, and a few
// larger ones if those are wanted.
std::vector<DataSet> writeSamples(const std::filesystem::path& folder, bool with_large);

// Sets of real data in the folders of `data`, one for each folder two levels down, of no more than so many bytes.
std::vector<DataSet> findRealSets(const std::filesystem::path& data, std::uint64_t most_bytes);

} // namespace fuzz
