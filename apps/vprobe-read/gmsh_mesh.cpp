#include "gmsh_mesh.h"

#include "gmsh_elements.h"
#include "refusal.h"
#include "text_cursor.h"

#include <fmt/format.h>

#include <algorithm>

namespace
{

using Tag = std::int64_t;

// Numbers of one section, in text or binary.
class Section
{
public:
	// `narrow`: where the program that wrote the file counts in 32 bits.
	Section(TextCursor& at, bool binary, bool narrow) : at_(at), binary_(binary), narrow_(narrow) {}

	// 32 bits in a binary file.
	Tag integer() { return binary_ ? at_.binary<std::int32_t>() : at_.integer(); }
	// 64 bits, mostly.
	Tag size() { return !binary_ ? at_.integer() : narrow_ ? at_.binary<std::uint32_t>() : at_.binary<std::int64_t>(); }
	double real() { return binary_ ? at_.binary<double>() : at_.real(); }
	std::size_t checked(Tag count, std::size_t least_bytes) const { return at_.checkedCount(count, least_bytes); }
	bool binary() const { return binary_; }

private:
	TextCursor& at_;
	bool binary_;
	bool narrow_;
};

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
			at_.skipPast("$End" + name.substr(1));
		}
		const bool has_solid =
		    std::ranges::any_of(mesh_.types, [](std::uint8_t type) { return vp::read::cellDimension(type) == 3; });
		if (!has_solid && !mesh_.unknown_types.empty())
			throw Refusal(
			    fmt::format("nothing to slice: elements of Gmsh type {} are of an order above 2, which is not "
			                "read; save it with order 1 or 2 (gmsh -order 2)",
			                mesh_.unknown_types.rbegin()->first));
		if (mesh_.coordinates.empty() || mesh_.tags.empty())
			throw damaged("it has no nodes or no elements");
		return std::move(mesh_);
	}

private:
	void readFormat()
	{
		std::string first(at_.line());
		if (first == "$Comments")
		{
			at_.skipPast("$EndComments");
			at_.line(); // the rest of that
			first = at_.line();
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
			at_.setSwaps(one == 0x01000000);
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
		if (name == "$Nodes")
			is_new ? readNodeBlocks(section) : readNodes();
		else if (name == "$Elements")
			is_new ? readElementBlocks(section) : readElements();
		else if (name == "$Entities" && is_new)
			readEntities(section);
		else if (name == "$NodeData" || name == "$ElementData")
			readData(section, name == "$NodeData");
		else if (name == "$ElementNodeData")
			mesh_.has_other_data = true;
	}

	void addNode(Tag tag, double x, double y, double z)
	{
		const auto point = static_cast<Tag>(mesh_.coordinates.size() / 3);
		if (!mesh_.point_of_tag.emplace(tag, point).second)
			throw damaged(fmt::format("node {} occurs twice", tag));
		mesh_.coordinates.insert(mesh_.coordinates.end(), {x, y, z});
	}

	// Version 2: the count is text in binary files too.
	void readNodes()
	{
		const std::size_t nodes = at_.count(7);
		at_.line();
		Section section(at_, binary_, narrow_);
		reserveNodes(nodes);
		for (std::size_t i = 0; i < nodes; ++i)
			readNode(section);
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

	void addElement(Tag type, const GmshElement& element, Tag tag, Tag physical, Tag entity)
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
	}

	// Version 2: elements with tags, the first of which are the physical and the elementary entity. A binary file has
	// them in runs of one type.
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
				Tag physical = 0, entity = 0;
				for (std::size_t t = 0; t < tag_count; ++t)
				{
					const Tag value = section.integer();
					if (t < 2)
						(t == 0 ? physical : entity) = value;
				}
				for (int n = 0; n < element.nodes; ++n)
					nodes_[static_cast<std::size_t>(n)] = section.integer();
				addElement(type, element, tag, physical, entity);
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
			const auto physical = physical_of_.find({dimension, entity});
			for (std::size_t i = 0; i < elements; ++i)
			{
				const auto number = [&] { return version_ > 4.0 ? section.size() : section.integer(); };
				const Tag tag = number();
				for (int n = 0; n < element.nodes; ++n)
					nodes_[static_cast<std::size_t>(n)] = number();
				addElement(type, element, tag, physical == physical_of_.end() ? 0 : physical->second, entity);
			}
		}
	}

	// Which physical group an entity belongs to; of several, the first.
	void readEntities(Section& section)
	{
		std::array<std::size_t, 4> counts;
		for (std::size_t& count : counts)
			count = section.checked(section.size(), 8);
		for (std::size_t dimension = 0; dimension < 4; ++dimension)
			for (std::size_t i = 0; i < counts[dimension]; ++i)
			{
				const Tag tag = section.integer();
				const int places = dimension == 0 && version_ > 4.0 ? 3 : 6;
				for (int p = 0; p < places; ++p)
					section.real();
				const std::size_t groups = section.checked(section.size(), 2);
				for (std::size_t g = 0; g < groups; ++g)
				{
					const Tag group = section.integer();
					physical_of_.emplace(std::pair(static_cast<Tag>(dimension), tag), group);
				}
				if (dimension == 0)
					continue;
				const std::size_t boundaries = section.checked(section.size(), 2);
				for (std::size_t b = 0; b < boundaries; ++b)
					section.integer();
			}
	}

	// Its tags are text in binary files too.
	void readData(Section& section, bool of_nodes)
	{
		GmshData data;
		data.of_nodes = of_nodes;
		for (std::size_t left = at_.count(1); left > 0; --left)
		{
			at_.line(); // the rest of the line before
			std::string_view text = at_.peekLine();
			if (data.name.empty() && text.size() >= 2)
				data.name = text.substr(1, text.size() - 2);
			if (!at_.atEnd())
				at_.moveTo(at_.place() + text.size());
		}
		const std::size_t reals = at_.count(1);
		for (std::size_t i = 0; i < reals; ++i)
		{
			const double value = at_.real();
			if (i == 0)
				data.time = value;
		}
		std::array<Tag, 3> integers = {0, 1, 0};
		const std::size_t given = at_.count(1);
		for (std::size_t i = 0; i < given; ++i)
		{
			const Tag value = at_.integer();
			if (i < integers.size())
				integers[i] = value;
		}
		at_.line();
		if (given < 3 || (integers[1] != 1 && integers[1] != 3 && integers[1] != 9))
			throw damaged("its data are no scalars, vectors or tensors");
		data.step = integers[0];
		data.components = static_cast<int>(integers[1]);
		const std::size_t count = section.checked(integers[2], 2 + 2 * static_cast<std::size_t>(data.components));
		for (std::size_t i = 0; i < count; ++i)
		{
			data.tags.push_back(section.integer());
			for (int c = 0; c < data.components; ++c)
				data.values.push_back(section.real());
		}
		mesh_.data.push_back(std::move(data));
	}

	TextCursor at_;
	GmshMesh mesh_;
	double version_ = 0.0;
	bool binary_ = false;
	bool narrow_ = false;
	std::array<Tag, 64> nodes_ = {};
	std::map<std::pair<Tag, Tag>, Tag> physical_of_;
};

} // namespace

GmshMesh parseGmsh(std::string_view file)
{
	return Parser(file).parse();
}
