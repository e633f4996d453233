#include "own_name.h"

#include "manifest_writer.h"

#include <vtkAbstractArray.h>
#include <vtkDataSetAttributes.h>

#include <fmt/format.h>

namespace vp::reader::manifest
{

void addUnderOwnName(vtkDataSetAttributes* fields, vtkAbstractArray* array, const char* association, Writer& manifest)
{
	const std::string given = array->GetName() ? array->GetName() : "";
	std::string own = given;
	for (int number = given.empty() ? 0 : 2; own.empty() || fields->HasArray(own.c_str()); ++number)
		own = fmt::format("{} {}", given.empty() ? "array" : given, number);
	if (given.empty())
		manifest.warn(fmt::format("a {} array without a name is called {}", association, own));
	else if (own != given)
		manifest.warn(
		    fmt::format("two {} arrays are called {}; the later one is shown as {}", association, given, own));
	array->SetName(own.c_str());
	fields->AddArray(array);
}

} // namespace vp::reader::manifest
