#include "cut/cutter.h"
#include "measure/plane_triangles.h"
#include "measure/sheet_line.h"
#include "mesh/mesh_values.h"
#include "read/read.h"

#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProbeFilter.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>

#include <cstdlib>
#include <filesystem>

namespace vp::test
{

// Values in tetrahedra are linear, so VTK's in the middle of a piece of a line are ours, but for its points in single
// precision.
TEST(ProbeLine, RealTetrahedraAsVtkProbesThem)
{
	const char* data = std::getenv("VPROBE_DATA");
	if (!data)
		GTEST_SKIP() << "VPROBE_DATA names no folder of data sets";
	const std::string path = (std::filesystem::path(data) / "unstructured/post_tets/post.vtk").string();
	if (!std::filesystem::exists(path))
		GTEST_SKIP() << path << " is not there";
	const grid::BlockSet blocks = read::readInputs({path}, {}, nullptr).value();
	const Vec3 lo = blocks.bounds().lo;
	const Vec3 size = blocks.bounds().hi - lo;
	const grid::FieldChoice field = grid::chooseField(blocks, "").value().value();
	const auto [low, high] = grid::fieldRange(blocks, field);

	cut::Cutter cutter(blocks);
	cut::CutRequest request;
	request.in_generations = true;
	request.probe.sheets = {probe::makeSheet(lo + 0.47 * size, {0.2, 0.7, 0.4})};
	const probe::Sheet sheet = request.probe.sheets[0];
	const mesh::SheetMesh mesh = cutter.cut(std::move(request)).value().mesh(blocks, 0);
	const double reach = glm::length(size);
	const glm::dvec2 from(-0.7 * reach, -0.31 * reach);
	const glm::dvec2 to(0.7 * reach, 0.42 * reach);

	vtkNew<vtkPoints> places;
	places->SetDataTypeToDouble();
	std::vector<double> ours;
	const std::vector<const grid::Field*> fields = field.inEach(blocks);
	const auto value = [&](std::uint32_t v) { return mesh::vertexValue(blocks, mesh, v, fields, field.component); };
	const auto atSide = [&](const measure::SideCrossing& s) { return value(s.a) + s.part * (value(s.b) - value(s.a)); };
	for (const measure::LinePiece& piece : measure::alongLine(mesh, measure::planePoints(mesh, sheet), from, to))
	{
		const glm::dvec2 uv = from + 0.5 * (piece.enter.t + piece.leave.t) * (to - from);
		const Vec3 at = sheet.origin + uv.x * sheet.xAxis() + uv.y * sheet.up;
		places->InsertNextPoint(at.x, at.y, at.z);
		ours.push_back(0.5 * (atSide(piece.enter) + atSide(piece.leave)));
	}
	ASSERT_GT(ours.size(), 10u);

	vtkNew<vtkUnstructuredGridReader> reader;
	reader->SetFileName(path.c_str());
	reader->Update();
	vtkNew<vtkPolyData> line;
	line->SetPoints(places);
	vtkNew<vtkProbeFilter> probe;
	probe->SetInputData(line);
	probe->SetSourceData(reader->GetOutput());
	probe->Update();
	vtkDataArray* values = probe->GetOutput()->GetPointData()->GetArray(field.name.c_str());
	ASSERT_TRUE(values);
	int found = 0;
	for (std::size_t i = 0; i < ours.size(); ++i)
	{
		const auto id = static_cast<vtkIdType>(i);
		if (probe->GetOutput()->GetPointData()->GetArray("vtkValidPointMask")->GetTuple1(id) == 0.0)
			continue; // in a sliver, which VTK's search passes over
		++found;
		EXPECT_NEAR(values->GetTuple1(id), ours[i], 2e-5 * (high - low)) << i;
	}
	EXPECT_GT(found, static_cast<int>(0.9 * ours.size()));
}

} // namespace vp::test
