#include "sample_files.h"

#include <functional>

namespace cli
{

namespace
{

constexpr int kPoints = 4;

// Returns the texts of all points, in VTK's order.
std::string forPoints(const std::function<std::string(int x, int y, int z)>& text)
{
	std::string all;
	for (int z = 0; z < kPoints; ++z)
		for (int y = 0; y < kPoints; ++y)
			for (int x = 0; x < kPoints; ++x)
				all += text(x, y, z) + "\n";
	return all;
}

std::string heights()
{
	return forPoints([](int, int, int z) { return std::to_string(z); });
}

} // namespace

std::string legacyImage()
{
	std::string text = "# vtk DataFile Version 3.0\nsample\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 4 4 4\n"
	                   "ORIGIN 0 0 0\nSPACING 1 1 1\nCELL_DATA 27\nSCALARS both float 1\nLOOKUP_TABLE default\n";
	for (int cell = 0; cell < 27; ++cell)
		text += std::to_string(100 + cell) + "\n";
	text += "SCALARS mass float 1\nLOOKUP_TABLE default\n";
	for (int cell = 0; cell < 27; ++cell)
		text += "7\n";
	text += "POINT_DATA 64\nSCALARS height float 1\nLOOKUP_TABLE default\n" + heights();
	text +=
	    "SCALARS both float 1\nLOOKUP_TABLE default\n" + forPoints([](int x, int, int) { return std::to_string(x); });
	text += "VECTORS wind float\n" + forPoints([](int, int, int) { return std::string("1 2 2"); });
	return text;
}

std::string xmlImage()
{
	return "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
	       "<ImageData WholeExtent=\"0 3 0 3 0 3\" Origin=\"0 0 0\" Spacing=\"1 1 1\">\n<Piece Extent=\"0 3 0 3 0 "
	       "3\">\n"
	       "<PointData Scalars=\"height\">\n<DataArray type=\"Float32\" Name=\"height\" format=\"ascii\">\n" +
	       heights() + "</DataArray>\n</PointData>\n<CellData/>\n</Piece>\n</ImageData>\n</VTKFile>\n";
}

std::string xmlHexahedra()
{
	return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
	       "<UnstructuredGrid>\n<Piece NumberOfPoints=\"12\" NumberOfCells=\"2\">\n"
	       "<PointData><DataArray type=\"Float64\" Name=\"height\" format=\"ascii\">0 0 0 0 0 0 1 1 1 1 1 "
	       "1</DataArray></PointData>\n"
	       "<CellData/>\n<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n"
	       "0 0 0 1 0 0 2 0 0 0 1 0 1 1 0 2 1 0 0 0 1 1 0 1 2 0 1 0 1 1 1 1 1 2 1 1\n</DataArray></Points>\n"
	       "<Cells><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n"
	       "0 1 4 3 6 7 10 9 1 2 5 4 7 8 11 10\n</DataArray>\n"
	       "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">8 16</DataArray>\n"
	       "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">12 12</DataArray></Cells>\n"
	       "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

std::string imageWithHiddenCells()
{
	return R"(<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian">
<ImageData WholeExtent="0 3 0 3 0 3" Origin="0 0 0" Spacing="1 1 1"><Piece Extent="0 3 0 3 0 3">
<CellData><DataArray type="UInt8" Name="vtkGhostType" format="ascii">
0 0 0 0 32 0 0 0 0  0 0 0 0 32 0 0 0 0  0 0 0 0 0 0 0 0 0
</DataArray></CellData></Piece></ImageData></VTKFile>)";
}

} // namespace cli
