#include "sample_slice.h"

#include "grid/demo/demo.h"
#include "locate/find_cell.h"
#include "vectors/tracer.h"
#include "vectors/vector_array.h"
#include "write/particle_file.h"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include <array>

namespace vp::test
{

using vectors::Launch;
using vectors::Traces;

TEST(ParticleFile, HoldsPathsAndWhyTheyEnd)
{
	const grid::BlockSet blocks = std::move(*grid::makeDemo("shell", 12));
	const Vec3 inside(0.1, 2.0, 0.2);
	const CellId cell = locate::findCell(blocks.blocks[0], kNoCell, inside).cell;
	vectors::TraceOptions options;
	options.steps = 30.0;
	options.dt = 0.1;
	options.direction = vectors::Direction::both;
	const grid::FieldChoice array = vectors::chooseVectors(blocks, "v").value();
	const std::vector<Launch> first{{inside, 0, cell, 3}, {Vec3(9.0), 0, kNoCell, 4}};
	const std::vector<Launch> second{{inside, 0, cell, 5}};
	const std::array<Traces, 2> traces{vectors::trace(blocks, array, first, options).value(),
	                                   vectors::trace(blocks, array, second, options).value()};
	const TemporaryFolder folder;
	ASSERT_TRUE(write::writeTraces(blocks, traces, folder / "rake.vtp"));

	vtkNew<vtkXMLPolyDataReader> reader;
	reader->SetFileName((folder / "rake.vtp").c_str());
	reader->Update();
	vtkPolyData* data = reader->GetOutput();
	ASSERT_EQ(data->GetNumberOfVerts(), 1);
	ASSERT_EQ(data->GetNumberOfLines(), 2);
	const std::size_t in_first = traces[0].points.size();
	ASSERT_EQ(data->GetNumberOfPoints(), static_cast<vtkIdType>(in_first + traces[1].points.size()));
	vtkNew<vtkIdList> line;
	data->GetLines()->GetCellAtId(1, line);
	ASSERT_EQ(line->GetNumberOfIds(), static_cast<vtkIdType>(traces[1].points.size()));
	EXPECT_EQ(line->GetId(0), static_cast<vtkIdType>(in_first));

	vtkPointData* at_points = data->GetPointData();
	for (std::size_t i = 0; i < traces[0].size(0); ++i)
	{
		const auto p = static_cast<vtkIdType>(i);
		Vec3 place;
		Vec3 vector;
		Vec3 interpolated;
		data->GetPoint(p, &place.x);
		at_points->GetArray("vprobe:vector")->GetTuple(p, &vector.x);
		at_points->GetArray("v")->GetTuple(p, &interpolated.x);
		EXPECT_EQ(place, traces[0].points[i]);
		EXPECT_EQ(vector, traces[0].vectors[i]);
		EXPECT_LT(glm::length(interpolated - vector), 1e-5);
		EXPECT_EQ(at_points->GetArray("vprobe:time")->GetTuple1(p), traces[0].times[i]);
		EXPECT_EQ(at_points->GetArray("vprobe:cell")->GetTuple1(p), traces[0].cells[i]);
		EXPECT_EQ(at_points->GetArray("vprobe:block")->GetTuple1(p), 0.0);
		EXPECT_TRUE(std::isfinite(at_points->GetArray("s")->GetTuple1(p)));
	}
	EXPECT_TRUE(std::isnan(at_points->GetArray("s")->GetTuple1(static_cast<vtkIdType>(in_first - 1))));
	EXPECT_EQ(at_points->GetArray("vprobe:cell")->GetTuple1(static_cast<vtkIdType>(in_first - 1)), -1.0);

	vtkCellData* of_lines = data->GetCellData();
	constexpr std::array<std::array<double, 2>, 3> kSheetAndSeed{{{0, 4}, {0, 3}, {1, 5}}};
	const auto* words = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("vprobe:ends"));
	ASSERT_NE(words, nullptr);
	for (vtkIdType l = 0; l < 3; ++l)
	{
		EXPECT_EQ(of_lines->GetArray("vprobe:sheet")->GetTuple1(l), kSheetAndSeed[l][0]);
		EXPECT_EQ(of_lines->GetArray("vprobe:seed")->GetTuple1(l), kSheetAndSeed[l][1]);
		const auto end = static_cast<vtkIdType>(of_lines->GetArray("vprobe:end")->GetTuple1(l));
		EXPECT_EQ(const_cast<vtkStringArray*>(words)->GetValue(end), "left_grid");
		EXPECT_EQ(of_lines->GetArray("vprobe:begin")->GetTuple1(l), end);
	}
}

TEST(ParticleFile, HoldsNoTraces)
{
	const grid::BlockSet blocks = std::move(*grid::makeDemo("shell", 4));
	const TemporaryFolder folder;
	ASSERT_TRUE(write::writeTraces(blocks, {}, folder / "none.vtp"));
	vtkNew<vtkXMLPolyDataReader> reader;
	reader->SetFileName((folder / "none.vtp").c_str());
	reader->Update();
	EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
	EXPECT_NE(reader->GetOutput()->GetPointData()->GetArray("vprobe:time"), nullptr);
}

TEST(ParticleFile, SaysWhereItCannotBeWritten)
{
	const Status written = write::writeTraces(grid::BlockSet(), {}, "/dev/null/rake.vtp");
	ASSERT_FALSE(written);
	EXPECT_EQ(written.error().kind, ErrorKind::output);
	EXPECT_NE(written.error().message.find("/dev/null/rake.vtp"), std::string::npos);
}

} // namespace vp::test
