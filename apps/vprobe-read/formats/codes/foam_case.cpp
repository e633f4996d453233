#include "foam_case.h"

#include "foam_blocks.h"

#include "base/real_text.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <system_error>

namespace vp::reader::codes
{

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

// OpenFOAM does not see these.
bool isBackup(const std::string& name)
{
	return name.starts_with('.') || name.ends_with('~') || name.ends_with(".bak") || name.ends_with(".BAK") ||
	       name.ends_with(".old") || name.ends_with(".save");
}

// Digits as the programs name their folders: "0", "1e-05", "-0.5".
bool isTime(const std::string& name)
{
	const std::optional<double> value = parseReal(name);
	return value && std::isfinite(*value) && name.find_first_not_of("0123456789+-.eE") == name.npos;
}

std::vector<fs::path> foldersIn(const fs::path& folder)
{
	std::vector<fs::path> folders;
	std::error_code none;
	for (const auto& entry : fs::directory_iterator(folder, none))
		if (entry.is_directory(none))
			folders.push_back(entry.path());
	return folders;
}

std::optional<FoamSource> openSource(const fs::path& path)
{
	const fs::path file = thereOrPacked(path);
	if (file.empty())
		return std::nullopt;
	const auto text = std::make_shared<const FoamFileText>(file, std::nullopt);
	return FoamSource{file, text, text->text()};
}

// The name of a file, and of its packed sister.
std::string nameUnpacked(const fs::path& path)
{
	const std::string name = path.filename().string();
	return path.extension() == ".gz" ? name.substr(0, name.size() - 3) : name;
}

// An array has the name in the head of its file, unless another has that too.
void nameFields(std::vector<FoamFieldFile>& fields)
{
	std::multiset<std::string> taken;
	for (FoamFieldFile& field : fields)
	{
		field.name = nameUnpacked(field.path);
		taken.insert(field.name);
		if (field.head.object != field.name)
			taken.insert(field.head.object);
	}
	for (FoamFieldFile& field : fields)
		if (taken.count(field.head.object) == 1 && !field.head.object.empty())
			field.name = field.head.object;
}

} // namespace

std::vector<FoamTime> foamTimes(const fs::path& folder)
{
	std::vector<FoamTime> times;
	for (const fs::path& each : foldersIn(folder))
		if (const std::string name = each.filename().string(); isTime(name))
			times.push_back({name, *parseReal(name)});
	std::ranges::sort(times, {}, [](const FoamTime& time) { return std::pair(time.value, time.name); });
	return times;
}

double lastFoamTime(const std::vector<FoamTime>& times)
{
	return times.empty() ? -std::numeric_limits<double>::infinity() : times.back().value;
}

std::string FoamCase::nameOf(const fs::path& file) const
{
	return file.lexically_proximate(root_).string();
}

template <class Parse>
auto FoamCase::parsed(const fs::path& file, const Parse& parse, const std::optional<std::string>& text) const
{
	try
	{
		return text ? parse(*text) : parse(FoamFileText(file, block_).text());
	}
	catch (const FoamUnknown&)
	{
		throw;
	}
	catch (const Refusal& refusal)
	{
		throw Refusal(fmt::format("its file {}: {}", nameOf(file), refusal.what()));
	}
}

template <class Parse>
auto FoamCase::parsedOfMesh(const std::string& region, const std::string& name, const Parse& parse) const
{
	const fs::path file = meshFile(region, name);
	if (file.empty())
		throw damaged("it has no " + fs::path(nameOf(folder_ / "polyMesh" / name)).lexically_normal().string());
	return parsed(file, parse);
}

fs::path FoamCase::meshFile(const std::string& region, const std::string& name) const
{
	for (auto time = times_.rbegin(); time != times_.rend(); ++time)
		if (fs::path found = thereOrPacked(folder_ / *time / region / "polyMesh" / name); !found.empty())
			return found;
	return thereOrPacked(folder_ / "constant" / region / "polyMesh" / name);
}

std::vector<std::string> FoamCase::regions() const
{
	std::set<std::string> names = {""};
	std::vector<std::string> places = times_;
	places.emplace_back("constant");
	for (const std::string& place : places)
		for (const fs::path& folder : foldersIn(folder_ / place))
			if (folder.filename() != "polyMesh")
				names.insert(folder.filename().string());
	std::erase_if(names, [&](const std::string& name) { return meshFile(name, "faces").empty(); });
	return {names.begin(), names.end()};
}

FoamMesh FoamCase::mesh(const std::string& region) const
{
	FoamMesh mesh;
	parsedOfMesh(region, "points",
	             [&](std::string_view text)
	             {
		             mesh.is_double = foamHead(text).isDouble();
		             mesh.points = foamPoints(text);
	             });
	if (mesh.points.is_uniform)
		throw damaged("all points of its mesh are one");
	mesh.faces = parsedOfMesh(region, "faces", foamFaces);
	const auto labels = [&](std::string_view text) { return foamLabels(text, mesh.faces.size()); };
	mesh.owners = parsedOfMesh(region, "owner", labels);
	mesh.neighbours = parsedOfMesh(region, "neighbour", labels);
	mesh.patches = parsedOfMesh(region, "boundary", foamPatches);
	// Early versions name a neighbor of each face, with -1 at the boundary.
	std::erase(mesh.neighbours, -1);

	const auto isBelow = [](std::size_t end)
	{ return [end](std::int64_t number) { return number >= 0 && static_cast<std::size_t>(number) < end; }; };
	// A cell has four faces at the least, and a face two cells at most.
	const std::size_t most_cells = mesh.faces.size() / 2;
	bool fits = mesh.owners.size() == mesh.faces.size() && mesh.neighbours.size() <= mesh.faces.size() &&
	            std::ranges::all_of(mesh.faces.corners, isBelow(mesh.points.size())) &&
	            std::ranges::all_of(mesh.owners, isBelow(most_cells)) &&
	            std::ranges::all_of(mesh.neighbours, isBelow(most_cells));
	const auto faces = static_cast<std::int64_t>(mesh.faces.size());
	for (const FoamPatch& patch : mesh.patches)
		fits = fits && patch.faces <= faces && patch.first <= faces - patch.faces;
	if (!fits)
		throw damaged("the files of its mesh do not fit together");
	for (const auto* cells : {&mesh.owners, &mesh.neighbours})
		for (const std::int64_t cell : *cells)
			mesh.cells = std::max(mesh.cells, static_cast<std::size_t>(cell) + 1);
	return mesh;
}

FoamNumbers FoamCase::numbers(const std::string& region) const
{
	const fs::path folder = meshFile(region, "faces").parent_path();
	const auto read = [&](const char* name) -> std::vector<std::int64_t>
	{
		const fs::path file = thereOrPacked(folder / name);
		if (file.empty())
			return {};
		return parsed(file, [](std::string_view text) { return foamLabels(text, text.size()); });
	};
	return {read("pointProcAddressing"), read("cellProcAddressing")};
}

std::vector<FoamFieldFile> FoamCase::fields(const std::string& region) const
{
	std::vector<FoamFieldFile> fields;
	if (times_.empty())
		return fields;
	const fs::path folder = folder_ / times_.back() / region;
	std::error_code none;
	for (const auto& entry : fs::directory_iterator(folder, none))
	{
		const fs::path path = entry.path();
		const bool is_packed = path.extension() == ".gz";
		if (!entry.is_regular_file(none) || isBackup(path.filename().string()) ||
		    (is_packed && fs::is_regular_file(folder / path.stem(), none))) // if both are there, the plain one counts
			continue;
		const std::string bytes = firstBytes(path);
		if (is_packed && (bytes.empty() || entry.file_size(none) == 0))
			throw damaged(fmt::format("its file {} ends early", nameOf(path)));
		FoamFieldFile file = {path, {}, {}};
		if (bytes.find("FoamFile") != bytes.npos)
			file.head = parsed(
			    path, [](std::string_view text) { return foamHead(foamFirstBlock(text)); }, bytes);
		const bool is_field = file.head.type.find("Field") != std::string::npos;
		if (is_field || bytes.empty()) // others are texts of somebody's, and dictionaries
			fields.push_back(std::move(file));
	}
	std::ranges::sort(fields, {}, &FoamFieldFile::path);
	nameFields(fields);
	return fields;
}

FoamFieldFile FoamCase::sameField(const FoamFieldFile& of_other, const std::string& region) const
{
	const fs::path folder = folder_ / times_.back() / region;
	FoamFieldFile own = of_other;
	own.path = thereOrPacked(folder / nameUnpacked(of_other.path));
	if (own.path.empty())
		throw FoamUnknown(nameOf(folder) + " does not have it");
	return own;
}

FoamField FoamCase::field(const FoamFieldFile& file, const FoamMesh& mesh) const
{
	const bool is_of_cells = file.head.type.starts_with("vol");
	const std::size_t elements = is_of_cells ? mesh.cells : mesh.points.size();
	FoamFiles files = {file.path, fs::absolute(root_).lexically_normal(), openSource};
	return parsed(file.path,
	              [&](std::string_view text)
	              {
		              const std::unique_ptr<FoamDocument> document = parseFoam(text, files);
		              return foamField(*document, elements,
		                               is_of_cells ? std::span(mesh.patches) : std::span<const FoamPatch>());
	              });
}

} // namespace vp::reader::codes
