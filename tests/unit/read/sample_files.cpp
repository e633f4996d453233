#include "sample_files.h"

#include "more_samples.h"
#include "own_samples.h"
#include "plot3d_samples.h"
#include "vtk_samples.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include <unistd.h>

using namespace vp;

TemporaryFolder::TemporaryFolder()
{
	std::string pattern = (std::filesystem::temp_directory_path() / "vprobe_read_XXXXXX").string();
	if (!mkdtemp(pattern.data()))
		throw std::runtime_error("no temporary folder");
	path_ = pattern;
}

TemporaryFolder::~TemporaryFolder()
{
	std::error_code ignored;
	std::filesystem::remove_all(path_, ignored);
}

std::string contentsOf(const std::string& path)
{
	std::ostringstream out;
	out << std::ifstream(path, std::ios::binary).rdbuf();
	return out.str();
}

void writeContents(const std::string& path, const std::string& contents)
{
	std::ofstream(path, std::ios::binary) << contents;
}

double sampleValue(const Vec3& point)
{
	return point.x + 10.0 * point.y + 100.0 * point.z;
}

void expectSampleValues(const grid::Block& block, bool cell_array, bool point_array)
{
	const auto field = [&](const char* name) -> const grid::Field*
	{
		for (const grid::Field& each : block.fields)
			if (each.name == name)
				return &each;
		return nullptr;
	};
	const grid::Field* f = field("f");
	const grid::Field* g = field("g");
	ASSERT_EQ(f != nullptr, point_array) << block.name;
	ASSERT_EQ(g != nullptr, cell_array) << block.name;
	std::visit(
	    [&](const auto& grid)
	    {
		    for (std::size_t p = 0; f && p < grid.pointCount(); ++p)
		    {
			    const auto point = static_cast<PointId>(p);
			    ASSERT_NEAR(f->value(grid.sourcePoint(point), 0), sampleValue(grid.point(point)), 1e-3);
		    }
		    for (std::size_t c = 0; g && c < grid.cellCount(); ++c)
		    {
			    const auto cell = static_cast<CellId>(c);
			    if (grid.shape(cell) == grid::CellShape::polyhedron)
				    continue;
			    const grid::CellPoints ids = grid.cellPoints(cell);
			    Vec3 sum{0.0};
			    for (const PointId id : ids)
				    sum += grid.point(id);
			    ASSERT_NEAR(g->value(grid.sourceCell(cell), 0), sampleValue(sum / double(ids.size)), 1e-3);
		    }
	    },
	    block.grid);
}

const std::vector<SampleFile>& sampleFiles()
{
	static const std::vector<SampleFile> files = []
	{
		std::vector<SampleFile> all = vtkSamples();
		const std::vector<SampleFile> more = plot3dSamples();
		all.insert(all.end(), more.begin(), more.end());
		const std::vector<SampleFile> further = moreSamples(all);
		all.insert(all.end(), further.begin(), further.end());
		for (const std::vector<SampleFile>& own :
		     {ownSamples(), scanSamples(), codeSamples(), containerSamples(), boxSamples(), flowSamples()})
			all.insert(all.end(), own.begin(), own.end());
		return all;
	}();
	return files;
}
