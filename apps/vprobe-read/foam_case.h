#pragma once

#include "foam_text.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// The faces of a region's mesh.
struct FoamMesh
{
	FoamFaces faces;
	std::vector<std::int64_t> owners; // the cell of each face
	std::vector<FoamPatch> patches;
};

struct FoamFieldFile
{
	std::filesystem::path path;
	FoamHead head;
};

// The files of a case at one time. A region without a name is the only one, or the default one.
class FoamCase
{
public:
	// times: the names of the folders up to the one that is shown, in their order.
	FoamCase(std::filesystem::path folder, std::vector<std::string> times)
	    : folder_(std::move(folder)), times_(std::move(times))
	{
	}

	// A file of the mesh, which may move or change: as it was last written.
	std::filesystem::path meshFile(const std::string& region, const std::string& name) const;
	// None if its numbers are in single precision, which readers keep.
	std::optional<FoamList> doublePoints(const std::string& region) const;
	// With numbers that fit together, for so many points and cells.
	FoamMesh mesh(const std::string& region, std::size_t points, std::size_t cells) const;
	// Fields of cells and points, in the order of their files' names.
	std::vector<FoamFieldFile> fields(const std::string& region) const;

private:
	std::filesystem::path folder_;
	std::vector<std::string> times_;
};
