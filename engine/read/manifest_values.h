#pragma once

#include "grid/field.h"
#include "grid/imaging.h"
#include "grid/points.h"
#include "read/mapping.h"
#include "read/read_warning.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace vp::read
{

// Checked values of a manifest. All functions throw Unusable if a value is not what it should be.

constexpr std::uint64_t kAnyCount = ~std::uint64_t(0);
// More than any tensor or spectrum in a file; keeps tuples x components x bytes far from overflow.
constexpr int kMaxComponents = 1 << 16;

std::uint64_t countOf(const nlohmann::json& value);
double finiteOf(const nlohmann::json& value);
Vec3 vectorOf(const nlohmann::json& value);
// Returns a text without control characters, cut to a length that a message may have.
std::string wordsOf(const nlohmann::json& value);
// value: words, or {"count", "words"}.
ReadWarning warningOf(const nlohmann::json& value);
grid::NumberType numberTypeOf(const std::string& name);
grid::Association associationOf(const nlohmann::json& value);
// name: of the array, for the message.
int componentsOf(const nlohmann::json& value, const std::string& name);

// Returns "point:NAME" or "cell:NAME" of an array that nobody asked for.
std::string leftOutName(const nlohmann::json& array);

// Returns what a pack says of all values of an array.
std::shared_ptr<const grid::ArrayFacts> factsOf(const nlohmann::json& facts, int components);

// Parses a text of a child. Throws Unusable if it is nested too deeply, and the exceptions of nlohmann::json.
nlohmann::json parsedManifest(std::string_view text);

// Returns the bytes of an array that holds so many numbers of its type.
Array<std::byte> bytesOf(const SharedBytes& memory, const nlohmann::json& array, grid::NumberType type,
                         std::uint64_t numbers);

// The same, if the manifest gives the array this type.
Array<std::byte> bytesOfType(const SharedBytes& memory, const nlohmann::json& array, grid::NumberType type,
                             std::uint64_t numbers);

template <class T>
Array<T> numbersOf(const SharedBytes& memory, const nlohmann::json& array, grid::NumberType type,
                   std::uint64_t numbers = kAnyCount)
{
	const Array<std::byte> bytes = bytesOfType(memory, array, type, numbers);
	return {memory.owner, reinterpret_cast<const T*>(bytes.data()), bytes.size() / sizeof(T)};
}

grid::Points coordinatesOf(const SharedBytes& memory, const nlohmann::json& array, std::uint64_t points = kAnyCount);

// Returns what the manifest says of a picture of the data.
grid::Imaging imagingOf(const nlohmann::json& manifest);

} // namespace vp::read
