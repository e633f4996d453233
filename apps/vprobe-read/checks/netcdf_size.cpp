#include "netcdf_size.h"

#include "vprobe-read/base/bytes.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <vector>

namespace vp::reader::checks
{

namespace
{

// The header's grammar is in "The NetCDF Classic Format Specification"; all numbers are big-endian.
class Header
{
public:
	explicit Header(const std::string& file) : in_(file, std::ios::binary)
	{
		char magic[4] = {};
		in_.read(magic, 4);
		version_ = magic[3];
	}

	std::optional<std::uint64_t> size()
	{
		const std::uint64_t records = count();
		if (records == (wide() ? ~std::uint64_t(0) : 0xFFFFFFFFu))
			return std::nullopt;
		std::vector<std::uint64_t> dimensions;
		for (std::uint64_t left = list(); left > 0 && in_; --left)
		{
			names_.insert(name());
			dimensions.push_back(count()); // 0: the record dimension
		}
		attributes(true);

		std::uint64_t end = 0;
		std::vector<Variable> of_records;
		for (std::uint64_t left = list(); left > 0 && in_; --left)
		{
			const Variable variable = readVariable(dimensions);
			if (variable.record)
				of_records.push_back(variable);
			else if (variable.bytes > 0)
				end = std::max(end, variable.begin + variable.bytes);
		}
		if (!in_)
			return std::nullopt;

		std::uint64_t record_bytes = 0; // a single variable's records are not padded
		for (const Variable& variable : of_records)
			record_bytes += of_records.size() == 1 ? variable.bytes : (variable.bytes + 3) / 4 * 4;
		for (const Variable& variable : of_records)
			if (records > 0 && variable.bytes > 0)
				end = std::max(end, variable.begin + (records - 1) * record_bytes + variable.bytes);
		return end;
	}

	const std::set<std::string>& names() const { return names_; }

private:
	static constexpr std::uint64_t kMaxNameLength = 256;

	struct Variable
	{
		std::uint64_t begin = 0;
		std::uint64_t bytes = 0; // the size of one record, for a variable with records
		bool record = false;
	};

	bool wide() const { return version_ == 5; }
	std::uint64_t number(int bytes)
	{
		std::array<char, 8> number;
		number.fill('\xFF'); // as it stays past the end
		in_.read(number.data(), bytes);
		return integerAt(number.data(), static_cast<std::size_t>(bytes), ByteOrder::big);
	}
	std::uint64_t count() { return number(wide() ? 8 : 4); }
	void skip(std::uint64_t bytes)
	{
		in_.ignore(static_cast<std::streamsize>(std::min<std::uint64_t>(bytes, 1u << 30)));
	}
	std::string name()
	{
		const std::uint64_t length = count();
		std::string text(std::min(length, kMaxNameLength), '\0');
		in_.read(text.data(), static_cast<std::streamsize>(text.size()));
		skip((length + 3) / 4 * 4 - text.size());
		return text;
	}
	std::uint64_t list() // a tag, and how many entries follow
	{
		number(4);
		return count();
	}
	static std::uint64_t typeSize(std::uint64_t type)
	{
		constexpr std::uint64_t sizes[] = {0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8}; // byte char short int float double ...
		return type < std::size(sizes) ? sizes[type] : 0;
	}
	void attributes(bool global)
	{
		for (std::uint64_t left = list(); left > 0 && in_; --left)
		{
			if (std::string text = name(); global)
				names_.insert(std::move(text));
			const std::uint64_t type = number(4);
			skip((count() * typeSize(type) + 3) / 4 * 4);
		}
	}
	Variable readVariable(const std::vector<std::uint64_t>& dimensions)
	{
		Variable variable;
		names_.insert(name());
		std::uint64_t values = 1;
		const std::uint64_t rank = count();
		for (std::uint64_t i = 0; i < rank && in_; ++i)
		{
			const std::uint64_t id = count();
			const std::uint64_t length = id < dimensions.size() ? dimensions[id] : 0;
			if (i == 0 && length == 0)
				variable.record = true;
			else
				values *= length;
		}
		attributes(false);
		variable.bytes = values * typeSize(number(4));
		count(); // vsize, which overflows for large variables and is not to be relied on
		variable.begin = number(version_ == 1 ? 4 : 8);
		return variable;
	}

	std::ifstream in_;
	int version_ = 0;
	std::set<std::string> names_;
};

} // namespace

std::optional<std::uint64_t> netcdfSize(const std::string& file)
{
	return Header(file).size();
}

void refuseShortNetcdf(const std::string& file)
{
	char magic[3] = {};
	std::ifstream(file, std::ios::binary).read(magic, 3);
	if (std::string_view(magic, 3) != "CDF")
		return;
	const auto wanted = netcdfSize(file);
	const auto bytes = std::filesystem::file_size(file);
	if (!wanted)
		throw damaged("its header cannot be followed");
	if (bytes < *wanted)
		throw damaged(fmt::format("{} bytes where its header asks for {}", bytes, *wanted));
}

std::set<std::string> netcdfNames(const std::string& file)
{
	Header header(file);
	header.size();
	return header.names();
}

} // namespace vp::reader::checks
