// EnSight 6 and Gold by parsers of our own: VTK's readers hang over several steps in a file, take the variables of
// other times, and go on where a file ends.
#include "ensight_case.h"
#include "ensight_geometry.h"
#include "ensight_grids.h"
#include "ensight_values.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/time_choice.h"
#include "vprobe-read/text/text_end.h"

#include <vtkCompositeDataSet.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace vp::reader::meshes
{

namespace
{

class EnSightReader
{
public:
	EnSightReader(const Request& request, manifest::Writer& manifest)
	    : request_(request), manifest_(manifest), about_(readEnSightCase(request.file)),
	      ends_inside_(text::endsInsideALine(request.file))
	{
	}

	void read()
	{
		chooseTime();
		readModel();
		for (const EnSightCase::Variable& variable : about_.variables)
			for (std::size_t i = 0; i < variable.files.names.size(); ++i)
				readVariable(variable, i, freeName(variable, i));
		tellNotes();
		vtkNew<vtkMultiBlockDataSet> blocks;
		unsigned int block = 0;
		for (const auto& [number, grid] : grids_)
		{
			const std::string& name = geometry_.parts.at(number).name;
			blocks->SetBlock(block, grid);
			blocks->GetMetaData(block++)->Set(vtkCompositeDataSet::NAME(),
			                                  name.empty() ? fmt::format("part {}", number) : name);
		}
		manifest_.add(blocks);
	}

private:
	void chooseTime()
	{
		const std::vector<double> times = timesOf(about_);
		if (!times.empty())
		{
			const std::size_t chosen = manifest::chooseStep(times, request_);
			const auto first = std::ranges::lower_bound(times, times[chosen]);
			time_ = {times[chosen], chosen - static_cast<std::size_t>(first - times.begin())};
		}
		else
			manifest::chooseIfAny(times, request_);
		manifest_.offerTimes(times);
	}

	// The step of the chosen time.
	std::size_t stepOf(const EnSightCase::Files& files, const std::string& name)
	{
		const EnSightCase::TimeSet* set = timeSetOf(about_, files);
		if (!set)
			return 0;
		bool is_before = false;
		const std::size_t step = stepAt(*set, time_, is_before);
		if (is_before)
			manifest_.warn(fmt::format("{} is shown at time {}, its first", name, set->times[step]));
		return step;
	}

	std::string pathOf(const std::string& name) const
	{
		const auto folder = std::filesystem::path(request_.file).parent_path();
		std::error_code none;
		std::string turned = name;
		std::ranges::replace(turned, '\\', '/');
		return (folder / (std::filesystem::exists(folder / name, none) ? name : turned)).string();
	}

	// Returns the bytes of a step. Files that hold one step alone are the same at all times.
	std::string_view bytesOf(const EnSightFile& file, const EnSightPlace& place, bool has_times) const
	{
		bool is_step = false;
		const std::string_view bytes = file.step(place.step, is_step);
		if (!is_step && place.has_steps)
			throw damaged(fmt::format("{} does not hold the steps of its file set", file.name()));
		bool more = false;
		if (is_step && !has_times && hasStep(file, place.step + 1, more))
			throw damaged(fmt::format("{} holds several steps, but the case gives it no time set", file.name()));
		return bytes;
	}

	static bool hasStep(const EnSightFile& file, std::size_t step, bool& is_step)
	{
		try
		{
			file.step(step, is_step);
			return true;
		}
		catch (const Refusal&)
		{
			return false;
		}
	}

	EnSightGeometry geometryAt(std::size_t step, bool may_lack_cells)
	{
		const EnSightPlace place = placeOf(about_, about_.model, 0, step);
		const std::string path = pathOf(place.file);
		const EnSightFile file(path);
		form_ = file.form();
		ends_inside_ |= form_ == EnSightFile::Form::text && text::endsInsideALine(path);
		const bool has_times = timeSetOf(about_, about_.model) != nullptr;
		return readEnSightGeometry(file, bytesOf(file, place, has_times), about_.is_gold, may_lack_cells);
	}

	void readModel()
	{
		const std::size_t step = stepOf(about_.model, "the geometry");
		const bool takes_cells = about_.changes_coordinates_only && step != about_.step_of_cells;
		geometry_ = geometryAt(step, takes_cells);
		if (takes_cells && (geometry_.parts.empty() || std::ranges::any_of(geometry_.parts, lacksCells)))
			takeEnSightCells(geometry_, geometryAt(about_.step_of_cells, false), about_.model.names[0]);
		grids_ = ensightGrids(geometry_, isBinary());
	}

	static bool lacksCells(const std::pair<const std::int64_t, EnSightPart>& part)
	{
		return part.second.kind == EnSightPart::Kind::unstructured && part.second.elements.empty();
	}

	bool isBinary() const { return form_ != EnSightFile::Form::text; }

	// Tells apart the two parts of a complex variable, and variables of one name.
	std::string freeName(const EnSightCase::Variable& variable, std::size_t part)
	{
		std::string name = variable.name;
		if (variable.files.names.size() > 1)
			name += part == 0 ? "_r" : "_i";
		const std::string first = name;
		for (int i = 2; !names_.emplace(variable.per_node, name).second; ++i)
			name = fmt::format("{} ({})", first, i);
		return name;
	}

	void readVariable(const EnSightCase::Variable& variable, std::size_t which, const std::string& name)
	{
		const EnSightPlace place = placeOf(about_, variable.files, which, stepOf(variable.files, name));
		const std::string path = pathOf(place.file);
		const EnSightFile file(path, form_);
		ends_inside_ |= !isBinary() && text::endsInsideALine(path);
		const bool has_times = timeSetOf(about_, variable.files) != nullptr;
		const EnSightValues values =
		    readEnSightValues(file, bytesOf(file, place, has_times), geometry_, variable.per_node, variable.components);
		for (const auto& [number, grid] : grids_)
			if (const auto own = values.find(number); own != values.end())
				addEnSightArray(grid, name, variable.per_node, variable.components, own->second, isBinary());
	}

	void tellNotes()
	{
		if (ends_inside_)
			manifest_.warn(text::kCutTextWarning);
		for (const std::string& note : about_.notes)
			manifest_.warn(note);
		if (!about_.left_out.empty())
			manifest_.warn(fmt::format("left out: {}", fmt::join(about_.left_out, ", ")));
		std::vector<std::string> constants;
		for (const EnSightCase::Constant& constant : about_.constants)
		{
			const auto set = constant.time_set ? about_.time_sets.find(*constant.time_set) : about_.time_sets.end();
			bool is_before = false;
			std::size_t step = 0;
			if (set != about_.time_sets.end() && !set->second.times.empty() && constant.values.size() > 1)
				step = stepAt(set->second, time_, is_before);
			if (step < constant.values.size())
				constants.push_back(fmt::format("{} = {}", constant.name, constant.values[step]));
		}
		if (!constants.empty())
			manifest_.warn(fmt::format("constants of the case are no arrays: {}", fmt::join(constants, ", ")));
	}

	const Request& request_;
	manifest::Writer& manifest_;
	EnSightCase about_;
	bool ends_inside_;
	EnSightTime time_;
	EnSightFile::Form form_ = EnSightFile::Form::text;
	EnSightGeometry geometry_;
	std::map<std::int64_t, vtkSmartPointer<vtkDataSet>> grids_;
	std::set<std::pair<bool, std::string>> names_;
};

} // namespace

void readEnSight(const Request& request, manifest::Writer& manifest)
{
	EnSightReader(request, manifest).read();
}

} // namespace vp::reader::meshes
