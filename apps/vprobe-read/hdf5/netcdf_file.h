#pragma once

#include "vprobe-read/arrays/stored_place.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>
#include <vtk_netcdf.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vp::reader::hdf5
{

// Reads a netCDF file with the library. Throws a Refusal if a call fails.
class NetcdfFile
{
public:
	explicit NetcdfFile(const std::string& file) : name_(file) { check(nc_open(file.c_str(), NC_NOWRITE, &id_)); }
	virtual ~NetcdfFile() { nc_close(id_); }
	NetcdfFile(const NetcdfFile&) = delete;
	NetcdfFile& operator=(const NetcdfFile&) = delete;

	static void check(int status)
	{
		if (status != NC_NOERR)
			throw damaged(fmt::format("netCDF says: {}", nc_strerror(status)));
	}
	int id() const { return id_; }
	// Reads the stored values of a part, in the variable's type. `to` must have room.
	virtual void readSlab(int variable, const std::vector<std::size_t>& starts, const std::vector<std::size_t>& counts,
	                      void* to) const
	{
		check(nc_get_vara(id_, variable, starts.data(), counts.data(), to));
	}
	// Returns where the values of a lattice lie that are the last three dimensions of a variable, at these indices of
	// the others. Returns nothing if they cannot stay there.
	virtual std::optional<arrays::StoredPlace> storedPlace(int, const std::vector<std::size_t>&) const
	{
		return std::nullopt;
	}
	// Returns the place of values that its reader finds by these words (volumes::CfParts), without the sides of a part.
	virtual arrays::StoredPlace placeOfParts(const std::string& words) const
	{
		return {.file = name_, .reader = "netcdf " + words};
	}
	// Returns the sides of the chunks of a variable, none if it is in one piece.
	virtual std::vector<std::size_t> chunkOf(int variable) const
	{
		int kind = NC_CONTIGUOUS;
		std::array<std::size_t, NC_MAX_VAR_DIMS> sides;
		check(nc_inq_var_chunking(id_, variable, &kind, sides.data()));
		if (kind != NC_CHUNKED)
			return {};
		return {sides.begin(), sides.begin() + static_cast<std::ptrdiff_t>(dimensions(variable).size())};
	}
	// Returns true if values that nobody wrote have the type's own fill value.
	virtual bool marksUnwritten() const { return true; }
	// Returns the length of a dimension, or 0 if there is none.
	std::size_t length(const char* dimension) const
	{
		int found = -1;
		std::size_t length = 0;
		if (nc_inq_dimid(id_, dimension, &found) == NC_NOERR)
			check(nc_inq_dimlen(id_, found, &length));
		return length;
	}
	struct Variable
	{
		int id;
		std::string name;
		nc_type type;
	};
	std::vector<Variable> variables() const
	{
		int count = 0;
		check(nc_inq_nvars(id_, &count));
		std::vector<Variable> all;
		for (int variable = 0; variable < count; ++variable)
		{
			std::array<char, NC_MAX_NAME + 1> name = {};
			nc_type type = NC_NAT;
			check(nc_inq_var(id_, variable, name.data(), &type, nullptr, nullptr, nullptr));
			all.push_back({variable, name.data(), type});
		}
		return all;
	}
	// Returns the number of a variable, or -1 if there is none.
	int variable(const char* name) const
	{
		int variable = -1;
		return nc_inq_varid(id_, name, &variable) == NC_NOERR ? variable : -1;
	}
	// Returns the numbers of an attribute, or none if it is a text or does not exist.
	std::vector<double> numbers(int variable, const char* attribute) const
	{
		const auto [type, count] = attributeOf(variable, attribute);
		if (type == NC_NAT || type == NC_CHAR || type >= NC_STRING || count > kMaxNumbers)
			return {};
		std::vector<double> values(count);
		check(nc_get_att_double(id_, variable, attribute, values.data()));
		return values;
	}
	// Returns the type and the length of an attribute. The type is NC_NAT if there is none.
	std::pair<nc_type, std::size_t> attributeOf(int variable, const char* attribute) const
	{
		std::pair<nc_type, std::size_t> found(NC_NAT, 0);
		if ((variable < 0 && variable != NC_GLOBAL) ||
		    nc_inq_att(id_, variable, attribute, &found.first, &found.second) != NC_NOERR)
			return {NC_NAT, 0};
		return found;
	}
	// Returns an attribute that is a text of the classic kind, or the first string of a list.
	std::string text(int variable, const char* attribute) const
	{
		const auto [type, count] = attributeOf(variable, attribute);
		if (type == NC_STRING && count > 0 && count <= kMaxNumbers)
		{
			std::vector<char*> all(count, nullptr);
			check(nc_get_att_string(id_, variable, attribute, all.data()));
			const std::string words = all[0] ? std::string(all[0]) : std::string();
			nc_free_string(count, all.data());
			return words;
		}
		if (type != NC_CHAR || count > kMaxLetters)
			return {};
		std::string words(count, '\0');
		check(nc_get_att_text(id_, variable, attribute, words.data()));
		words.resize(std::min(words.find('\0'), words.size()));
		return words;
	}
	std::vector<std::pair<std::string, std::size_t>> dimensions(int variable) const
	{
		int count = 0;
		std::array<int, NC_MAX_VAR_DIMS> ids;
		check(nc_inq_varndims(id_, variable, &count));
		check(nc_inq_vardimid(id_, variable, ids.data()));
		std::vector<std::pair<std::string, std::size_t>> all;
		for (int d = 0; d < count; ++d)
		{
			std::array<char, NC_MAX_NAME + 1> name = {};
			std::size_t length = 0;
			check(nc_inq_dim(id_, ids[static_cast<std::size_t>(d)], name.data(), &length));
			all.emplace_back(name.data(), length);
		}
		return all;
	}
	// Returns all values of a variable, or those at one index of its first dimension.
	std::vector<double> values(int variable, std::optional<std::size_t> at = std::nullopt) const
	{
		const auto sides = dimensions(variable);
		std::vector<std::size_t> starts, counts;
		for (const auto& [name, length] : sides)
		{
			starts.push_back(starts.empty() && at ? *at : 0);
			counts.push_back(counts.empty() && at ? 1 : length);
		}
		std::size_t count = 1;
		for (const std::size_t length : counts)
			if (__builtin_mul_overflow(count, length, &count) || count > std::size_t(1) << 36)
				throw damaged("it has more values than there can be");
		std::vector<double> all(count);
		check(nc_get_vara_double(id_, variable, starts.data(), counts.data(), all.data()));
		return all;
	}

protected:
	explicit NetcdfFile(int id) : id_(id) {}
	int release() { return std::exchange(id_, -1); } // which the caller closes

private:
	static constexpr std::size_t kMaxNumbers = 4096; // in one attribute
	static constexpr std::size_t kMaxLetters = 1 << 16;

	std::string name_;
	int id_ = -1;
};

} // namespace vp::reader::hdf5
