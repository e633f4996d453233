#include "plain_xml.h"

#include "vprobe-read/base/is_one_of.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/formats/vtk/piece_checks.h"
#include "vprobe-read/manifest/time_choice.h"
#include "vprobe-read/quick/xml_copy.h"
#include "vprobe-read/text/text_cursor.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iterator>
#include <map>
#include <optional>
#include <set>

namespace vp::reader::vtk
{

namespace fs = std::filesystem;

namespace
{

// Nobody writes more steps into one such file.
constexpr std::size_t kMaxSteps = 1 << 20;

// The names of the times stand here, if anywhere.
constexpr std::size_t kHeadBytesOfTimes = 1 << 16;

std::vector<double> stepValues(std::string_view text)
{
	std::vector<double> numbers;
	for (text::Cursor at(text); !at.atEnd();)
	{
		numbers.push_back(at.real());
		if (numbers.size() > kMaxSteps)
			throw damaged("it names more times than there can be");
	}
	return numbers;
}

// The steps that an array says it belongs to; none: to all of them.
std::set<std::size_t> timeStepsOf(const text::XmlElement& array)
{
	std::set<std::size_t> steps;
	for (const double step : stepValues(array.attribute("TimeStep")))
		if (step >= 0.0 && step < static_cast<double>(kMaxSteps))
			steps.insert(static_cast<std::size_t>(step));
	return steps;
}

void collectTimeSteps(const text::XmlElement& element, std::set<std::size_t>& steps)
{
	if (element.has("TimeStep"))
		steps.merge(timeStepsOf(element));
	for (const text::XmlElement& child : element.children)
		collectTimeSteps(child, steps);
}

std::string* attributeOf(text::XmlElement& element, std::string_view name)
{
	const auto found = std::ranges::find(element.attributes, name, [](const auto& each) { return each.first; });
	return found == element.attributes.end() ? nullptr : &found->second;
}

// VTK's writer gives an axis that has not changed an empty offset: its data are those of the step before.
void fillOffsets(text::XmlElement& element)
{
	std::map<std::string_view, std::string> last;
	for (text::XmlElement& child : element.children)
		if (std::string* offset = attributeOf(child, "offset"); offset && child.has("TimeStep"))
		{
			std::string& before = last[child.attribute("Name")];
			if (offset->empty())
				*offset = before;
			before = *offset;
		}
}

// Leaves out what belongs to other steps, and the marks of steps.
void keepStep(text::XmlElement& element, std::size_t step)
{
	fillOffsets(element);
	std::erase_if(element.attributes, [](const auto& each) { return each.first == "TimeStep"; });
	std::erase_if(element.children, [&](const text::XmlElement& child)
	              { return child.has("TimeStep") && !timeStepsOf(child).contains(step); });
	for (text::XmlElement& child : element.children)
		keepStep(child, step);
}

bool isPieceElement(const text::XmlElement& element)
{
	return element.name == "Piece";
}

// A piece of a lattice gives its subscripts, another one its number of points.
bool hasNoPoints(const text::XmlElement& piece)
{
	if (piece.has("NumberOfPoints"))
	{
		const std::string_view text = piece.attribute("NumberOfPoints");
		return text::Cursor(text).integer() == 0;
	}
	if (!piece.has("Extent"))
		return false;
	const std::vector<double> extent = stepValues(piece.attribute("Extent"));
	if (extent.size() != 6)
		return false;
	return extent[1] < extent[0] || extent[3] < extent[2] || extent[5] < extent[4];
}

void collectOffsets(const text::XmlElement& element, std::set<std::uint64_t>& offsets)
{
	const std::string_view text = element.attribute("offset");
	std::uint64_t offset = 0;
	if (std::from_chars(text.data(), text.data() + text.size(), offset).ec == std::errc())
		offsets.insert(offset);
	for (const text::XmlElement& child : element.children)
		collectOffsets(child, offsets);
}

// VTK's readers would leave what happens to be in memory.
void refuseWithoutOffset(const text::XmlElement& element)
{
	const std::string_view offset = element.attribute("offset");
	if (element.attribute("format") == "appended" && offset.find_first_of("0123456789") == offset.npos)
		throw damaged(fmt::format("the array {} has no offset", element.attribute("Name")));
	for (const text::XmlElement& child : element.children)
		refuseWithoutOffset(child);
}

const text::XmlElement* dataElementOf(const text::XmlFile& xml)
{
	const auto found = std::ranges::find(xml.root.children, xml.root.attribute("type"), &text::XmlElement::name);
	return found == xml.root.children.end() ? nullptr : &*found;
}

text::XmlElement& dataElementOf(text::XmlFile& xml)
{
	return const_cast<text::XmlElement&>(*dataElementOf(std::as_const(xml)));
}

} // namespace

PlainXml::PlainXml(const Request& request) : request_(request), data_files_{request.file}
{
	const MappedText mapped(request.file);
	const std::optional<text::XmlFile> xml = text::parseXml(mapped.text());
	const text::XmlElement* data = xml ? dataElementOf(*xml) : nullptr;
	if (!data && mapped.text().substr(0, kHeadBytesOfTimes).find(" TimeValues=") != std::string_view::npos)
		throw Refusal("several times in a file of too many elements, or with a document type; write a file for each");
	has_unknown_text_ = !data && mapped.text().find("\"ascii\"") != std::string_view::npos;
	if (!data)
		return; // which VTK's parser has to tell about
	type_ = data->name;
	if (isOneOf(data->name,
	            {"ImageData", "RectilinearGrid", "StructuredGrid", "UnstructuredGrid", "PolyData", "HyperTreeGrid"}))
		takeData(*xml, mapped.text());
	else if (isOneOf(data->name, {"PImageData", "PRectilinearGrid", "PStructuredGrid", "PUnstructuredGrid"}))
		takeIndex(*xml, mapped.text());
}

void PlainXml::takeData(const text::XmlFile& given, std::string_view text)
{
	text::XmlFile xml = given;
	text::XmlElement& data = dataElementOf(xml);
	std::set<std::size_t> steps;
	collectTimeSteps(data, steps);
	const bool has_steps = !steps.empty() || data.has("TimeValues");
	if (has_steps)
		leaveOutOtherTimes(data);
	const auto left_out = std::erase_if(data.children, [](const text::XmlElement& element)
	                                    { return isPieceElement(element) && hasNoPoints(element); });
	is_empty_ = data.name != "HyperTreeGrid" && std::ranges::none_of(data.children, isPieceElement);
	refuseWithoutOffset(data);
	if (is_empty_)
		return;
	const std::vector<std::string> names = quick::giveOwnNames(data);
	quick::refuseOtherFields(data);
	const auto piece = std::ranges::find_if(data.children, isPieceElement);
	if (piece != data.children.end())
		fields_ = quick::fieldsOf(*piece);
	const bool is_respelled = quick::respellAttributes(data);
	const bool has_fewer_keys = quick::leaveOutStrangeKeys(data);
	warn(names);
	if (!copyNumbers(given, xml, text) &&
	    (has_steps || left_out > 0 || !names.empty() || is_respelled || has_fewer_keys))
		copy(given, xml, text);
}

void PlainXml::warn(const std::vector<std::string>& lines)
{
	for (const std::string& line : lines)
		if (std::ranges::find(warnings_, line) == warnings_.end())
			warnings_.push_back(line);
}

bool PlainXml::copyNumbers(const text::XmlFile& given, text::XmlFile& xml, std::string_view text)
{
	const std::vector<quick::XmlArray> arrays = quick::arraysOfXml(dataElementOf(xml));
	const auto isText = [](const quick::XmlArray& array) { return array.form == quick::XmlArray::Form::text; };
	const bool has_numbers = std::ranges::any_of(arrays, [&](const quick::XmlArray& a) { return isText(a) && a.type; });
	const bool has_text_alone = has_numbers && std::ranges::all_of(arrays, isText);
	if (!has_text_alone && quick::checkArrays(request_.file, given, arrays, text))
		return false;
	MemoryFile& file = newFile();
	quick::writeAsBytes(request_.file, given, xml, arrays, text, file);
	request_.file = file.path();
	data_files_ = {request_.file};
	return true;
}

// In text and inline, writers repeat all pieces for each time, with the step 0. What is appended has arrays for each.
void PlainXml::leaveOutOtherTimes(text::XmlElement& data)
{
	std::set<std::size_t> steps;
	collectTimeSteps(data, steps);
	const std::vector<double> values = stepValues(data.attribute("TimeValues"));
	const std::set<std::size_t> first = {0};
	if (values.empty() && !steps.empty() && steps != first)
		throw Refusal("arrays of several times, and no TimeValues that name them");
	times_ = manifest::inOrder(values);
	std::size_t step = 0;
	if (const std::optional<double> time = manifest::chooseIfAny(times_, request_))
		step = static_cast<std::size_t>(std::ranges::find(values, *time) - values.begin());
	request_.time = Request::Time::last;

	std::vector<text::XmlElement> pieces;
	if (values.size() > 1 && steps == first)
	{
		std::ranges::copy_if(data.children, std::back_inserter(pieces), isPieceElement);
		if (pieces.size() % values.size() != 0)
			throw Refusal(fmt::format("its {} pieces cannot be told apart by its {} times; write a file for each time",
			                          pieces.size(), values.size()));
		const std::size_t each = pieces.size() / values.size();
		std::erase_if(data.children, isPieceElement);
		for (std::size_t i = 0; i < each; ++i)
			data.children.push_back(std::move(pieces[step * each + i]));
		step = 0;
	}
	std::erase_if(data.attributes, [](const auto& each) { return each.first == "TimeValues"; });
	keepStep(data, step);
}

// Only what the elements name is taken from appended data, in its place: an array ends before the next one begins.
void PlainXml::copy(const text::XmlFile& given, const text::XmlFile& xml, std::string_view text)
{
	MemoryFile& file = newFile();
	quick::writeElements(xml, text, file);
	if (!xml.appended_encoding.empty())
	{
		std::set<std::uint64_t> wanted, all;
		collectOffsets(xml.root, wanted);
		collectOffsets(given.root, all);
		quick::writeAppendedStart(xml.appended_encoding, file);
		const std::uint64_t size = xml.appended_end - xml.appended_begin;
		const std::string_view bytes = text.substr(xml.appended_begin, size);
		std::uint64_t at = 0;
		for (const std::uint64_t offset : wanted)
		{
			if (offset > size)
				throw damaged(fmt::format("the array at offset {} runs past the end", offset));
			const auto behind = all.upper_bound(offset);
			const std::uint64_t end = behind == all.end() ? size : std::min(*behind, size);
			file.skip(offset - at);
			file.append(bytes.substr(offset, end - offset));
			at = end;
		}
		file.skip(size - at);
	}
	quick::writeEnd(xml, !xml.appended_encoding.empty(), file);
	request_.file = file.path();
	data_files_ = {request_.file};
}

void PlainXml::takeIndex(const text::XmlFile& given, std::string_view text)
{
	text::XmlFile xml = given;
	text::XmlElement& data = dataElementOf(xml);
	bool changes = false;
	data_files_.clear();
	std::vector<double> times;
	const std::vector<std::string> names = quick::giveOwnNames(data);
	const quick::Fields fields = quick::fieldsOf(data);
	if (std::ranges::any_of(data.children,
	                        [](const auto& each) { return isPieceElement(each) && !each.has("Source"); }))
		refusePieceWithoutFile();
	std::erase_if(data.children,
	              [&](text::XmlElement& piece)
	              {
		              if (!isPieceElement(piece))
			              return false;
		              Request of_piece = request_;
		              of_piece.file = (fs::absolute(request_.file).parent_path() / piece.attribute("Source")).string();
		              PlainXml plain(of_piece);
		              if (!plain.type_.empty())
			              refuseOtherKind(data.name, plain.type_, piece.attribute("Source"));
		              times.insert(times.end(), plain.times().begin(), plain.times().end());
		              warn(plain.warnings());
		              const bool is_empty = plain.isEmpty() || hasNoPoints(piece);
		              changes |= is_empty || plain.request().file != of_piece.file;
		              if (is_empty)
			              return true;
		              refuseMissingFields(fields, plain.fields_, piece.attribute("Source"));
		              for (auto& [name, value] : piece.attributes)
			              if (name == "Source")
				              value = plain.request().file;
		              data_files_.push_back(plain.request().file);
		              files_.splice(files_.end(), plain.files_);
		              return false;
	              });
	times_ = manifest::inOrder(std::move(times));
	is_empty_ = data_files_.empty();
	warn(names);
	changes |= !names.empty();
	changes |= quick::respellAttributes(data);
	if (is_empty_ || !changes)
		return;
	if (!times_.empty())
		request_.time = Request::Time::last;
	std::erase_if(data.attributes, [](const auto& each) { return each.first == "TimeValues"; });
	std::vector<std::string> files = std::move(data_files_);
	copy(given, xml, text);
	data_files_ = std::move(files);
}

} // namespace vp::reader::vtk
