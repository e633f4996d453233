#pragma once

#include "grid/block.h"
#include "mesh/sheet_mesh.h"

#include <string>
#include <vector>

namespace vp::test
{

// Two blocks that hold their arrays differently, cut by two sheets.
struct SampleSlice
{
	grid::BlockSet blocks;
	std::vector<mesh::SheetMesh> meshes;

	std::size_t vertices() const;
	std::size_t polygons() const;
	std::size_t corners() const;
};

// Arrays: points s (float32 in block 0, float64 in block 1), v (float32, three components), level (int16, block 0
// only); cells id (int64 past 2^53 in block 0, block 1 lacks it), flag (uint8), `odd, "name"` (float64, two components,
// block 0 only).
SampleSlice sampleSlice();

constexpr const char* kOddName = "odd, \"name\"";
constexpr std::int64_t kFirstId = (std::int64_t(1) << 53) + 1; // no double holds it

// A folder that goes with everything in it.
class TemporaryFolder
{
public:
	TemporaryFolder();
	~TemporaryFolder();
	TemporaryFolder(const TemporaryFolder&) = delete;
	TemporaryFolder& operator=(const TemporaryFolder&) = delete;

	std::string operator/(const std::string& name) const { return path_ + "/" + name; }
	const std::string& path() const { return path_; }
	std::size_t files() const; // hidden ones too

private:
	std::string path_;
};

std::string readText(const std::string& path);
void writeText(const std::string& path, const std::string& text);

} // namespace vp::test
