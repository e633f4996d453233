#include "parsers.h"

#include "probe/path_file.h"
#include "probe/probe_file.h"
#include "read/build_block.h"
#include "read/manifest.h"
#include "read/mapping.h"
#include "read/read.h"
#include "render/color/color_map_file.h"
#include "render/scene/camera.h"
#include "sample_files.h"
#include "surface/expression.h"
#include "surface/grid_index.h"
#include "view/settings.h"
#include "view/state_file.h"
#include "view/validate.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/checks/netcdf_size.h"
#include "vprobe-read/checks/xml_check.h"
#include "vprobe-read/formats/codes/foam_field.h"
#include "vprobe-read/formats/meshes/ensight_case.h"
#include "vprobe-read/formats/meshes/ensight_values.h"
#include "vprobe-read/formats/meshes/tecplot_file.h"
#include "vprobe-read/formats/volumes/meta_header.h"
#include "vprobe-read/formats/vtk/legacy_copy.h"
#include "vprobe-read/formats/wrapped/plot3d_layout.h"
#include "vprobe-read/formats/wrapped/plot3d_text.h"
#include "vprobe-read/quick/quick_xml.h"
#include "vprobe-read/quick/xml_arrays.h"
#include "vprobe-read/quick/xml_copy.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <sys/mman.h>

namespace
{

using namespace vp;
using namespace vp::reader;

void require(bool holds)
{
	if (!holds)
		std::abort();
}

// On the heap and no larger than it is, so that reading past its end shows.
read::SharedBytes shared(std::string_view bytes)
{
	const auto copy = std::make_shared<std::vector<std::byte>>(bytes.size());
	std::copy_n(reinterpret_cast<const std::byte*>(bytes.data()), bytes.size(), copy->begin());
	return {copy, {copy->data(), copy->size()}};
}

void feedManifest(std::string_view input)
{
	const std::size_t end = std::min(input.find('\0'), input.size());
	const std::string_view text = input.substr(0, end);
	std::string_view rest = input.substr(std::min(end + 1, input.size()));
	std::uint32_t array_bytes = 0;
	if (rest.size() >= 4)
	{
		std::memcpy(&array_bytes, rest.data(), 4);
		rest.remove_prefix(4);
	}
	const std::string_view arrays = rest.substr(0, array_bytes);
	const auto checked = read::checkManifest(text, shared(arrays), shared(rest.substr(arrays.size())));
	if (!checked)
		return require(!checked.error().message.empty() && checked.error().message.find('\n') == std::string::npos);
	grid::BlockSet set;
	for (read::CheckedBlock block : checked->blocks)
		set.blocks.push_back(read::buildBlock(std::move(block), "block"));
	grid::matchInterfaces(set);
	for (const grid::Block& block : set.blocks)
		require(std::isfinite(block.bounds.diagonal()));
}

void feedTime(std::string_view input)
{
	const auto time = read::parseTime(std::string(input));
	require(!time || std::isfinite(time->value));
}

void feedCamera(std::string_view input)
{
	const auto camera = render::parseCamera(input);
	require(!camera || std::isfinite(camera->direction.x));
}

void feedGridIndex(std::string_view input)
{
	const auto range = surface::parseGridIndex(std::string(input));
	require(!range ||
	        (range->axis >= 0 && range->axis < 3 && std::isfinite(range->first) && std::isfinite(range->last)));
}

void feedExpression(std::string_view input)
{
	const auto expression = surface::Expression::parse(std::string(input));
	if (!expression)
		return require(expression.error().message.starts_with("column ") &&
		               expression.error().message.find('\n') == std::string::npos);
	const Vec3 at(0.3, -1.2, 7.0);
	const double value = expression->value(at);
	double batch = 0.0;
	expression->values(&at.x, &at.y, &at.z, &batch, 1);
	require(batch == value || (std::isnan(batch) && std::isnan(value)));
	const surface::Interval all = expression->over({at - Vec3(0.5), at + Vec3(0.5)});
	require(all.contains(value) || (std::isnan(value) && !all.isBounded()));
	expression->gradient(at);
}

// A probe that was read, written and read again is the same.
void feedProbe(std::string_view input)
{
	const auto given = probe::parseProbe(input, "probe");
	if (!given)
		return require(given.error().message.find('\n') == std::string::npos);
	const auto again = probe::parseProbe(probe::probeText(given->probe), "again");
	require(again && again->probe == given->probe);
}

void feedPath(std::string_view input)
{
	const auto given = probe::parsePath(input, "path");
	if (!given)
		return require(given.error().message.find('\n') == std::string::npos);
	const auto again = probe::parsePath(probe::pathText(*given), "again");
	require(again && *again == *given);
}

void feedState(std::string_view input)
{
	view::ViewSpec given, again;
	if (const Status read = view::readState(given, input, "state.json"); !read)
		return require(read.error().message.find('\n') == std::string::npos && given == view::ViewSpec());
	require(static_cast<bool>(view::readState(again, view::stateText(given, "state.json"), "state.json")));
}

// A key and a value each line, carried out as the window does. What is accepted can be saved and read again.
void feedSettings(std::string_view input)
{
	view::ViewSpec spec;
	while (!input.empty())
	{
		const std::string_view line = input.substr(0, input.find('\n'));
		input.remove_prefix(std::min(line.size() + 1, input.size()));
		const std::size_t space = std::min(line.find(' '), line.size());
		view::ViewSpec next = spec;
		const Status set =
		    view::setByKey(next, line.substr(0, space), std::string(line.substr(std::min(space + 1, line.size()))));
		if (!set)
		{
			require(set.error().message.find('\n') == std::string::npos);
			continue;
		}
		if (const Status fits = view::validate(next); !fits)
			continue;
		spec = next;
		view::ViewSpec again;
		require(static_cast<bool>(view::readState(again, view::stateText(spec, "state.json"), "state.json")));
	}
}

void feedColorMap(std::string_view input)
{
	const auto given = render::parseColorMap(input, "maps.json");
	require(given || given.error().message.find('\n') == std::string::npos);
}

// EnSight keeps a case in several files: one of them is the input, the others are sound.
void feedEnSight(const TemporaryFolder& folder, char which, const std::string& input)
{
	const bool is_case = which == 'E';
	writeContents(folder / "a.case", is_case ? input
	                                         : "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: a.geo\nVARIABLE\n"
	                                           "scalar per node: f a.f\nvector per element: g a.f\n");
	writeContents(folder / "a.geo", which == 'G'
	                                    ? input
	                                    : "one\ntwo\nnode id off\nelement id off\npart\n1\nbox\ncoordinates\n1\n"
	                                      "0\n0\n0\npoint\n1\n1\n");
	writeContents(folder / "a.f", which == 'V' ? input : "f\npart\n1\ncoordinates\n1.5\n");
	const meshes::EnSightCase about = meshes::readEnSightCase(folder / "a.case");
	const meshes::EnSightFile geometry_file(folder / "a.geo");
	bool is_step = false;
	const meshes::EnSightGeometry geometry = meshes::readEnSightGeometry(geometry_file, geometry_file.step(0, is_step),
	                                                                     which == 'G' || about.is_gold, false);
	for (const auto& [number, part] : geometry.parts)
		for (const meshes::EnSightElements& elements : part.elements)
			for (const std::int64_t node : elements.nodes)
				require(node >= 0 && node < part.points());
	const meshes::EnSightFile values_file(folder / "a.f", geometry_file.form());
	for (const meshes::EnSightCase::Variable& variable : about.variables)
	{
		if (const meshes::EnSightCase::TimeSet* set = meshes::timeSetOf(about, variable.files))
		{
			bool is_before = false;
			meshes::placeOf(about, variable.files, 0, meshes::stepAt(*set, {0.5, 0}, is_before));
		}
		for (const auto& [number, values] : meshes::readEnSightValues(values_file, values_file.step(0, is_step),
		                                                              geometry, variable.per_node, variable.components))
			require(values.size() % static_cast<std::size_t>(variable.components) == 0);
	}
}

// Each kind of file, whatever the head says: all of them have one.
void feedFoam(std::string_view input)
{
	const auto tryIt = [](const auto& parse)
	{
		try
		{
			parse();
		}
		catch (const Refusal&)
		{
		}
	};
	tryIt([&] { codes::foamHead(input); });
	tryIt([&] { require(codes::foamPoints(input).numbers.size() % 3 == 0); });
	tryIt([&] { codes::foamLabels(input, 1000); });
	tryIt([&] { codes::foamPatches(input); });
	tryIt(
	    [&]
	    {
		    const codes::FoamFaces faces = codes::foamFaces(input);
		    require(static_cast<std::size_t>(faces.starts.back()) == faces.corners.size());
	    });
	tryIt(
	    [&]
	    {
		    // Every file that it includes is the same one.
		    const codes::FoamFiles files = {
		        "a", ".", [&](const std::filesystem::path& path) -> std::optional<codes::FoamSource> {
			        return path.filename() == "none" ? std::nullopt
			                                         : std::optional(codes::FoamSource{path, nullptr, input});
		        }};
		    const std::unique_ptr<codes::FoamDocument> document = codes::parseFoam(input, files);
		    const codes::FoamPatch patches[] = {{"a", "wall", {}, 0, 2}, {"inlet", "patch", {"e", "wall"}, 2, 1}};
		    const codes::FoamField field = codes::foamField(*document, 2, patches);
		    require(field.inside->fits(2) && field.patches.size() == 2);
		    for (std::size_t p = 0; p < 2; ++p)
			    if (const auto& values = field.patches[p].values)
				    require(values->fits(2 - p) && !values->numbers.empty());
	    });
}

void feedTecplot(std::string_view input)
{
	if (input.find('*') != std::string_view::npos)
		return; // values that are repeated take as much memory as they say
	try
	{
		for (const meshes::TecplotZone& zone : meshes::parseTecplot(input).zones)
			if (const auto& faces = zone.faces)
			{
				require(static_cast<std::size_t>(faces->starts.back()) == faces->corners.size());
				require(faces->left.size() + 1 == faces->starts.size() && faces->left.size() == faces->right.size());
			}
	}
	catch (const Refusal&)
	{
	}
}

void feedQuickly(const std::string& file)
{
	const read::Descriptor arrays(memfd_create("arrays", MFD_CLOEXEC));
	const read::Descriptor cells(memfd_create("cells", MFD_CLOEXEC));
	arrays::Writer array_writer(arrays.get());
	arrays::Writer cell_writer(cells.get());
	try
	{
		if (!quick::readQuickly(file, {}, 2, array_writer, cell_writer))
			require(array_writer.mark() == 0 && cell_writer.mark() == 0);
	}
	catch (const std::bad_alloc&)
	{
	}
}

// Text of VTK's XML files becomes bytes.
void feedXmlArrays(const std::string& file, const std::string& input)
{
	const std::optional<text::XmlFile> given = text::parseXml(input);
	if (!given)
		return;
	text::XmlFile xml = *given;
	for (text::XmlElement& data : xml.root.children)
		if (data.name == xml.root.attribute("type"))
		{
			quick::giveOwnNames(data);
			quick::respellAttributes(data);
			quick::leaveOutStrangeKeys(data);
			const std::vector<quick::XmlArray> arrays = quick::arraysOfXml(data);
			quick::checkArrays(file, *given, arrays, input);
			MemoryFile copy;
			quick::writeAsBytes(file, *given, xml, arrays, input, copy);
			return;
		}
}

void feedFile(char which, const std::string& input)
{
	static const TemporaryFolder folder;
	const std::string file = folder / "input";
	writeContents(file, input);
	try
	{
		switch (which)
		{
		case 'N':
			checks::netcdfSize(file);
			break;
		case 'P':
			if (const wrapped::Plot3dLayout layout = wrapped::findPlot3dLayout(file); layout.binary)
				wrapped::refuseShortSolution(file, layout);
			else
			{
				MemoryFile copy;
				wrapped::writeGridAsBytes(wrapped::fortranNumbers(input), layout, copy);
			}
			break;
		case 'L':
			vtk::copyLegacy(input);
			break;
		case 'H':
			volumes::metaBytes(file, volumes::readMetaHeader(file), 0);
			break;
		case 'X':
			checks::refuseShortXml(file);
			feedQuickly(file);
			feedXmlArrays(file, input);
			break;
		default:
			feedEnSight(folder, which, input);
			break;
		}
	}
	catch (const Refusal&)
	{
	}
}

} // namespace

void feedParser(const std::uint8_t* data, std::size_t size)
{
	if (size < 2)
		return;
	const std::string_view input(reinterpret_cast<const char*>(data) + 1, size - 1);
	const char which = static_cast<char>(data[0]);
	if (which == 'M')
		feedManifest(input);
	else if (which == 'T')
		feedTime(input);
	else if (which == 'C')
		feedCamera(input);
	else if (which == 'I')
		feedGridIndex(input);
	else if (which == 'S')
		feedExpression(input);
	else if (which == 'J')
		feedState(input);
	else if (which == 'B')
		feedProbe(input);
	else if (which == 'A')
		feedPath(input);
	else if (which == 'K')
		feedColorMap(input);
	else if (which == 'O')
		feedSettings(input);
	else if (which == 'F')
		feedFoam(input);
	else if (which == 'D')
		feedTecplot(input);
	else if (std::string_view("NPHXLEGV").find(which) != std::string_view::npos)
		feedFile(which, std::string(input));
}
