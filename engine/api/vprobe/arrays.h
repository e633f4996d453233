#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace vprobe
{

/// The values of an array, either the caller's or the library's.
enum class NumberType : std::uint8_t
{
	int8,
	uint8,
	int16,
	uint16,
	int32,
	uint32,
	int64,
	uint64,
	float32,
	float64
};

/// The type of a C++ number.
template <class T>
constexpr NumberType numberTypeOf()
{
	static_assert(std::is_arithmetic_v<T> && !std::is_same_v<T, bool>);
	if constexpr (std::is_floating_point_v<T>)
		return sizeof(T) == 4 ? NumberType::float32 : NumberType::float64;
	else
	{
		constexpr int size = sizeof(T) == 1 ? 0 : sizeof(T) == 2 ? 1 : sizeof(T) == 4 ? 2 : 3;
		return static_cast<NumberType>(2 * size + (std::is_unsigned_v<T> ? 1 : 0));
	}
}

/// A caller's numbers, which are shared and never changed. They stay valid as long as `owner` lives; without an owner
/// they must outlive the Dataset, its copies and the cuts that were made of it.
struct Numbers
{
	const void* data = nullptr;
	std::size_t size = 0; // numbers, not bytes
	NumberType type = NumberType::float32;
	std::shared_ptr<const void> owner{};

	Numbers() = default;
	Numbers(const void* data, std::size_t size, NumberType type, std::shared_ptr<const void> owner = nullptr)
	    : data(data), size(size), type(type), owner(std::move(owner))
	{
	}
	/// Numbers that the caller keeps.
	template <class T>
	Numbers(std::span<T> values, std::shared_ptr<const void> owner = nullptr)
	    : Numbers(values.data(), values.size(), numberTypeOf<std::remove_cv_t<T>>(), std::move(owner))
	{
	}
	template <class T>
	Numbers(const std::vector<T>& values, std::shared_ptr<const void> owner = nullptr)
	    : Numbers(std::span(values), std::move(owner))
	{
	}
	/// Numbers that are shared with the caller.
	template <class T>
	Numbers(std::shared_ptr<const std::vector<T>> values) : Numbers(std::span(*values), values)
	{
	}
};

/// Says whether an array has its values at points or in cells.
enum class Association : std::uint8_t
{
	point,
	cell
};

/// An array over the points or cells of a block: `components` numbers for each, in the order of its points or cells.
struct Field
{
	std::string name;
	Association association = Association::point;
	int components = 1;
	Numbers values;
	std::string units{};
};

/// Describes an array of a data set.
struct ArrayInfo
{
	std::string name;
	Association association = Association::point;
	NumberType type = NumberType::float32;
	int components = 1;
	std::string units;
};

} // namespace vprobe
