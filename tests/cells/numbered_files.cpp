#include "numbered_cells.h"

#include <fmt/format.h>

#include <fstream>

using vp::Vec3;

namespace
{

void writeXmlPiece(std::ofstream& out, const CubeMesh& mesh, const std::string& version, std::size_t first,
                   std::size_t last)
{
	// VTK's reader knows no other name in old files.
	const char* degrees = version < "2.1" ? "HigherOrderDegrees" : "degrees";
	const auto array = [&](const char* type, const char* name, int components, auto write)
	{
		out << fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n", type,
		                   name, components);
		write();
		out << "</DataArray>\n";
	};
	const bool has_degrees = mesh.degrees[0] > 0;
	out << fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", mesh.points.size(), last - first);
	out << (mesh.weights.empty() ? "<PointData>\n" : "<PointData RationalWeights=\"w\">\n");
	array("Float64", "f", 1,
	      [&]
	      {
		      for (const double value : mesh.values)
			      out << fmt::format("{}\n", value);
	      });
	if (!mesh.weights.empty())
		array("Float64", "w", 1,
		      [&]
		      {
			      for (const double weight : mesh.weights)
				      out << fmt::format("{}\n", weight);
		      });
	out << "</PointData>\n"
	    << (has_degrees ? fmt::format("<CellData HigherOrderDegrees=\"{}\">\n", degrees) : "<CellData>\n");
	if (has_degrees)
		array("Float64", degrees, 3,
		      [&]
		      {
			      for (std::size_t c = first; c < last; ++c)
				      out << fmt::format("{} {} {}\n", mesh.degrees[0], mesh.degrees[1], mesh.degrees[2]);
		      });
	out << "</CellData>\n<Points>\n";
	array("Float64", "Points", 3,
	      [&]
	      {
		      for (const Vec3& p : mesh.points)
			      out << fmt::format("{} {} {}\n", p.x, p.y, p.z);
	      });
	out << "</Points>\n<Cells>\n";
	array("Int64", "connectivity", 1,
	      [&]
	      {
		      for (std::size_t c = first; c < last; ++c)
			      out << fmt::format("{}\n", fmt::join(mesh.cells[c], " "));
	      });
	array("Int64", "offsets", 1,
	      [&]
	      {
		      std::size_t offset = 0;
		      for (std::size_t c = first; c < last; ++c)
			      out << fmt::format("{}\n", offset += mesh.cells[c].size());
	      });
	array("UInt8", "types", 1,
	      [&]
	      {
		      for (std::size_t c = first; c < last; ++c)
			      out << fmt::format("{}\n", mesh.type);
	      });
	out << "</Cells>\n</Piece>\n";
}

} // namespace

void writeXml(const CubeMesh& mesh, const std::string& path, const std::string& version, int pieces)
{
	std::ofstream out(path);
	out << fmt::format("<VTKFile type=\"UnstructuredGrid\" version=\"{}\" byte_order=\"LittleEndian\" "
	                   "header_type=\"UInt64\">\n<UnstructuredGrid>\n",
	                   version);
	for (int p = 0; p < pieces; ++p)
		writeXmlPiece(out, mesh, version, mesh.cells.size() * p / pieces, mesh.cells.size() * (p + 1) / pieces);
	out << "</UnstructuredGrid>\n</VTKFile>\n";
}

void writeLegacy(const CubeMesh& mesh, const std::string& path, const std::string& version)
{
	std::ofstream out(path);
	out << fmt::format("# vtk DataFile Version {}\ncells\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS {} double\n",
	                   version, mesh.points.size());
	for (const Vec3& p : mesh.points)
		out << fmt::format("{} {} {}\n", p.x, p.y, p.z);
	std::size_t ids = 0;
	for (const auto& cell : mesh.cells)
		ids += cell.size();
	const std::size_t count = mesh.cells.size();
	if (version < "5")
	{
		out << fmt::format("CELLS {} {}\n", count, ids + count);
		for (const auto& cell : mesh.cells)
			out << fmt::format("{} {}\n", cell.size(), fmt::join(cell, " "));
	}
	else
	{
		out << fmt::format("CELLS {} {}\nOFFSETS vtktypeint64\n0\n", count + 1, ids);
		std::size_t offset = 0;
		for (const auto& cell : mesh.cells)
			out << fmt::format("{}\n", offset += cell.size());
		out << "CONNECTIVITY vtktypeint64\n";
		for (const auto& cell : mesh.cells)
			out << fmt::format("{}\n", fmt::join(cell, " "));
	}
	out << fmt::format("CELL_TYPES {}\n", count);
	for (std::size_t c = 0; c < count; ++c)
		out << fmt::format("{}\n", mesh.type);
	// Legacy files cannot say what an array is for: it has its name alone.
	if (mesh.degrees[0] > 0)
	{
		out << fmt::format("CELL_DATA {0}\nFIELD FieldData 1\nHigherOrderDegrees 3 {0} double\n", count);
		for (std::size_t c = 0; c < count; ++c)
			out << fmt::format("{} {} {}\n", mesh.degrees[0], mesh.degrees[1], mesh.degrees[2]);
	}
	out << fmt::format("POINT_DATA {}\nSCALARS f double\nLOOKUP_TABLE default\n", mesh.points.size());
	for (const double value : mesh.values)
		out << fmt::format("{}\n", value);
	if (!mesh.weights.empty())
	{
		out << fmt::format("FIELD FieldData 1\nRationalWeights 1 {} double\n", mesh.points.size());
		for (const double weight : mesh.weights)
			out << fmt::format("{}\n", weight);
	}
}
