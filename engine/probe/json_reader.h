#pragma once

#include "base/input_files.h"
#include "base/result.h"
#include "probe/transform.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vp::probe
{

// Why a document cannot be used: where in it (a JSON pointer), what is wrong and what would be right. Thrown to
// readDocument() only.
struct SchemaError
{
	std::string message;
};

// A value of a document and the pointer to it. Every reading checks; what does not fit throws SchemaError.
class JsonReader
{
public:
	JsonReader(const nlohmann::json& value, std::string path) : value_(value), path_(std::move(path)) {}

	[[noreturn]] void refuse(const std::string& reason) const;

	const nlohmann::json& value() const { return value_; }
	const std::string& path() const { return path_; }
	bool isArray() const { return value_.is_array(); }
	bool isObject() const { return value_.is_object(); }
	bool isString() const { return value_.is_string(); }
	std::size_t size() const { return value_.size(); }

	// An object with no other keys than these.
	void expectKeys(const std::vector<std::string_view>& keys) const;
	bool has(const char* key) const { return value_.contains(key); }
	JsonReader operator[](const char* key) const; // that must be there
	JsonReader at(std::size_t index) const;
	std::optional<JsonReader> find(const char* key) const;

	double number() const; // finite
	double length() const; // a number whose square is one too
	int whole(int least, int most) const;
	bool flag() const;
	std::string text() const;  // not empty
	std::string words() const; // may be empty
	void expectArray(std::size_t least, std::size_t most, std::string_view of) const;
	Vec3 vector() const;    // three lengths
	Vec3 direction() const; // three numbers, not all zero
	std::pair<double, double> ascending() const;
	Frame frame() const; // see docs/PROBES.md: origin, normal and up, or a rigid matrix in the paper's rows

private:
	std::string shown() const; // the value, shortened
	Frame frameOfMatrix() const;

	const nlohmann::json& value_;
	std::string path_;
};

// A key as it stands in a JSON pointer (RFC 6901), with what would break a line or a terminal replaced.
std::string pointerStep(std::string_view key);

// The document in a text, or one line that names the source and where the text is no JSON, a number too large or a key
// given twice.
Result<nlohmann::json> parseJson(std::string_view text, const std::string& source);

// The text of a file; missing, unreadable and huge ones are an input error.
Result<std::string> readText(const std::string& file, InputKind kind = InputKind::data);

// `read` a document, turning what it throws into one line that names the source.
template <class T, class Read>
Result<T> readDocument(const nlohmann::json& document, const std::string& source, const std::string& path, Read&& read)
{
	try
	{
		return read(JsonReader(document, path));
	}
	catch (const SchemaError& unfit)
	{
		return Error{ErrorKind::input, source + ": " + unfit.message};
	}
}

// The document in a file, read by parseJson and `read`.
template <class T, class Read>
Result<T> readFile(const std::string& file, Read&& read)
{
	const Result<std::string> text = readText(file);
	if (!text)
		return text.error();
	return read(*text, file);
}

nlohmann::json toJson(const Vec3& v);
nlohmann::json toJson(const Frame& frame);

// Indented by tabs, arrays of plain values on one line; ends with a line feed. Numbers are as short as they can be and
// still be read back to the last bit.
std::string jsonText(const nlohmann::json& document);

} // namespace vp::probe
