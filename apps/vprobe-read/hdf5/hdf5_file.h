#pragma once

#include "grid/field.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <hdf5.h>

// An HDF5 file that is read by paths. What is not there, or cannot be read, is a Refusal, but for the "Or" functions.
class Hdf5File
{
public:
	explicit Hdf5File(const std::string& file);
	~Hdf5File();
	Hdf5File(const Hdf5File&) = delete;
	Hdf5File& operator=(const Hdf5File&) = delete;

	bool has(const std::string& path) const;
	bool isSet(const std::string& path) const; // and no group
	// The names in a group, in the order of the alphabet; none where there is no group.
	std::vector<std::string> namesIn(const std::string& group) const;

	// All values of a data set, as many as it has.
	std::vector<double> reals(const std::string& path) const;
	std::vector<std::int64_t> integers(const std::string& path) const;
	std::vector<std::uint64_t> sidesOf(const std::string& path) const;

	// A data set of texts, without the blanks at their ends; none where there is no such set.
	std::vector<std::string> texts(const std::string& path) const;
	// A table with the columns "name" and "value", of numbers; empty where there is none.
	std::map<std::string, double> namedNumbers(const std::string& path) const;
	// The same, of texts.
	std::map<std::string, std::string> namedTexts(const std::string& path) const;
	// One column of the first row of a table.
	double columnOr(const std::string& path, const char* column, double otherwise) const;

	// The type of a data set's numbers in memory; none for texts and the like.
	std::optional<vp::grid::NumberType> numberType(const std::string& path) const;
	// A part of a data set, by the place where it begins and its length along each side. All is checked. `to` has room.
	void readSlab(const std::string& path, const std::vector<std::uint64_t>& begin,
	              const std::vector<std::uint64_t>& count, vp::grid::NumberType type, void* to) const;
	// So many whole numbers of a list, from one on.
	std::vector<std::int64_t> integersFrom(const std::string& path, std::uint64_t begin, std::uint64_t count) const;

	bool isFloat(const std::string& path) const;
	// The least and the greatest number that a data set of whole numbers can hold.
	std::array<double, 2> limitsOfType(const std::string& path) const;

	double realOr(const std::string& object, const char* attribute, double otherwise) const;
	std::vector<double> realsOr(const std::string& object, const char* attribute) const;
	std::string textOr(const std::string& object, const char* attribute) const;

private:
	bool hasLink(const std::string& path) const; // in a group that is there
	bool hasAttribute(const std::string& object, const char* attribute) const;
	template <class Number>
	std::vector<Number> values(const std::string& path, hid_t type) const;

	hid_t file_;
};
