#include "gmsh_mesh.h"

#include "gmsh_data.h"
#include "gmsh_elements.h"
#include "gmsh_entities.h"
#include "gmsh_twice.h"
#include "read/cell_types.h"
#include "vprobe-read/base/bytes.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/text/text_cursor.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

namespace vp::reader::meshes
{

namespace
{

using Tag = std::int64_t;

using Section = GmshSection;

class Parser
{
public:
	explicit Parser(std::string_view file) : at_(file) {}

	GmshMesh parse()
	{
		readFormat();
		while (!at_.atEnd())
		{
			const std::string name(at_.line());
			if (!name.starts_with('$'))
				throw damaged(fmt::format("\"{}\" where a section begins", name.substr(0, 20)));
			readSection(name);
			at_.skipPast((version_ < 2.0 ? "$END" : "$End") + name.substr(1));
		}
		const bool has_solid =
		    std::ranges::any_of(mesh_.types, [](std::uint8_t type) { return read::cellDimension(type) == 3; });
		if (!has_solid && !mesh_.unknown_types.empty())
			throw aboveSecondOrder();
		if (mesh_.coordinates.empty() || mesh_.tags.empty())
			throw damaged("it has no nodes or no elements");
		if (version_ < 4.0)
			joinGmshTwins(mesh_);
		fillMarks();
		return std::move(mesh_);
	}

private:
	// Names a type of solid elements, if there is one.
	Refusal aboveSecondOrder() const
	{
		int type = mesh_.unknown_types.rbegin()->first;
		for (const auto& [each, count] : mesh_.unknown_types)
			if (!gmshNameOf(each).empty())
				type = each;
		const std::string name = gmshNameOf(type).empty() ? "" : fmt::format(" ({})", gmshNameOf(type));
		return Refusal(fmt::format("nothing to slice: elements of Gmsh type {} are of an order above 2{}, which is not "
		                           "read; save it with order 1 or 2 (gmsh -order 2)",
		                           type, name));
	}

	void readFormat()
	{
		std::string first(at_.line());
		if (first == "$Comments")
		{
			at_.skipPast("$EndComments");
			at_.line(); // the rest of that
			first = at_.line();
		}
		if (first == "$NOD")
		{
			version_ = 1.0;
			at_.moveTo(0);
			return;
		}
		if (first != "$MeshFormat")
			throw damaged("it does not begin with $MeshFormat");
		version_ = at_.real();
		binary_ = at_.integer() == 1;
		const Tag width = at_.integer();
		at_.line();
		if (binary_)
		{
			const auto one = at_.binary<std::int32_t>();
			at_.setOrder(byteOrder(one == 0x01000000));
			if (one != 1 && one != 0x01000000)
				throw damaged("its byte order cannot be told");
		}
		const bool is_known = (version_ >= 2.0 && version_ < 3.0) || version_ == 4.0 || version_ == 4.1;
		narrow_ = width == 4 && version_ == 4.1;
		if (!is_known || (width != 8 && !narrow_))
			throw Refusal(
			    fmt::format("Gmsh format {} with numbers of {} bytes; save it as version 4.1 or 2.2", version_, width));
		at_.skipPast("$EndMeshFormat");
	}

	void readSection(const std::string& name)
	{
		Section section(at_, binary_, narrow_);
		const bool is_new = version_ >= 4.0;
		if (name == "$Nodes" || name == "$NOD")
			is_new ? readNodeBlocks(section) : readNodes(false);
		else if (name == "$ParametricNodes" && !is_new)
			readNodes(true);
		else if (name == "$Elements" || name == "$ELM")
			is_new ? readElementBlocks(section) : version_ < 2.0 ? readOldElements() : readElements();
		else if ((name == "$Entities" || name == "$PartitionedEntities") && is_new)
			readGmshEntities(section, version_ > 4.0, name == "$PartitionedEntities", entities_);
		else if (name == "$PhysicalNames")
			readNames();
		else if (name == "$NodeData" || name == "$ElementData")
			mesh_.data.push_back(readGmshData(at_, section, name == "$NodeData"));
		else if (name == "$ElementNodeData")
			mesh_.has_other_data = true;
	}

	// Lines of dimension, number and name in quotes, in binary files too.
	void readNames()
	{
		for (std::size_t left = at_.count(6); left > 0; --left)
		{
			const auto dimension = static_cast<int>(at_.integer());
			const auto number = static_cast<std::int32_t>(at_.integer());
			const std::string_view line = at_.line();
			const auto first = line.find('"'), last = line.rfind('"');
			if (first < last && last != line.npos)
				mesh_.group_names[{dimension, number}] = line.substr(first + 1, last - first - 1);
		}
	}

	void addNode(Tag tag, double x, double y, double z)
	{
		const auto point = static_cast<Tag>(mesh_.coordinates.size() / 3);
		const auto [known, is_new] = mesh_.point_of_tag.emplace(tag, point);
		if (!is_new)
		{
			// Some programs list a node with each of its entities.
			const double* first = &mesh_.coordinates[3 * static_cast<std::size_t>(known->second)];
			if (first[0] != x || first[1] != y || first[2] != z)
				throw damaged(fmt::format("node {} occurs twice, at different places", tag));
			return;
		}
		mesh_.coordinates.insert(mesh_.coordinates.end(), {x, y, z});
	}

	// Versions 1 and 2: the count is text in binary files too.
	void readNodes(bool parametric)
	{
		const std::size_t nodes = at_.count(7);
		at_.line();
		Section section(at_, binary_, narrow_);
		reserveNodes(nodes);
		for (std::size_t i = 0; i < nodes; ++i)
		{
			readNode(section);
			if (parametric)
				skipParameters(section);
		}
	}

	// The dimension and tag of an entity, and the place of the node on it.
	static void skipParameters(Section& section)
	{
		const Tag dimension = section.integer();
		section.integer();
		for (Tag u = 0; u < dimension && dimension < 3; ++u)
			section.real();
	}

	void readNode(Section& section)
	{
		const Tag tag = section.integer();
		const double x = section.real();
		const double y = section.real();
		addNode(tag, x, y, section.real());
	}

	void reserveNodes(std::size_t nodes)
	{
		mesh_.coordinates.reserve(3 * nodes);
		mesh_.point_of_tag.reserve(nodes);
	}

	void readNodeBlocks(Section& section)
	{
		const Tag blocks = section.size();
		reserveNodes(section.checked(section.size(), 7));
		if (version_ > 4.0)
			section.size(), section.size(); // the smallest and largest tag
		for (Tag block = 0; block < blocks; ++block)
		{
			const Tag first = section.integer();
			const Tag second = section.integer();
			const bool parametric = section.integer() != 0;
			const std::size_t nodes = section.checked(section.size(), 7);
			const Tag dimension = version_ > 4.0 ? first : second;
			if (dimension < 0 || dimension > 3)
				throw damaged("an entity without a dimension");
			if (version_ > 4.0)
				readTagsAndPlaces(section, nodes, parametric ? dimension : 0);
			else
				for (std::size_t i = 0; i < nodes; ++i)
				{
					readNode(section);
					for (Tag u = 0; parametric && u < dimension; ++u)
						section.real();
				}
		}
	}

	void readTagsAndPlaces(Section& section, std::size_t nodes, Tag parameters)
	{
		std::vector<Tag> tags(nodes);
		for (Tag& tag : tags)
			tag = section.size();
		for (const Tag tag : tags)
		{
			const double x = section.real();
			const double y = section.real();
			addNode(tag, x, y, section.real());
			for (Tag u = 0; u < parameters; ++u)
				section.real();
		}
	}

	GmshElement elementOf(Tag type)
	{
		const GmshElement element = gmshElement(type);
		if (element.nodes == 0)
			throw Refusal(fmt::format(
			    "elements of Gmsh type {}, which are not read; save it with order 1 or 2 (gmsh -order 2)", type));
		return element;
	}

	void addElement(Tag type, const GmshElement& element, Tag tag, Tag physical, Tag entity, Tag partition = 0)
	{
		if (element.corners == 0)
		{
			++mesh_.unknown_types[static_cast<int>(type)];
			return;
		}
		for (int corner = 0; corner < element.corners; ++corner)
		{
			const Tag node = nodes_[element.order.empty() ? static_cast<std::size_t>(corner)
			                                              : element.order[static_cast<std::size_t>(corner)]];
			const auto point = mesh_.point_of_tag.find(node);
			if (point == mesh_.point_of_tag.end())
				throw damaged(fmt::format("element {} has node {}, which is not there", tag, node));
			mesh_.corners.push_back(point->second);
		}
		mesh_.types.push_back(element.type);
		mesh_.offsets.push_back(static_cast<Tag>(mesh_.corners.size()));
		mesh_.tags.push_back(tag);
		mesh_.physical.push_back(static_cast<std::int32_t>(physical));
		mesh_.entity.push_back(static_cast<std::int32_t>(entity));
		if (partition != 0 || !mesh_.partition.empty())
		{
			mesh_.partition.resize(mesh_.types.size());
			mesh_.partition.back() = static_cast<std::int32_t>(partition);
		}
	}

	// Version 1: text, with the numbers of both entities and of nodes in front of the nodes.
	void readOldElements()
	{
		for (std::size_t left = at_.count(6); left > 0; --left)
		{
			const Tag tag = at_.integer();
			const Tag type = at_.integer();
			const GmshElement element = elementOf(type);
			const Tag physical = at_.integer();
			const Tag entity = at_.integer();
			if (at_.integer() != element.nodes)
				throw damaged(
				    fmt::format("element {} of type {} does not have its {} nodes", tag, type, element.nodes));
			for (int n = 0; n < element.nodes; ++n)
				nodes_[static_cast<std::size_t>(n)] = at_.integer();
			addElement(type, element, tag, physical, entity);
		}
	}

	// Version 2: elements with tags: the physical and the elementary entity, the number of partitions, and these; the
	// first of them owns the element. A binary file has them in runs of one type.
	void readElements()
	{
		const std::size_t elements = at_.count(4);
		at_.line();
		Section section(at_, binary_, narrow_);
		for (std::size_t done = 0; done < elements;)
		{
			Tag tag = binary_ ? 0 : section.integer();
			const Tag type = section.integer();
			const GmshElement element = elementOf(type);
			const std::size_t run = binary_ ? section.checked(section.integer(), 8) : 1;
			const std::size_t tag_count = section.checked(section.integer(), 2);
			if (run == 0 || run > elements - done)
				throw damaged("its elements are not as many as it says");
			for (std::size_t i = 0; i < run; ++i)
			{
				if (binary_)
					tag = section.integer();
				std::array<Tag, 4> tags = {};
				for (std::size_t t = 0; t < tag_count; ++t)
				{
					const Tag value = section.integer();
					if (t < tags.size())
						tags[t] = value;
				}
				for (int n = 0; n < element.nodes; ++n)
					nodes_[static_cast<std::size_t>(n)] = section.integer();
				addElement(type, element, tag, tags[0], tags[1], tags[2] > 0 ? tags[3] : 0);
			}
			done += run;
		}
	}

	void readElementBlocks(Section& section)
	{
		const Tag blocks = section.size();
		section.size();
		if (version_ > 4.0)
			section.size(), section.size();
		for (Tag block = 0; block < blocks; ++block)
		{
			const Tag first = section.integer();
			const Tag second = section.integer();
			const Tag dimension = version_ > 4.0 ? first : second;
			const Tag entity = version_ > 4.0 ? second : first;
			const Tag type = section.integer();
			const GmshElement element = elementOf(type);
			const std::size_t elements = section.checked(section.size(), 4);
			const std::vector<std::int32_t> groups = entities_.groupsOf(dimension, entity);
			const bool is_ghost = entities_.ghosts.contains(entity) && !entities_.of.contains({dimension, entity});
			for (std::size_t i = 0; i < elements; ++i)
			{
				const auto number = [&] { return version_ > 4.0 ? section.size() : section.integer(); };
				const Tag tag = number();
				for (int n = 0; n < element.nodes; ++n)
					nodes_[static_cast<std::size_t>(n)] = number();
				addElement(type, element, tag, groups.empty() ? 0 : groups[0], entities_.wholeOf(dimension, entity),
				           entities_.partitionOf(dimension, entity));
				if (element.corners == 0)
					continue;
				if (groups.size() > 1)
					mesh_.more_groups[static_cast<Tag>(mesh_.types.size()) - 1].assign(groups.begin() + 1,
					                                                                   groups.end());
				if (is_ghost || !mesh_.ghost.empty())
				{
					mesh_.ghost.resize(mesh_.types.size());
					mesh_.ghost.back() = is_ghost;
				}
			}
		}
	}

	void fillMarks()
	{
		if (!mesh_.partition.empty())
			mesh_.partition.resize(mesh_.types.size());
		if (!mesh_.ghost.empty())
			mesh_.ghost.resize(mesh_.types.size());
	}

	text::Cursor at_;
	GmshMesh mesh_;
	double version_ = 0.0;
	bool binary_ = false;
	bool narrow_ = false;
	std::array<Tag, 128> nodes_ = {}; // as many as any known type has
	GmshEntities entities_;
};

} // namespace

GmshMesh parseGmsh(std::string_view file)
{
	return Parser(file).parse();
}

} // namespace vp::reader::meshes
