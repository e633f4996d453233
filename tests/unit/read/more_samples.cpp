#include "more_samples.h"

#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNIFTIImageWriter.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>

#include <zlib.h>

namespace
{

const SampleFile& pieceOf(const std::vector<SampleFile>& pieces, const std::string& name)
{
	return *std::find_if(pieces.begin(), pieces.end(), [&](const SampleFile& piece) { return piece.name == name; });
}

std::string besideIt(const std::string& path, const std::string& name)
{
	return (std::filesystem::path(path).parent_path() / name).string();
}

constexpr vp::Vec3 kOrigin = {2.0, -2.0, -1.5};
constexpr vp::Vec3 kSpacing = {0.5, 0.25, 2.0};

vp::Vec3 placeOf(int i, int j, int k)
{
	return kOrigin + kSpacing * vp::Vec3(i, j, k);
}

std::vector<double> latticeValues(vp::Vec3 (*place)(int, int, int))
{
	std::vector<double> values;
	for (int k = 0; k < kSamplePoints[2]; ++k)
		for (int j = 0; j < kSamplePoints[1]; ++j)
			for (int i = 0; i < kSamplePoints[0]; ++i)
				values.push_back(sampleValue(place(i, j, k)));
	return values;
}

std::string bytesOf(const std::vector<double>& values)
{
	return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double)};
}

constexpr const char* kNrrdHead = "NRRD0004\n# a comment\ntype: double\ndimension: 3\nsizes: 5 4 6\ncontent: f\n"
                                  "spacings: 0.5 0.25 2\naxis mins: 2 -2 -1.5\nendian: little\n";

void writeNrrd(const std::string& path, const std::string& encoding)
{
	const std::vector<double> values = latticeValues(placeOf);
	std::string data = bytesOf(values);
	if (encoding == "ascii")
	{
		data.clear();
		for (const double value : values)
			data += std::to_string(value) + "\n";
	}
	else if (encoding == "gzip")
	{
		gzFile out = gzopen((path + ".part").c_str(), "wb");
		gzwrite(out, data.data(), static_cast<unsigned>(data.size()));
		gzclose(out);
		data = contentsOf(path + ".part");
	}
	writeContents(path, kNrrdHead + ("encoding: " + encoding) + "\n\n" + data);
}

// A file a slice, as scanners leave them.
void writeSlices(const std::string& path)
{
	const std::string data = bytesOf(latticeValues(placeOf));
	const std::size_t slice = data.size() / 6;
	for (int k = 0; k < 6; ++k)
		writeContents(besideIt(path, "slice." + std::to_string(k + 1)), data.substr(slice * k, slice));
	writeContents(path, kNrrdHead + std::string("encoding: raw\ndata file: slice.%d 1 6 1\n"));
}

// i runs along -y, j along z, k along x.
vp::Vec3 turned(int i, int j, int k)
{
	return kOrigin + vp::Vec3(2.0 * k, -0.5 * i, 0.25 * j);
}

void writeTurnedNrrd(const std::string& path)
{
	writeContents(besideIt(path, "turned.raw"), bytesOf(latticeValues(turned)));
	writeContents(path, "NRRD0005\ntype: double\ndimension: 3\nspace dimension: 3\nsizes: 5 4 6\ncontent: f\n"
	                    "space directions: (0,-0.5,0) (0,0,0.25) (2,0,0)\nspace origin: (2,-2,-1.5)\nendian: little\n"
	                    "encoding: raw\ndata file: turned.raw\n");
}

void writeNifti(const std::string& path)
{
	vtkNew<vtkImageData> image;
	image->SetDimensions(kSamplePoints.data());
	image->SetSpacing(0.5, 0.25, 2.0);
	vtkNew<vtkDoubleArray> f;
	for (const double value : latticeValues(turned))
		f->InsertNextValue(value);
	image->GetPointData()->SetScalars(f);
	const std::array<double, 16> place = {0, 0, 1, kOrigin.x, -1, 0, 0, kOrigin.y, 0, 1, 0, kOrigin.z, 0, 0, 0, 1};
	vtkNew<vtkMatrix4x4> matrix;
	matrix->DeepCopy(place.data());
	vtkNew<vtkNIFTIImageWriter> writer;
	writer->SetSFormMatrix(matrix);
	writer->SetFileName(path.c_str());
	writer->SetInputData(image);
	writer->Write();
}

// EnSight Gold in text: hexahedra, f at nodes, g at elements.
void writeGold(const std::string& path)
{
	writeContents(path, "FORMAT\ntype: ensight gold\n\nGEOMETRY\nmodel: gold.geo\n\nVARIABLE\n"
	                    "scalar per node: f gold.f\nscalar per element: g gold.g\n");
	std::string geometry = "one\ntwo\nnode id off\nelement id off\npart\n1\nbox\ncoordinates\n120\n";
	std::string f = "f\npart\n1\ncoordinates\n";
	for (int axis = 0; axis < 3; ++axis)
		for (int k = 0; k < kSamplePoints[2]; ++k)
			for (int j = 0; j < kSamplePoints[1]; ++j)
				for (int i = 0; i < kSamplePoints[0]; ++i)
					geometry += std::to_string(placeOf(i, j, k)[axis]) + "\n";
	for (const double value : latticeValues(placeOf))
		f += std::to_string(value) + "\n";
	geometry += "hexa8\n60\n";
	std::string g = "g\npart\n1\nhexa8\n";
	for (int k = 0; k + 1 < kSamplePoints[2]; ++k)
		for (int j = 0; j + 1 < kSamplePoints[1]; ++j)
			for (int i = 0; i + 1 < kSamplePoints[0]; ++i)
			{
				for (const int corner : {0, 1, 6, 5, 20, 21, 26, 25})
					geometry += std::to_string(1 + i + 5 * j + 20 * k + corner) + " ";
				geometry += "\n";
				g += std::to_string(sampleValue(placeOf(i, j, k) + 0.5 * kSpacing)) + "\n";
			}
	writeContents(besideIt(path, "gold.geo"), geometry);
	writeContents(besideIt(path, "gold.f"), f);
	writeContents(besideIt(path, "gold.g"), g);
}

} // namespace

std::vector<SampleFile> moreSamples(const std::vector<SampleFile>& pieces)
{
	const std::size_t points = 5 * 4 * 6;
	const std::size_t cells = 4 * 3 * 5;
	const auto lattice = pieceOf(pieces, "binary.vts").write;
	const auto mesh = pieceOf(pieces, "binary.vtu");
	std::vector<SampleFile> files;
	files.push_back({"blocks.vtm",
	                 [lattice, mesh](const std::string& p)
	                 {
		                 lattice(besideIt(p, "a.vts"));
		                 mesh.write(besideIt(p, "b.vtu"));
		                 writeContents(p, R"(<?xml version="1.0"?>
<VTKFile type="vtkMultiBlockDataSet" version="1.0" byte_order="LittleEndian">
<vtkMultiBlockDataSet>
<Block index="0" name="left"><DataSet index="0" name="lattice" file="a.vts"/><DataSet index="1"/></Block>
<DataSet index="1" name="mesh" file="b.vtu"/>
</vtkMultiBlockDataSet>
</VTKFile>
)");
	                 },
	                 "hybrid", cells + mesh.cells, points + mesh.points, true, "a.vts"});
	files.push_back({"run.pvd",
	                 [lattice, mesh](const std::string& p)
	                 {
		                 lattice(besideIt(p, "a.vts"));
		                 mesh.write(besideIt(p, "b.vtu"));
		                 writeContents(p, R"(<?xml version="1.0"?>
<VTKFile type="Collection" version="0.1" byte_order="LittleEndian">
<Collection>
<DataSet timestep="0.5" part="0" file="a.vts"/>
<DataSet timestep="2" part="0" file="b.vtu"/>
</Collection>
</VTKFile>
)");
	                 },
	                 "unstructured", mesh.cells, mesh.points, true, "b.vtu"});
	files.push_back({"run.vts.series",
	                 [lattice](const std::string& p)
	                 {
		                 lattice(besideIt(p, "a.vts"));
		                 writeContents(p, R"({"file-series-version": "1.0",
 "files": [{"name": "absent.vts", "time": 0}, {"name": "a.vts", "time": 3.5}]})");
	                 },
	                 "curvilinear", cells, points, true, ""});
	for (const char* encoding : {"raw", "ascii", "gzip"})
		files.push_back({encoding + std::string(".nrrd"), [encoding](const std::string& p) { writeNrrd(p, encoding); },
		                 "image", cells, points, false, ""});
	files.push_back({"slices.nhdr", writeSlices, "image", cells, points, false, "slice.4"});
	files.push_back({"turned.nhdr", writeTurnedNrrd, "curvilinear", cells, points, false, "turned.raw"});
	files.push_back({"turned.nii", writeNifti, "curvilinear", cells, points, false, ""});
	files.push_back({"zipped.nii.gz", writeNifti, "curvilinear", cells, points, false, ""});
	for (const char* cut : {"gold.geo", "gold.f", "gold.g"})
		files.push_back({std::string("ascii_") + cut + ".case", writeGold, "unstructured", cells, points, true, cut});
	return files;
}
