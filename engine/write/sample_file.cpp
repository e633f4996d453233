#include "write/sample_file.h"

#include "locate/place.h"
#include "write/atomic_file.h"
#include "write/csv_text.h"
#include "write/place_values.h"
#include "write/set_arrays.h"
#include "write/unique_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace vp::write
{

namespace
{

using grid::Association;
using locate::Place;

class SampleRows
{
public:
	SampleRows(const grid::BlockSet& blocks, std::span<const grid::FieldChoice> chosen)
	    : blocks_(blocks), point_arrays_(arraysOf(blocks, Association::point)),
	      cell_arrays_(arraysOf(blocks, Association::cell))
	{
		if (chosen.empty())
			return;
		keep(point_arrays_, Association::point, chosen);
		keep(cell_arrays_, Association::cell, chosen);
	}

	std::string header() const
	{
		UniqueNames names;
		std::string text;
		for (const char* name : {"x", "y", "z", "block", "cell"})
			fmt::format_to(std::back_inserter(text), "{}{}", text.empty() ? "" : ",", names.add(name));
		for (const std::vector<SetArray>* arrays : {&point_arrays_, &cell_arrays_})
			for (const SetArray& array : *arrays)
				for (int c = 0; c < array.components; ++c)
					text += ',' + quoted(names.add(componentName(array.name, array.components, c)));
		return text + '\n';
	}

	void add(std::string& text, const Vec3& point, const Place& place) const
	{
		fmt::format_to(std::back_inserter(text), "{},{},{}", point.x, point.y, point.z);
		if (place.found())
			std::visit([&](const auto& grid) { addValues(text, grid, place); }, blocks_.blocks[place.block].grid);
		else
		{
			text += ",,";
			for (const std::vector<SetArray>* arrays : {&point_arrays_, &cell_arrays_})
				for (const SetArray& array : *arrays)
					addNan(text, array.components);
		}
		text += '\n';
	}

private:
	static void keep(std::vector<SetArray>& arrays, Association association, std::span<const grid::FieldChoice> chosen)
	{
		std::erase_if(arrays,
		              [&](const SetArray& array)
		              {
			              return std::ranges::none_of(
			                  chosen, [&](const grid::FieldChoice& choice)
			                  { return choice.association == association && choice.name == array.name; });
		              });
	}

	static void addNan(std::string& text, int count)
	{
		for (int c = 0; c < count; ++c)
			text += ",nan";
	}

	template <grid::Grid G>
	void addValues(std::string& text, const G& grid, const Place& place) const
	{
		const std::size_t cell = grid.sourceCell(place.cell);
		fmt::format_to(std::back_inserter(text), ",{},{}", place.block,
		               grid::cellNumber(blocks_.blocks[place.block], place.cell));
		for (const SetArray& array : point_arrays_)
			addInterpolated(text, grid, array, place);
		for (const SetArray& array : cell_arrays_)
		{
			const grid::Field* field = array.per_block[place.block];
			if (field)
				appendNumbers(text, field->type, field->tuple(cell), field->components);
			addNan(text, array.components - (field ? field->components : 0));
		}
	}

	template <grid::Grid G>
	static void addInterpolated(std::string& text, const G& grid, const SetArray& array, const Place& place)
	{
		const grid::Field* field = array.per_block[place.block];
		for (int c = 0; field && c < field->components; ++c)
		{
			std::byte number[sizeof(double)];
			const grid::NumberType type = interpolatedType(array);
			grid::storeNumber(type, valueAt(grid, *field, c, place.weights), number);
			appendNumbers(text, type, number, 1);
		}
		addNan(text, array.components - (field ? field->components : 0));
	}

	const grid::BlockSet& blocks_;
	std::vector<SetArray> point_arrays_;
	std::vector<SetArray> cell_arrays_;
};

} // namespace

Result<std::size_t> writeSamples(const grid::BlockSet& blocks, std::span<const Vec3> points,
                                 std::span<const grid::FieldChoice> chosen, const std::string& path)
{
	Result<AtomicFile> file = AtomicFile::create(path);
	if (!file)
		return file.error();
	constexpr std::size_t kChunk = std::size_t(1) << 20; // written at a time
	const SampleRows rows(blocks, chosen);
	locate::PlaceFinder finder(blocks);
	std::string text = rows.header();
	std::size_t outside = 0;
	for (const Vec3& point : points)
	{
		const Place& place = finder.find(point);
		outside += !place.found();
		rows.add(text, point, place);
		if (text.size() > kChunk)
		{
			file->write(text);
			text.clear();
		}
	}
	file->write(text);
	if (Status written = file->commit(); !written)
		return written.error();
	return outside;
}

} // namespace vp::write
