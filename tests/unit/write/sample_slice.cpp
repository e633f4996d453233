#include "sample_slice.h"

#include "cut/cutter.h"
#include "grid/demo/demo.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <stdexcept>

namespace vp::test
{

namespace
{

using grid::Association;

grid::Block mixedBlock()
{
	grid::Block block = grid::makeDemo("mixed", 6).value().blocks[0];
	const auto& cells = std::get<grid::UnstructuredGrid>(block.grid);
	std::vector<std::int16_t> levels(cells.pointCount());
	std::iota(levels.begin(), levels.end(), std::int16_t(-20));
	std::vector<std::int64_t> ids(cells.cellCount());
	std::iota(ids.begin(), ids.end(), kFirstId);
	std::vector<std::uint8_t> flags(cells.cellCount());
	std::vector<double> odd(2 * cells.cellCount());
	for (std::size_t c = 0; c < flags.size(); ++c)
	{
		flags[c] = static_cast<std::uint8_t>(200 + c % 50);
		odd[2 * c] = 0.1 * static_cast<double>(c);
		odd[2 * c + 1] = -1.0 / 3.0;
	}
	block.fields.push_back(grid::makeField("level", Association::point, 1, std::move(levels)));
	block.fields.push_back(grid::makeField("id", Association::cell, 1, std::move(ids)));
	block.fields.push_back(grid::makeField("flag", Association::cell, 1, std::move(flags)));
	block.fields.push_back(grid::makeField(kOddName, Association::cell, 2, std::move(odd)));
	grid::finishBlock(block);
	return block;
}

grid::Block imageBlock()
{
	grid::Block block;
	const grid::UniformGrid image({4, 4, 4}, Vec3(3.0, -3.0, -3.0), Vec3(2.0));
	std::vector<double> s(image.pointCount());
	std::vector<float> v(3 * image.pointCount());
	for (PointId p = 0; p < image.pointCount(); ++p)
	{
		const Vec3 at = image.point(p);
		s[p] = at.x / 3.0;
		for (int c = 0; c < 3; ++c)
			v[3 * p + c] = static_cast<float>(at[c]);
	}
	block.fields.push_back(grid::makeField("s", Association::point, 1, std::move(s)));
	block.fields.push_back(grid::makeField("v", Association::point, 3, std::move(v)));
	block.fields.push_back(
	    grid::makeField("flag", Association::cell, 1, std::vector<std::uint8_t>(image.cellCount(), 7)));
	block.grid = image;
	grid::finishBlock(block);
	return block;
}

} // namespace

std::size_t SampleSlice::vertices() const
{
	return meshes[0].positions.size() + meshes[1].positions.size();
}

std::size_t SampleSlice::polygons() const
{
	return meshes[0].polygons() + meshes[1].polygons();
}

std::size_t SampleSlice::corners() const
{
	return meshes[0].polygon_vertices.size() + meshes[1].polygon_vertices.size();
}

SampleSlice sampleSlice()
{
	SampleSlice sample;
	sample.blocks.blocks = {mixedBlock(), imageBlock()};
	cut::Cutter cutter(sample.blocks);
	cut::CutRequest request;
	request.in_generations = true;
	request.probe.sheets = {probe::makeSheet({0.1, 0.2, 0.3}, {0.3, 0.5, 0.81}),
	                        probe::makeSheet({4.1, 0.0, 0.0}, {1.0, 0.1, 0.0})};
	const cut::Cut slice = cutter.cut(request).value();
	for (std::size_t s = 0; s < slice.sheets.size(); ++s)
		sample.meshes.push_back(slice.mesh(sample.blocks, s));
	return sample;
}

TemporaryFolder::TemporaryFolder()
{
	std::string pattern = (std::filesystem::temp_directory_path() / "vprobe-test-XXXXXX").string();
	if (!mkdtemp(pattern.data()))
		throw std::runtime_error("no temporary folder");
	path_ = pattern;
	std::filesystem::permissions(path_, std::filesystem::perms(0755));
}

TemporaryFolder::~TemporaryFolder()
{
	std::error_code ignored;
	std::filesystem::permissions(path_, std::filesystem::perms(0755), ignored);
	std::filesystem::remove_all(path_, ignored);
}

std::size_t TemporaryFolder::files() const
{
	const std::filesystem::directory_iterator entries(path_);
	return static_cast<std::size_t>(std::distance(begin(entries), end(entries)));
}

std::string readText(const std::string& path)
{
	std::ifstream file(path, std::ios::binary);
	return {std::istreambuf_iterator<char>(file), {}};
}

void writeText(const std::string& path, const std::string& text)
{
	std::ofstream(path, std::ios::binary) << text;
}

} // namespace vp::test
