#include "cf_volumes.h"

#include "cf_values.h"
#include "vprobe-read/base/refusal.h"
#include "wrf_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

namespace vp::reader::volumes
{

namespace
{

using CfSides = std::vector<std::pair<std::string, std::size_t>>;

// One variable, before it is known which grid is shown.
struct Candidate
{
	int variable;
	std::string name;
	CfSides sides;
	std::vector<std::size_t> space; // those of its dimensions that are longer than 1, and no time
	std::optional<std::size_t> time;

	std::set<std::string> key() const
	{
		std::set<std::string> names;
		for (const std::size_t side : space)
			names.insert(sides[side].first);
		return names;
	}
	std::string words() const
	{
		std::vector<std::string> names;
		for (const auto& [name, length] : sides)
			names.push_back(name);
		return fmt::format("({})", fmt::join(names, ", "));
	}
};

std::vector<std::string> wordsIn(const std::string& text)
{
	std::istringstream in(text);
	std::vector<std::string> words;
	for (std::string word; in >> word;)
		words.push_back(word);
	return words;
}

// A variable that says where the cells of others lie is no array.
std::set<std::string> boundsOfOthers(const hdf5::NetcdfFile& file)
{
	std::set<std::string> names;
	for (const auto& [variable, name, type] : file.variables())
		for (const char* attribute : {"bounds", "climatology"})
			names.insert(file.text(variable, attribute));
	return names;
}

class Dimensions
{
public:
	explicit Dimensions(const hdf5::NetcdfFile& file) : file_(file)
	{
		int count = 0;
		hdf5::NetcdfFile::check(nc_inq_unlimdims(file.id(), &count, nullptr));
		std::vector<int> ids(static_cast<std::size_t>(count));
		hdf5::NetcdfFile::check(nc_inq_unlimdims(file.id(), &count, ids.data()));
		for (const int id : ids)
		{
			std::array<char, NC_MAX_NAME + 1> name = {};
			hdf5::NetcdfFile::check(nc_inq_dimname(file.id(), id, name.data()));
			records_.insert(name.data());
		}
	}

	CfDimension& of(const std::string& name, std::size_t length)
	{
		auto found = all_.find(name);
		if (found == all_.end())
			found = all_.emplace(name, cfDimension(file_, name, length)).first;
		return found->second;
	}

	// Coordinates of other names: "auxiliary" ones.
	void takeCoordinatesOf(int variable)
	{
		for (const std::string& word : wordsIn(file_.text(variable, "coordinates")))
		{
			const int places = file_.variable(word.c_str());
			if (places < 0 || cfTypeOf(file_, places) == 0)
				continue;
			const CfSides sides = file_.dimensions(places);
			if (sides.size() != 1)
				continue;
			CfDimension& dimension = of(sides[0].first, sides[0].second);
			const CfRole role = cfRoleOf(file_, places);
			if (dimension.coordinate < 0 && role != CfRole::none)
			{
				dimension.coordinate = places;
				dimension.role = role;
			}
		}
	}

	// Times have an axis, units or a name that say so; of four dimensions without, the one that grows.
	std::optional<std::size_t> timeAmong(const CfSides& sides)
	{
		const auto roleAt = [&](std::size_t i) { return of(sides[i].first, sides[i].second).role; };
		for (std::size_t i = 0; i < sides.size(); ++i)
			if (roleAt(i) == CfRole::time)
				return i;
		for (std::size_t i = 0; i < sides.size(); ++i)
			if (roleAt(i) == CfRole::none && cfRoleOfName(sides[i].first) == CfRole::time)
				return i;
		if (std::ranges::count_if(sides, [](const auto& side) { return side.second > 1; }) > 3)
			for (std::size_t i = 0; i < sides.size(); ++i)
				if (roleAt(i) == CfRole::none && records_.contains(sides[i].first))
					return i;
		return std::nullopt;
	}

private:
	const hdf5::NetcdfFile& file_;
	std::map<std::string, CfDimension> all_;
	std::set<std::string> records_; // dimensions that grow
};

// Which of three dimensions run along x, y and z: what their coordinates say, else what their names say, else the last
// one along x.
std::array<std::size_t, 3> sidesInOrder(const Candidate& volume, Dimensions& dimensions)
{
	constexpr std::size_t unknown = ~std::size_t(0);
	std::array<std::size_t, 3> slots = {unknown, unknown, unknown};
	std::vector<std::size_t> left(volume.space.rbegin(), volume.space.rend());
	const auto place = [&](auto&& roleOf)
	{
		std::map<CfRole, int> claims;
		for (const std::size_t side : left)
			++claims[roleOf(side)];
		std::erase_if(left,
		              [&](std::size_t side)
		              {
			              const CfRole role = roleOf(side);
			              const auto slot = static_cast<std::size_t>(role) - 1;
			              if (role == CfRole::none || role == CfRole::time || claims[role] > 1 ||
			                  slots[slot] != unknown)
				              return false;
			              slots[slot] = side;
			              return true;
		              });
	};
	place([&](std::size_t side) { return dimensions.of(volume.sides[side].first, 0).role; });
	place([&](std::size_t side) { return cfRoleOfName(volume.sides[side].first); });
	for (const std::size_t side : left)
		*std::ranges::find(slots, unknown) = side;
	return slots;
}

// Places of two dimensions: both axes that they run over become x and y.
void takePlaces(const hdf5::NetcdfFile& file, const Candidate& volume, CfVolumes& volumes,
                std::array<std::size_t, 3>& slots)
{
	std::set<std::string> over;
	std::vector<int> named;
	for (const std::string& word : wordsIn(file.text(volume.variable, "coordinates")))
		named.push_back(file.variable(word.c_str()));
	if (isWrf(file)) // whose older versions name none
	{
		const WrfPlaces places = wrfPlaces(file);
		named.insert(named.end(), {places.x, places.y});
	}
	for (const int places : named)
	{
		if (places < 0 || cfTypeOf(file, places) == 0)
			continue;
		std::set<std::string> names;
		for (const auto& [name, length] : file.dimensions(places))
			if (length > 1 && (!volume.time || name != volume.sides[*volume.time].first))
				names.insert(name);
		const std::set<std::string> key = volume.key();
		if (names.size() != 2 || !std::ranges::includes(key, names) || (!over.empty() && names != over))
			continue;
		const CfRole role = cfRoleOf(file, places);
		int& to = role == CfRole::x ? volumes.x_places : volumes.y_places;
		if ((role == CfRole::x || role == CfRole::y) && to < 0)
		{
			to = places;
			over = names;
		}
	}
	if (volumes.x_places < 0 || volumes.y_places < 0)
	{
		volumes.x_places = volumes.y_places = -1;
		return;
	}
	const auto is_other = [&](std::size_t side) { return !over.contains(volume.sides[side].first); };
	std::swap(*std::ranges::find_if(slots, is_other), slots[2]);
	if (slots[0] < slots[1]) // neither is along x: the last one runs fastest
		std::swap(slots[0], slots[1]);
}

std::vector<Candidate> candidatesOf(const hdf5::NetcdfFile& file, Dimensions& dimensions,
                                    std::vector<std::string>& notes)
{
	const std::set<std::string> bounds = boundsOfOthers(file);
	std::vector<Candidate> all;
	std::string empty, crowded;
	for (const auto& [variable, name, type] : file.variables())
	{
		Candidate each{variable, name, file.dimensions(variable), {}, {}};
		if (bounds.contains(name) || each.sides.size() < 3)
			continue;
		if (const std::string mesh = file.text(variable, "mesh");
		    !mesh.empty() && !file.text(variable, "location").empty())
		{
			notes.push_back(fmt::format("{} lies on the mesh {} of the UGRID conventions and is left out", name, mesh));
			continue;
		}
		for (const auto& [side, length] : each.sides)
			dimensions.of(side, length);
		dimensions.takeCoordinatesOf(variable);
		each.time = dimensions.timeAmong(each.sides);
		const auto none = std::ranges::find_if(each.sides, [](const auto& side) { return side.second == 0; });
		for (std::size_t i = 0; i < each.sides.size(); ++i)
			if (each.sides[i].second > 1 && each.time != i)
				each.space.push_back(i);
		if (none != each.sides.end())
			empty = fmt::format("{} has no values, since its dimension {} is 0", name, none->first);
		else if (each.space.size() > 3)
			crowded = fmt::format("{}{} has {} dimensions longer than 1 that are no time; take one index of the others "
			                      "with ncks -d NAME,0",
			                      name, each.words(), each.space.size());
		else if (each.space.size() == 3 && each.key().size() < 3)
			notes.push_back(fmt::format("{} has a dimension twice and is left out", name));
		else if (each.space.size() == 3)
			all.push_back(std::move(each));
	}
	int groups = 0;
	if (!all.empty())
		return all;
	for (const auto& [variable, name, type] : file.variables())
		if (file.text(variable, "cf_role") == "mesh_topology")
			throw Refusal(
			    fmt::format("nothing to slice: an unstructured mesh of the UGRID conventions ({}), which is not "
			                "read; save it as .vtu, for instance from ParaView",
			                name));
	if (!empty.empty() || !crowded.empty())
		throw Refusal("nothing to slice: " + (empty.empty() ? crowded : empty));
	if (nc_inq_grps(file.id(), &groups, nullptr) == NC_NOERR && groups > 0)
		throw Refusal("nothing to slice: no variable with three dimensions at its root; groups of netCDF-4 are not "
		              "read, ncks -G : takes them there");
	throw Refusal("nothing to slice: no variable with three dimensions, times and those of length 1 apart");
}

// The dimension of a variable along which it lies on the sides of another one's cells.
std::optional<std::string> staggeredSide(const Candidate& each, const Candidate& at_cells)
{
	std::optional<std::string> found;
	std::map<std::string, std::size_t> lengths;
	for (const std::size_t side : at_cells.space)
		lengths[at_cells.sides[side].first] = at_cells.sides[side].second;
	for (const std::size_t side : each.space)
	{
		const auto& [name, length] = each.sides[side];
		const auto cells = lengths.find(withoutStaggering(name));
		const bool is_between = isStaggered(name);
		if (cells == lengths.end() || length != cells->second + (is_between ? 1 : 0) || (is_between && found))
			return std::nullopt;
		if (is_between)
			found = name;
		lengths.erase(cells);
	}
	return lengths.empty() ? found : std::nullopt;
}

} // namespace

CfVolumes cfVolumes(const hdf5::NetcdfFile& file)
{
	CfVolumes volumes;
	Dimensions dimensions(file);
	const std::vector<Candidate> candidates = candidatesOf(file, dimensions, volumes.notes);
	const bool is_wrf = isWrf(file);
	const auto merit = [&](const Candidate& each)
	{
		const std::set<std::string> key = each.key();
		const bool is_at_cells = !is_wrf || std::ranges::none_of(key, isStaggered);
		return (cfTypeOf(file, each.variable) != 0 ? 4 : 0) + (is_at_cells ? 2 : 0) + (each.time ? 1 : 0);
	};
	const auto first = std::ranges::max_element(candidates, {}, merit);
	std::array<std::size_t, 3> slots = sidesInOrder(*first, dimensions);
	takePlaces(file, *first, volumes, slots);
	for (std::size_t axis = 0; axis < 3; ++axis)
		volumes.axes[axis] = dimensions.of(first->sides[slots[axis]].first, 0);
	if (first->time)
		volumes.time = dimensions.of(first->sides[*first->time].first, 0);

	std::set<std::string> told;
	for (const Candidate& each : candidates)
	{
		const bool has_other_time = each.time && volumes.time && each.sides[*each.time].first != volumes.time->name;
		const std::optional<std::string> staggered = is_wrf ? staggeredSide(each, *first) : std::nullopt;
		if ((each.key() != first->key() && !staggered) || has_other_time)
		{
			if (told.insert(each.words()).second)
				volumes.notes.push_back(fmt::format("variables over {} are left out; those over {} are read",
				                                    each.words(), first->words()));
		}
		else if (cfTypeOf(file, each.variable) == 0)
			volumes.notes.push_back(fmt::format("{} holds no numbers and is left out", each.name));
		else
		{
			CfVolume volume{each.variable, each.name, {}, each.time, {}};
			for (std::size_t axis = 0; axis < 3; ++axis)
				for (const std::size_t side : each.space)
					if (const std::string& name = each.sides[side].first;
					    name == volumes.axes[axis].name ||
					    (staggered == name && withoutStaggering(name) == volumes.axes[axis].name))
					{
						volume.sides[axis] = side;
						if (staggered == name)
							volume.staggered = axis;
					}
			volumes.all.push_back(std::move(volume));
		}
	}
	if (volumes.all.empty())
		throw Refusal(fmt::format("nothing to slice: {} holds no numbers", first->name));
	return volumes;
}

} // namespace vp::reader::volumes
