#pragma once

#include "foam_field.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vp::reader::codes
{

// The mesh of a region. All of its numbers fit together.
struct FoamMesh
{
	FoamList points;
	bool is_double = true; // whether the points are written in double precision
	FoamFaces faces;
	std::vector<std::int64_t> owners;     // the cell of each face
	std::vector<std::int64_t> neighbours; // the cell behind each of the first faces
	std::vector<FoamPatch> patches;
	std::size_t cells = 0;
};

struct FoamFieldFile
{
	std::filesystem::path path;
	FoamHead head;
	std::string name; // the name of its array
};

struct FoamTime
{
	std::string name; // the name of its folder
	double value;
};

// The times of a case, ascending.
std::vector<FoamTime> foamTimes(const std::filesystem::path& folder);

// The files of a case at one time. The default region has no name.
class FoamCase
{
public:
	// times: the names of the folders up to the one that is shown, in their order.
	FoamCase(std::filesystem::path folder, std::vector<std::string> times)
	    : folder_(std::move(folder)), times_(std::move(times))
	{
	}

	std::vector<std::string> regions() const; // those that have a mesh
	FoamMesh mesh(const std::string& region) const;
	// All fields, in the order of their files' names; those that are of no cells or points too, and empty files, whose
	// heads have no type.
	std::vector<FoamFieldFile> fields(const std::string& region) const;
	FoamField field(const FoamFieldFile& file, const FoamMesh& mesh) const;

private:
	// A file of the mesh, which may move or change: as it was last written. Empty if there is none.
	std::filesystem::path meshFile(const std::string& region, const std::string& name) const;
	// Returns the result of `parse` for a file's text, or for a text that is at hand. A refusal names the file.
	template <class Parse>
	auto parsed(const std::filesystem::path& file, const Parse& parse,
	            const std::optional<std::string>& text = std::nullopt) const;
	template <class Parse>
	auto parsedOfMesh(const std::string& region, const std::string& name, const Parse& parse) const;

	std::filesystem::path folder_;
	std::vector<std::string> times_;
};

} // namespace vp::reader::codes
