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

// The numbers that the points and cells of a processor's part have in the whole mesh. Empty where they are not told.
struct FoamNumbers
{
	std::vector<std::int64_t> points, cells;
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
// Minus infinity if there are none.
double lastFoamTime(const std::vector<FoamTime>& times);

// Where the files of a case lie, or those of one processor's part of it.
struct FoamPlace
{
	std::filesystem::path folder;
	std::optional<std::size_t> block = std::nullopt; // its number in each file, if processors share them
};

// The files of a case, or of one part of it, at one time. The default region has no name.
class FoamCase
{
public:
	// root: the folder of the whole case. times: the names of the folders up to the one that is shown, in their order.
	FoamCase(std::filesystem::path root, FoamPlace place, std::vector<std::string> times)
	    : root_(std::move(root)), folder_(std::move(place.folder)), block_(place.block), times_(std::move(times))
	{
	}

	std::vector<std::string> regions() const; // those that have a mesh
	FoamMesh mesh(const std::string& region) const;
	// Those that were written with the faces that the mesh has now.
	FoamNumbers numbers(const std::string& region) const;
	// All fields, in the order of their files' names; those that are of no cells or points too, and empty files, whose
	// heads have no type.
	std::vector<FoamFieldFile> fields(const std::string& region) const;
	// The file of a field that another part has. Throws FoamUnknown if this one has none.
	FoamFieldFile sameField(const FoamFieldFile& of_other, const std::string& region) const;
	FoamField field(const FoamFieldFile& file, const FoamMesh& mesh) const;

private:
	// A file of the mesh, which may move or change: as it was last written. Empty if there is none.
	std::filesystem::path meshFile(const std::string& region, const std::string& name) const;
	// How messages name a file.
	std::string nameOf(const std::filesystem::path& file) const;
	// Returns the result of `parse` for a file's text, or for a text that is at hand. A refusal names the file.
	template <class Parse>
	auto parsed(const std::filesystem::path& file, const Parse& parse,
	            const std::optional<std::string>& text = std::nullopt) const;
	template <class Parse>
	auto parsedOfMesh(const std::string& region, const std::string& name, const Parse& parse) const;

	std::filesystem::path root_, folder_;
	std::optional<std::size_t> block_;
	std::vector<std::string> times_;
};

} // namespace vp::reader::codes
