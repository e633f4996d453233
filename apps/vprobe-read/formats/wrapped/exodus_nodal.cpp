#include "exodus_nodal.h"

#include "vprobe-read/base/refusal.h"
#include "vprobe-read/hdf5/netcdf_file.h"

#include <vtkDoubleArray.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vp::reader::wrapped
{

namespace
{

// Returns a row of names, without the zeros behind each.
std::vector<std::string> exodusNames(const hdf5::NetcdfFile& file, const char* name)
{
	const int variable = file.variable(name);
	nc_type type = NC_NAT;
	if (variable < 0 || nc_inq_vartype(file.id(), variable, &type) != NC_NOERR || type != NC_CHAR)
		return {};
	const auto sides = file.dimensions(variable);
	if (sides.size() != 2 || sides[0].second > 1 << 16 || sides[1].second > 1 << 12)
		return {};
	std::string text(sides[0].second * sides[1].second, '\0');
	hdf5::NetcdfFile::check(nc_get_var_text(file.id(), variable, text.data()));
	std::vector<std::string> names;
	for (std::size_t row = 0; row < sides[0].second; ++row)
	{
		std::string words = text.substr(row * sides[1].second, sides[1].second);
		words.resize(std::min(words.find('\0'), words.size()));
		words.resize(words.find_last_not_of(' ') + 1);
		names.push_back(std::move(words));
	}
	return names;
}

// Whether all nodes of a block's elements are nodes of the file.
void checkExodusElements(const hdf5::NetcdfFile& file, int variable, std::size_t block)
{
	constexpr std::size_t kAtOnce = 1 << 20;
	const auto nodes = static_cast<long long>(file.length("num_nodes"));
	std::vector<std::size_t> starts, counts;
	for (const auto& [name, length] : file.dimensions(variable))
	{
		starts.push_back(0);
		counts.push_back(length);
	}
	const std::size_t rows = counts.empty() ? 0 : counts[0];
	const std::size_t width = counts.size() > 1 ? counts[1] : 1;
	if (counts.empty() || counts.size() > 2 || width > kAtOnce)
		throw damaged(fmt::format("the elements of its block {} are no list", block));
	std::vector<long long> corners;
	for (std::size_t row = 0; row < rows; row += counts[0])
	{
		starts[0] = row;
		counts[0] = std::min(rows - row, std::max<std::size_t>(kAtOnce / std::max<std::size_t>(width, 1), 1));
		corners.resize(counts[0] * width);
		hdf5::NetcdfFile::check(
		    nc_get_vara_longlong(file.id(), variable, starts.data(), counts.data(), corners.data()));
		for (const long long corner : corners)
			if (corner < 1 || corner > nodes)
				throw damaged(fmt::format("an element of its block {} has the node {} of {}", block, corner, nodes));
	}
}

// VTK's reader crashes where a block lacks what tells of its elements.
void checkExodusBlocks(const hdf5::NetcdfFile& file)
{
	const std::size_t blocks = file.length("num_el_blk");
	const int status = file.variable("eb_status");
	const std::vector<double> exist = status < 0 ? std::vector<double>() : file.values(status);
	for (std::size_t block = 1; block <= blocks; ++block)
	{
		if (block <= exist.size() && exist[block - 1] == 0.0)
			continue;
		const int corners = file.variable(fmt::format("connect{}", block).c_str());
		const int faces = file.variable(fmt::format("facconn{}", block).c_str()); // the faces of polyhedra
		const int described = corners < 0 ? faces : corners;
		const bool has_sides = file.length(fmt::format("num_el_in_blk{}", block).c_str()) > 0 &&
		                       (faces >= 0 || file.length(fmt::format("num_nod_per_el{}", block).c_str()) > 0);
		if (described < 0 || !has_sides || file.text(described, "elem_type").empty())
			throw damaged(fmt::format("it does not say what the elements of its block {} are", block));
		if (corners >= 0)
			checkExodusElements(file, corners, block);
	}
}

} // namespace

void refuseMissingExodus(const std::string& path)
{
	const hdf5::NetcdfFile file(path);
	// The library makes room for names of this length.
	constexpr double kMaxNameLength = 1 << 16;
	const std::vector<double> name_length = file.numbers(NC_GLOBAL, "maximum_name_length");
	if (!name_length.empty() && !(name_length[0] >= 0.0 && name_length[0] <= kMaxNameLength))
		throw damaged(fmt::format("it announces names of {} characters", name_length[0]));
	// Where names are missing, VTK takes what happens to be in memory for them.
	for (const char* kind : {"glo", "nod", "edge", "face", "elem", "nset", "eset", "fset", "sset", "elset"})
		if (file.length(fmt::format("num_{}_var", kind).c_str()) > 0 &&
		    file.variable(fmt::format("name_{}_var", kind).c_str()) < 0)
			throw damaged(fmt::format("it has num_{0}_var variables, but no name_{0}_var with their names", kind));
	checkExodusBlocks(file);
	const std::size_t blocks = file.length("num_el_blk"), variables = file.length("num_elem_var");
	const int table = file.variable("elem_var_tab");
	if (table < 0 || blocks == 0 || variables == 0)
		return; // without a table, the variables that are there are found
	const std::vector<double> exists = file.values(table);
	if (exists.size() != blocks * variables)
		throw damaged("its table of variables does not match them");
	for (std::size_t block = 0; block < blocks; ++block)
		for (std::size_t i = 0; i < variables; ++i)
			if (const std::string name = fmt::format("vals_elem_var{}eb{}", i + 1, block + 1);
			    exists[block * variables + i] != 0.0 && file.variable(name.c_str()) < 0)
				throw damaged(fmt::format("it has no {}, which its table names", name));
}

bool hasOddExodusNodes(const std::string& path)
{
	const hdf5::NetcdfFile file(path);
	const std::vector<double> large = file.numbers(NC_GLOBAL, "file_size");
	const bool is_large = !large.empty() && large[0] != 0.0;
	if (is_large || file.length("num_nod_var") == 0 || file.variable("vals_nod_var") >= 0)
		return false;
	if (file.variable("vals_nod_var1") < 0)
		throw damaged("it has no values of its variables of nodes");
	return true;
}

std::vector<vtkSmartPointer<vtkDoubleArray>> oddExodusNodes(const std::string& path, std::size_t step)
{
	const hdf5::NetcdfFile file(path);
	const std::size_t nodes = file.length("num_nodes");
	const std::vector<std::string> names = exodusNames(file, "name_nod_var");
	std::vector<vtkSmartPointer<vtkDoubleArray>> arrays;
	for (std::size_t i = 0; i < names.size(); ++i)
	{
		const std::string name = fmt::format("vals_nod_var{}", i + 1);
		const int variable = file.variable(name.c_str());
		const auto sides = variable < 0 ? decltype(file.dimensions(0))() : file.dimensions(variable);
		if (sides.size() < 2 || sides.size() > 3 || sides[0].second <= step || sides[1].second != nodes ||
		    (sides.size() == 3 && sides[2].second > 64))
			throw damaged(fmt::format("{} has no value for each node", name));
		const std::vector<double> values = file.values(variable, step);
		const auto array = vtkSmartPointer<vtkDoubleArray>::New();
		array->SetName(names[i].empty() ? name.c_str() : names[i].c_str());
		array->SetNumberOfComponents(sides.size() == 3 ? static_cast<int>(sides[2].second) : 1);
		array->SetNumberOfTuples(static_cast<vtkIdType>(nodes));
		if (values.size() != static_cast<std::size_t>(array->GetNumberOfValues()) || values.empty())
			throw damaged(fmt::format("{} has no value for each node", name));
		std::copy(values.begin(), values.end(), array->GetPointer(0));
		arrays.push_back(array);
	}
	return arrays;
}

std::vector<std::string> repeatedExodusNames(const std::string& path)
{
	const hdf5::NetcdfFile file(path);
	std::vector<std::string> repeated;
	for (const char* list : {"name_nod_var", "name_elem_var"})
	{
		std::vector<std::string> names = exodusNames(file, list);
		std::ranges::sort(names);
		for (std::size_t i = 1; i < names.size(); ++i)
			if (names[i] == names[i - 1])
				repeated.push_back(names[i]);
	}
	return repeated;
}

std::vector<double> exodusTimes(const std::string& path)
{
	const hdf5::NetcdfFile file(path);
	const int variable = file.variable("time_whole");
	return variable < 0 ? std::vector<double>() : file.values(variable);
}

} // namespace vp::reader::wrapped
