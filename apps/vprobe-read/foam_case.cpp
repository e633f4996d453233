#include "foam_case.h"

#include "gzip_text.h"
#include "refusal.h"

#include <zlib.h>

#include <algorithm>
#include <memory>
#include <system_error>

namespace fs = std::filesystem;

namespace
{

// The first bytes of a file, whether it is packed or not.
std::string firstBytes(const fs::path& path)
{
	std::string bytes(1 << 13, '\0');
	const std::unique_ptr<gzFile_s, int (*)(gzFile_s*)> file(gzopen(path.c_str(), "rb"), gzclose_r);
	const int got = file ? gzread(file.get(), bytes.data(), static_cast<unsigned>(bytes.size())) : 0;
	bytes.resize(static_cast<std::size_t>(std::max(got, 0)));
	return bytes;
}

// The file itself, or its packed sister; empty if there is neither.
fs::path thereOrPacked(const fs::path& path)
{
	std::error_code none;
	if (fs::is_regular_file(path, none))
		return path;
	const fs::path packed = path.string() + ".gz";
	return fs::is_regular_file(packed, none) ? packed : fs::path();
}

} // namespace

fs::path FoamCase::meshFile(const std::string& region, const std::string& name) const
{
	for (auto time = times_.rbegin(); time != times_.rend(); ++time)
		if (fs::path found = thereOrPacked(folder_ / *time / region / "polyMesh" / name); !found.empty())
			return found;
	if (fs::path found = thereOrPacked(folder_ / "constant" / region / "polyMesh" / name); !found.empty())
		return found;
	throw damaged("it has no polyMesh/" + name);
}

std::optional<FoamList> FoamCase::doublePoints(const std::string& region) const
{
	const MaybeGzip file(meshFile(region, "points").string());
	if (!foamHead(file.text()).isDouble())
		return std::nullopt;
	return foamPoints(file.text());
}

FoamMesh FoamCase::mesh(const std::string& region, std::size_t points, std::size_t cells) const
{
	FoamMesh mesh = {foamFaces(MaybeGzip(meshFile(region, "faces").string()).text()),
	                 foamLabels(MaybeGzip(meshFile(region, "owner").string()).text()),
	                 foamPatches(MaybeGzip(meshFile(region, "boundary").string()).text())};
	const auto isBelow = [](std::size_t end)
	{ return [end](std::int64_t number) { return number >= 0 && static_cast<std::size_t>(number) < end; }; };
	bool fits = mesh.owners.size() == mesh.faces.size() && std::ranges::all_of(mesh.faces.corners, isBelow(points)) &&
	            std::ranges::all_of(mesh.owners, isBelow(cells));
	const auto faces = static_cast<std::int64_t>(mesh.faces.size());
	for (const FoamPatch& patch : mesh.patches)
		fits &= patch.faces <= faces && patch.first <= faces - patch.faces;
	if (!fits)
		throw damaged("the files of its mesh do not fit together");
	return mesh;
}

std::vector<FoamFieldFile> FoamCase::fields(const std::string& region) const
{
	std::vector<FoamFieldFile> fields;
	std::error_code none;
	if (times_.empty())
		return fields;
	for (const auto& entry : fs::directory_iterator(folder_ / times_.back() / region, none))
		try
		{
			if (!entry.is_regular_file(none))
				continue;
			FoamHead head = foamHead(firstBytes(entry.path()));
			if (head.type.starts_with("vol") || head.type.starts_with("point"))
				fields.push_back({entry.path(), std::move(head)});
		}
		catch (const Refusal&)
		{
		} // of another kind
	std::ranges::sort(fields, {}, &FoamFieldFile::path);
	return fields;
}
