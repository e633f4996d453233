#include "foam_whole.h"

#include "vprobe-read/quick/tasks.h"

#include <algorithm>
#include <set>
#include <utility>

namespace vp::reader::codes
{

namespace
{

FoamList copiedTo(const std::vector<FoamField>& parts, const std::vector<FoamNumbers>& numbers,
                  std::vector<std::int64_t> FoamNumbers::*which, std::size_t elements)
{
	FoamList whole;
	whole.components = parts[0].inside->components;
	const auto width = static_cast<std::size_t>(whole.components);
	whole.numbers.resize(elements * width);
	for (std::size_t p = parts.size(); p-- > 0;) // the first part that has a point tells its value
	{
		const std::vector<std::int64_t>& to = numbers[p].*which;
		for (std::size_t i = 0; i < to.size(); ++i)
			std::copy_n(parts[p].inside->at(i), width, whole.numbers.data() + static_cast<std::size_t>(to[i]) * width);
	}
	return whole;
}

// The values at the faces of one patch of the whole.
FoamPatchValues joinedValues(const FoamRegion& region, const std::vector<FoamField>& parts, std::size_t patch,
                             const FoamList& inside)
{
	FoamPatchValues joined;
	FoamList values;
	values.components = inside.components;
	const auto width = static_cast<std::size_t>(inside.components);
	auto face = static_cast<std::size_t>(region.mesh.patches[patch].first);
	bool has_own = false;
	for (const auto [p, i] : region.patches[patch])
	{
		const FoamPatch& of_part = region.parts[p].patches[i];
		const FoamPatchValues& own = parts[p].patches[i];
		if (of_part.faces == 0)
			continue;
		if (joined.unknown.empty())
			joined.unknown = own.unknown;
		const bool is_own = own.values && of_part.cyclic.empty(); // a cyclic patch shows what is behind it
		has_own |= is_own;
		for (std::int64_t f = 0; f < of_part.faces; ++f, ++face)
		{
			const double* from = is_own ? own.values->at(static_cast<std::size_t>(f))
			                            : inside.at(static_cast<std::size_t>(region.mesh.owners[face]));
			values.numbers.insert(values.numbers.end(), from, from + width);
		}
	}
	if (has_own)
		joined.values = std::make_shared<const FoamList>(std::move(values));
	return joined;
}

// The values of a field on the whole, of cells or of points, from those on the parts.
FoamField joinFoamFields(const FoamRegion& region, const std::vector<FoamField>& parts, bool is_of_cells)
{
	for (const FoamField& part : parts)
		if (part.inside->components != parts[0].inside->components)
			throw FoamUnknown("it is of another kind in some parts");
	FoamField whole;
	FoamList inside = is_of_cells ? copiedTo(parts, region.numbers, &FoamNumbers::cells, region.mesh.cells)
	                              : copiedTo(parts, region.numbers, &FoamNumbers::points, region.mesh.points.size());
	if (is_of_cells)
		for (std::size_t patch = 0; patch < region.patches.size(); ++patch)
			whole.patches.push_back(joinedValues(region, parts, patch, inside));
	whole.inside = std::make_shared<const FoamList>(std::move(inside));
	return whole;
}

} // namespace

void FoamWhole::forEachPart(const std::function<void(std::size_t)>& read) const
{
	quick::Tasks tasks(threads_);
	tasks.add(parts_.size(), [&read](std::size_t part, arrays::Scratch&) { read(part); });
	tasks.run();
}

std::vector<std::string> FoamWhole::regions() const
{
	std::set<std::string> names;
	for (const FoamCase& part : parts_)
		for (std::string& name : part.regions())
			names.insert(std::move(name));
	return {names.begin(), names.end()};
}

FoamRegion FoamWhole::region(const std::string& name) const
{
	FoamRegion region;
	if (!is_decomposed_)
	{
		region.mesh = parts_[0].mesh(name);
		return region;
	}
	std::vector<FoamMesh> meshes(parts_.size());
	std::vector<FoamNumbers> numbers(parts_.size());
	forEachPart(
	    [&](std::size_t p)
	    {
		    meshes[p] = parts_[p].mesh(name);
		    numbers[p] = parts_[p].numbers(name);
	    });
	return joinFoamParts(std::move(meshes), std::move(numbers));
}

FoamField FoamWhole::field(const FoamFieldFile& file, const std::string& name, const FoamRegion& region) const
{
	if (!is_decomposed_)
		return parts_[0].field(file, region.mesh);
	std::vector<FoamField> fields(parts_.size());
	forEachPart([&](std::size_t p) { fields[p] = parts_[p].field(parts_[p].sameField(file, name), region.parts[p]); });
	return joinFoamFields(region, fields, file.head.type.starts_with("vol"));
}

} // namespace vp::reader::codes
