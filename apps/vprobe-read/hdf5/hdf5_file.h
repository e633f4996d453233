#pragma once

#include "grid/field.h"
#include "vprobe-read/arrays/stored_array.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <hdf5.h>

namespace vp::reader::hdf5
{

// Reads an HDF5 file by paths. Throws a Refusal if something does not exist or cannot be read. The "Or" functions
// return a default instead if it does not exist.
class File
{
public:
	explicit File(const std::string& file);
	~File();
	File(const File&) = delete;
	File& operator=(const File&) = delete;

	bool has(const std::string& path) const;
	bool isSet(const std::string& path) const;        // and no group
	bool leadsNowhere(const std::string& path) const; // a link whose target is not there
	// Returns the names in a group, or none if there is no group.
	enum class Order
	{
		alphabet,
		creation // if the group knows it
	};
	std::vector<std::string> namesIn(const std::string& group, Order order = Order::alphabet) const;

	// Return all values of a data set.
	std::vector<double> reals(const std::string& path) const;
	std::vector<std::int64_t> integers(const std::string& path) const;
	std::vector<std::uint64_t> sidesOf(const std::string& path) const;

	// Returns a data set of texts, without the blanks at their ends, or none if there is no such set.
	std::vector<std::string> texts(const std::string& path) const;
	// Returns a table with the columns "name" and "value", whose values are numbers. Empty if there is none.
	std::map<std::string, double> namedNumbers(const std::string& path) const;
	// Returns such a table whose values are texts.
	std::map<std::string, std::string> namedTexts(const std::string& path) const;
	// Returns one column of the first row of a table.
	double columnOr(const std::string& path, const char* column, double otherwise) const;

	// Returns the type of a data set's numbers in memory, or nothing if they are not numbers.
	std::optional<grid::NumberType> numberType(const std::string& path) const;
	// Reads a part of a data set, given by its beginning and its length along each side. Checks both. `to` must have
	// room.
	void readSlab(const std::string& path, const std::vector<std::uint64_t>& begin,
	              const std::vector<std::uint64_t>& count, grid::NumberType type, void* to) const;
	// Returns `count` integers of a list, from `begin` on.
	std::vector<std::int64_t> integersFrom(const std::string& path, std::uint64_t begin, std::uint64_t count) const;

	// Returns where the values of an image lie in the file (hdf5_stored.h), or nothing if they cannot stay there.
	std::optional<arrays::StoredPlace> storedPlace(const std::string& path, const arrays::ValueLayout& layout,
	                                               const std::vector<std::uint64_t>& front) const;

	// Returns where the numbers of a data set begin in the file (hdf5_stored.h), or nothing.
	std::optional<std::uint64_t> plainOffset(const std::string& path, grid::NumberType type) const;
	const std::string& name() const { return name_; } // the file's path

	bool isFloat(const std::string& path) const;
	// Returns the least and the greatest number that a data set of integers can hold.
	std::array<double, 2> limitsOfType(const std::string& path) const;

	double realOr(const std::string& object, const char* attribute, double otherwise) const;
	std::vector<double> realsOr(const std::string& object, const char* attribute) const;
	std::string textOr(const std::string& object, const char* attribute) const;

private:
	bool hasLink(const std::string& path) const; // in a group that is there
	bool hasAttribute(const std::string& object, const char* attribute) const;
	template <class Number>
	std::vector<Number> values(const std::string& path, hid_t type) const;

	std::string name_;
	hid_t file_;
};

} // namespace vp::reader::hdf5
