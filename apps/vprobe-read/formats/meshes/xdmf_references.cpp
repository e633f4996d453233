// How an XDMF file takes over its own elements: by paths and by xi:include.
#include "vprobe-read/base/refusal.h"
#include "xdmf_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace vp::reader::meshes
{

namespace
{

constexpr int kMaxReferences = 8;

// "Name[3]" or "Name[@Name="x"]" of a path.
bool suits(const text::XmlElement& element, std::string_view step, int& skip)
{
	const auto bracket = step.find('[');
	if (element.name != step.substr(0, bracket))
		return false;
	if (bracket == step.npos)
		return true;
	const std::string_view inside = step.substr(bracket + 1, step.size() - bracket - 2);
	const auto quote = inside.find_first_of("\"'");
	if (inside.starts_with("@Name") && quote != inside.npos)
		return element.attribute("Name") == inside.substr(quote + 1, inside.size() - quote - 2);
	return --skip == 0;
}

// Writers choose the prefix of the namespace.
bool isInclude(const text::XmlElement& element)
{
	return element.name == "include" || element.name.ends_with(":include");
}

const text::XmlElement* gridNamed(const text::XmlElement& from, std::string_view name)
{
	for (const text::XmlElement& child : from.children)
	{
		if (child.name == "Grid" && child.attribute("Name") == name)
			return &child;
		if (const text::XmlElement* found = gridNamed(child, name))
			return found;
	}
	return nullptr;
}

} // namespace

const text::XmlElement* XdmfDocument::atPath(std::string_view path) const
{
	const text::XmlElement* at = nullptr;
	while (!path.empty())
	{
		path.remove_prefix(1); // the slash
		std::size_t end = 0;
		bool quoted = false;
		for (; end < path.size() && (quoted || path[end] != '/'); ++end)
			quoted ^= path[end] == '"' || path[end] == '\'';
		const std::string_view step = path.substr(0, end);
		path.remove_prefix(end);
		const auto bracket = step.find('[');
		int skip = bracket == step.npos ? 1 : std::max(1, std::atoi(std::string(step.substr(bracket + 1)).c_str()));
		if (!at)
		{
			if (!suits(xml_.root, step, skip))
				return nullptr;
			at = &xml_.root;
			continue;
		}
		const auto found =
		    std::ranges::find_if(at->children, [&](const text::XmlElement& e) { return suits(e, step, skip); });
		if (found == at->children.end())
			return nullptr;
		at = &*found;
	}
	return at;
}

const text::XmlElement& XdmfDocument::resolved(const text::XmlElement& element) const
{
	const text::XmlElement* at = &element;
	for (int i = 0; i < kMaxReferences; ++i)
	{
		const std::string_view reference = at->attribute("Reference");
		if (reference.empty())
			return *at;
		const std::string_view path = reference == "XML" ? contents(*at) : reference;
		const text::XmlElement* next = path.starts_with('/') ? atPath(path) : nullptr;
		if (!next)
			throw Refusal(fmt::format("the reference {} leads nowhere", path.substr(0, 80)));
		at = next;
	}
	throw damaged("its references lead in a circle");
}

// As dolfin and meshio write: xpointer(//Grid[@Name="mesh"]/Grid[1]/*[self::Topology or self::Geometry]).
const text::XmlElement* XdmfDocument::includedGrid(const text::XmlElement& include) const
{
	const std::string_view pointer = include.attribute("xpointer");
	constexpr std::string_view start = "//Grid[@Name=";
	const auto at = pointer.find(start);
	const auto quote = at == pointer.npos ? at : at + start.size();
	const auto end = quote >= pointer.size() ? pointer.npos : pointer.find(pointer[quote], quote + 1);
	if (end == pointer.npos)
		throw Refusal(fmt::format("the reference {} is not understood", pointer.substr(0, 80)));
	const text::XmlElement* grid = gridNamed(xml_.root, pointer.substr(quote + 1, end - quote - 1));
	if (const auto inner = pointer.find("]/Grid", end); grid && inner != pointer.npos)
		grid = child(*grid, "Grid");
	return grid;
}

void XdmfDocument::collectTakenOver(const text::XmlElement& from)
{
	for (const text::XmlElement& element : from.children)
		if (!isInclude(element))
			collectTakenOver(element);
		else if (const text::XmlElement* grid = includedGrid(element))
			taken_over_.insert(grid);
}

bool XdmfDocument::isTakenOver(const text::XmlElement& grid) const
{
	return taken_over_.contains(&grid);
}

std::vector<const text::XmlElement*> XdmfDocument::children(const text::XmlElement& of, std::string_view name) const
{
	std::vector<const text::XmlElement*> found;
	for (const text::XmlElement& element : of.children)
	{
		if (element.name == name)
			found.push_back(&resolved(element));
		else if (isInclude(element) && element.attribute("xpointer").find(name) != std::string_view::npos &&
		         name != "Grid")
			if (const text::XmlElement* grid = includedGrid(element); grid && grid != &of)
				for (const text::XmlElement& taken : grid->children)
					if (taken.name == name)
						found.push_back(&resolved(taken));
	}
	return found;
}

const text::XmlElement* XdmfDocument::child(const text::XmlElement& of, std::string_view name) const
{
	const auto found = children(of, name);
	return found.empty() ? nullptr : found.front();
}

} // namespace vp::reader::meshes
