#include "own_names.h"

#include "manifest_writer.h"

#include <vtkFieldData.h>

#include <fmt/format.h>

#include <functional>
#include <set>

namespace vp::reader::manifest
{

namespace
{

std::string freeName(const std::string& name, const std::function<bool(const std::string&)>& is_taken, Writer& manifest)
{
	if (!is_taken(name))
		return name;
	std::string own;
	for (int number = 2; own.empty() || is_taken(own); ++number)
		own = fmt::format("{} {}", name, number);
	manifest.warn(fmt::format("two arrays are called {}; the later one is shown as {}", name, own));
	return own;
}

} // namespace

std::string ownName(vtkFieldData* arrays, const std::string& name, Writer& manifest)
{
	return freeName(
	    name, [&](const std::string& other) { return arrays->HasArray(other.c_str()) != 0; }, manifest);
}

void makeOwnNames(std::vector<std::string>& names, Writer& manifest)
{
	const std::set<std::string> given(names.begin(), names.end());
	std::set<std::string> taken;
	for (std::string& name : names)
	{
		if (taken.contains(name))
			name = freeName(
			    name, [&](const std::string& other) { return given.contains(other) || taken.contains(other); },
			    manifest);
		taken.insert(name);
	}
}

} // namespace vp::reader::manifest
