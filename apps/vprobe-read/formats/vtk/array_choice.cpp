#include "array_choice.h"

#include "vprobe-read/base/is_one_of.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/request.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/quick/quick_file.h"

#include <vtkDataArraySelection.h>
#include <vtkXMLReader.h>

namespace vp::reader::vtk
{

using nlohmann::json;

namespace
{

const text::XmlElement* childOf(const text::XmlElement& parent, std::string_view name)
{
	for (const text::XmlElement& child : parent.children)
		if (child.name == name)
			return &child;
	return nullptr;
}

// Nothing for strings and the like.
std::optional<quick::ArrayKind> kindOf(const text::XmlElement& array)
{
	try
	{
		// An index of pieces has no data, and so other names for the same.
		text::XmlElement plain = array;
		if (plain.name == "PDataArray")
			plain.name = "DataArray";
		return quick::ArrayKind(plain);
	}
	catch (const arrays::NotQuick&)
	{
		return std::nullopt;
	}
}

} // namespace

void leaveOutArrays(vtkXMLReader& reader, const Request& request, manifest::Writer& manifest)
{
	if (request.arrays.all)
		return;
	const MappedText mapped(request.file);
	const std::optional<text::XmlFile> xml = text::parseXml(mapped.text());
	const text::XmlElement* data = xml ? childOf(xml->root, xml->root.attribute("type")) : nullptr;
	if (!data)
		return;
	const bool is_index = data->name[0] == 'P' && data->name != "PolyData";
	const text::XmlElement* piece = is_index ? data : childOf(*data, "Piece");
	if (!piece)
		return;

	reader.UpdateInformation();
	bool has_shown = false;
	const auto choose = [&](const std::string& element, const char* association, vtkDataArraySelection* selection)
	{
		const text::XmlElement* arrays = childOf(*piece, is_index ? "P" + element : element);
		if (!arrays || !selection)
			return;
		for (const text::XmlElement& array : arrays->children)
		{
			const std::string name(array.attribute("Name"));
			const std::optional<quick::ArrayKind> kind = kindOf(array);
			if (!kind || isOneOf(name, {"", "vtkGhostType", "vtkGhostLevels"}))
				continue;
			const bool shapes_cells =
			    isOneOf(name, {"HigherOrderDegrees", "RationalWeights", arrays->attribute("HigherOrderDegrees"),
			                   arrays->attribute("RationalWeights")});
			if (!shapes_cells && !request.arrays.wants(association, name, !has_shown))
			{
				selection->DisableArray(name.c_str());
				manifest.noteLeftOut(
				    manifest::describeLeftOut(association, name, kind->type, static_cast<int>(kind->components)));
			}
			has_shown = true;
		}
	};
	choose("PointData", "point", reader.GetPointDataArraySelection());
	choose("CellData", "cell", reader.GetCellDataArraySelection());
}

} // namespace vp::reader::vtk
