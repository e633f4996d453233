#include "zarr_file.h"

#include "vprobe-read/base/bytes.h"
#include "vprobe-read/base/is_one_of.h"
#include "vprobe-read/base/refusal.h"

#include <vtkBase64Utilities.h>

#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace vp::reader::volumes
{

using nlohmann::json;

namespace
{

namespace fs = std::filesystem;

int newFileInMemory()
{
	int id = -1;
	hdf5::NetcdfFile::check(nc_create("zarr", NC_NETCDF4 | NC_DISKLESS, &id));
	return id;
}

nc_type netcdfTypeOf(const ZarrType& type)
{
	const bool is_signed = type.kind == 'i';
	if (type.kind == 0)
		return NC_STRING; // which is left out
	if (type.kind == 'f')
		return type.width == 8 ? NC_DOUBLE : NC_FLOAT;
	switch (type.width)
	{
	case 1:
		return is_signed ? NC_BYTE : NC_UBYTE;
	case 2:
		return is_signed ? NC_SHORT : NC_USHORT;
	case 4:
		return is_signed ? NC_INT : NC_UINT;
	default:
		return is_signed ? NC_INT64 : NC_UINT64;
	}
}

bool isListOfNumbers(const json& value)
{
	return value.is_array() && !value.empty() &&
	       std::all_of(value.begin(), value.end(), [](const json& one) { return one.is_number(); });
}

void putNumbers(int id, int variable, const std::string& name, const json& numbers)
{
	const auto are = [&](auto&& test) { return std::all_of(numbers.begin(), numbers.end(), test); };
	if (are([](const json& one) { return one.is_number_unsigned(); }))
	{
		const auto all = numbers.get<std::vector<unsigned long long>>();
		hdf5::NetcdfFile::check(nc_put_att_ulonglong(id, variable, name.c_str(), NC_UINT64, all.size(), all.data()));
	}
	else if (are([](const json& one) { return one.is_number_integer(); }))
	{
		const auto all = numbers.get<std::vector<long long>>();
		hdf5::NetcdfFile::check(nc_put_att_longlong(id, variable, name.c_str(), NC_INT64, all.size(), all.data()));
	}
	else
	{
		const auto all = numbers.get<std::vector<double>>();
		hdf5::NetcdfFile::check(nc_put_att_double(id, variable, name.c_str(), NC_DOUBLE, all.size(), all.data()));
	}
}

// Names that netCDF keeps for itself. Its own files of Zarr have some of them.
bool isReserved(const std::string& name)
{
	return name.starts_with("_NC") || name.starts_with("_nc") || name.starts_with("_Netcdf4") ||
	       isOneOf(name, {"_Format", "_IsNetcdf4", "_SuperblockVersion", "_Codecs", "CLASS", "NAME", "DIMENSION_LIST",
	                      "REFERENCE_LIST"});
}

// Numbers, texts and lists of numbers. Nothing that is read has others.
void putAttribute(int id, int variable, const std::string& name, const json& value)
{
	if (isReserved(name))
		return;
	if (value.is_number())
		putNumbers(id, variable, name, json::array({value}));
	else if (isListOfNumbers(value))
		putNumbers(id, variable, name, value);
	else if (value.is_string() || value.is_boolean())
	{
		const std::string text = value.is_string() ? value.get<std::string>() : value.get<bool>() ? "true" : "false";
		hdf5::NetcdfFile::check(nc_put_att_text(id, variable, name.c_str(), text.size(), text.c_str()));
	}
}

// The names of an array's sides, as xarray writes them, or netCDF in its own kind of Zarr. Nothing where it has none.
std::vector<std::string> namesOfSides(const json& about, const json& attributes, std::size_t sides)
{
	json given = about.value("dimension_names", attributes.value("_ARRAY_DIMENSIONS", json()));
	for (const json* place : {&about, &attributes})
		for (const char* key : {"_NCZARR_ARRAY", "_nczarr_array"})
			if (const json own = place->value(key, json()); given.is_null() && own.is_object())
				given = own.value("dimrefs", json());
	std::vector<std::string> names;
	if (given.is_array())
		for (const json& one : given)
			if (one.is_string())
			{
				const std::string path = one.get<std::string>(); // "/z" where netCDF wrote it
				names.push_back(path.substr(path.rfind('/') + 1));
			}
	return names.size() == sides ? names : std::vector<std::string>();
}

// xarray writes reals in JSON of version 3 as the 8 bytes of a double, in base64.
std::optional<double> realInBase64(const std::string& text)
{
	std::array<unsigned char, 9> bytes{};
	if (text.size() != 12 ||
	    vtkBase64Utilities::DecodeSafely(reinterpret_cast<const unsigned char*>(text.data()), text.size(), bytes.data(),
	                                     bytes.size()) != sizeof(double))
		return std::nullopt;
	return numberAt<double>(bytes.data());
}

// One list of all values that are missing. Version 2 has no other place for them than the value of chunks that are not
// there; 0 is what most programs fill with, and mostly a value like others.
json missingIn(const json& about, const json& attributes)
{
	const bool is_third = about.value("zarr_format", json(2)) == 3;
	json marks = json::array();
	const auto take = [&](const json& given)
	{
		for (const json& one : given.is_array() ? given : json::array({given}))
			if (one.is_number())
				marks.push_back(one);
			else if (const auto real =
			             is_third && one.is_string() ? realInBase64(one.get<std::string>()) : std::nullopt)
				marks.push_back(*real);
	};
	for (const char* name : {"missing_value", "_FillValue"})
		take(attributes.value(name, json()));
	if (const json fill = about.value("fill_value", json()); fill != 0 && !is_third)
		take(fill);
	return marks;
}

} // namespace

ZarrFile::ZarrFile(const ZarrGroup& group, const std::string& folder)
    : hdf5::NetcdfFile(newFileInMemory()), folder_(folder)
{
	if (group.arrays.empty() && !group.groups.empty())
		throw Refusal(fmt::format("nothing to slice: a Zarr group with groups alone; name one of them, such as {}",
		                          (fs::path(folder) / group.groups[0]).string()));
	for (const auto& [name, array] : group.arrays)
		addArray(name, array);
	has_labels_ = group.attributes.contains("image-label");
	for (const auto& [name, value] : group.attributes.items())
		putAttribute(id(), NC_GLOBAL, name, value);
}

ZarrFile::~ZarrFile()
{
	nc_abort(release());
}

std::vector<int> ZarrFile::dimensionsOf(const ZarrArray& array, const std::vector<std::string>& names)
{
	const std::vector<std::size_t>& sides = array.shape();
	std::vector<int> ids;
	for (std::size_t i = 0; i < sides.size(); ++i)
	{
		// Without names, arrays of one shape lie on one grid.
		const std::string name = names.empty() ? fmt::format("side {} of {}", i, fmt::join(sides, "x")) : names[i];
		int dimension = -1;
		if (nc_inq_dimid(id(), name.c_str(), &dimension) != NC_NOERR)
			check(nc_def_dim(id(), name.c_str(), sides[i], &dimension));
		else if (length(name.c_str()) != sides[i])
			throw Refusal(fmt::format("the dimension {} has {} places in {} and {} in others; put them in groups of "
			                          "their own",
			                          name, sides[i], array.name(), length(name.c_str())));
		ids.push_back(dimension);
	}
	return ids;
}

void ZarrFile::addArray(const std::string& name, const ZarrGroup::Array& given)
{
	ZarrArray array(given.folder, name, given.about);
	const std::vector<int> sides =
	    dimensionsOf(array, namesOfSides(given.about, given.attributes, array.shape().size()));
	int variable = -1;
	check(nc_def_var(id(), name.c_str(), netcdfTypeOf(array.type()), static_cast<int>(sides.size()), sides.data(),
	                 &variable));
	for (const auto& [key, value] : given.attributes.items())
		if (!isOneOf(key, {"_ARRAY_DIMENSIONS", "_FillValue", "missing_value"}))
			putAttribute(id(), variable, key, value);
	if (const json marks = missingIn(given.about, given.attributes); !marks.empty())
		putAttribute(id(), variable, "missing_value", marks);
	arrays_.emplace(variable, std::move(array));
}

std::optional<arrays::StoredPlace> ZarrFile::storedPlace(int variable, const std::vector<std::size_t>& front) const
{
	return arrays_.at(variable).storedPlace(front);
}

arrays::StoredPlace ZarrFile::placeOfParts(const std::string& words) const
{
	arrays::StoredPlace place{.reader = "zarr cf " + words};
	std::error_code none;
	for (const char* about : {"zarr.json", ".zgroup", ".zarray", ".zmetadata", ".zattrs"})
		if (place.file.empty() && fs::is_regular_file(fs::path(folder_) / about, none))
			place.file = (fs::path(folder_) / about).string();
	return place;
}

void ZarrFile::readSlab(int variable, const std::vector<std::size_t>& starts, const std::vector<std::size_t>& counts,
                        void* to) const
{
	arrays_.at(variable).read(starts, counts, static_cast<std::byte*>(to));
}

} // namespace vp::reader::volumes
