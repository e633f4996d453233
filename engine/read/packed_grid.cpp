#include "read/packed_grid.h"

#include "read/check_mesh.h"
#include "read/manifest_values.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace vp::read
{

using nlohmann::json;

Box PackedGrid::bounds() const
{
	Box all;
	for (const Box& part : parts)
		if (!part.empty())
			all.include(part);
	return all;
}

Result<PackedGrid> checkPackedGrid(std::string_view text, std::vector<std::array<double, 6>> boxes)
{
	try
	{
		const json about = parsedManifest(text);
		PackedGrid grid;
		grid.points = countOf(about.at("points"));
		grid.cells = countOf(about.at("cells"));
		for (const json& array : about.at("arrays"))
		{
			grid::Field& field = grid.fields.emplace_back();
			field.name = wordsOf(array.at("name"));
			field.association = associationOf(array.at("association"));
			field.components = componentsOf(array.at("components"), field.name);
			field.type = numberTypeOf(array.at("type").get<std::string>());
		}
		for (const auto& [x0, y0, z0, x1, y1, z1] : boxes)
			grid.parts.push_back({{x0, y0, z0}, {x1, y1, z1}});
		const auto isWrong = [](const Box& box) { return !box.empty() && !(std::isfinite(box.diagonal())); };
		if (grid.parts.empty() || std::ranges::any_of(grid.parts, isWrong))
			throw Unusable("the box of a part has no end");
		return grid;
	}
	catch (const Unusable& unusable)
	{
		return Error{ErrorKind::input, unusable.what()};
	}
	catch (const json::exception&)
	{
		return Error{ErrorKind::input, "what the reader tells of its parts cannot be read"};
	}
}

} // namespace vp::read
