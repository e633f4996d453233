#include "hollow_cells.h"

#include "lattice_cells.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace vp::test
{

namespace
{

// Points at whole numbers, each once.
class Places
{
public:
	explicit Places(RawBlock& block) : block_(block) {}

	std::int64_t at(int x, int y, int z)
	{
		const Vec3 place(x, y, z);
		const auto found = std::ranges::find(block_.points, place);
		if (found != block_.points.end())
			return found - block_.points.begin();
		block_.points.push_back(place);
		return static_cast<std::int64_t>(block_.points.size()) - 1;
	}

private:
	RawBlock& block_;
};

// Every second face is turned round.
void addCell(RawBlock& block, std::vector<Ids> faces)
{
	for (std::size_t f = 0; f < faces.size(); f += 2)
		std::ranges::reverse(faces[f]);
	addPolyhedron(block, std::move(faces));
}

using Outline = std::vector<std::array<int, 2>>;

Ids layer(Places& places, const Outline& outline, int z)
{
	Ids ids;
	for (const auto& [x, y] : outline)
		ids.push_back(places.at(x, y, z));
	return ids;
}

void addSides(Places& places, const Outline& outline, int low, int high, std::vector<Ids>& faces)
{
	for (std::size_t i = 0; i < outline.size(); ++i)
	{
		const auto& [x, y] = outline[i];
		const auto& [to_x, to_y] = outline[(i + 1) % outline.size()];
		faces.push_back(
		    {places.at(x, y, low), places.at(to_x, to_y, low), places.at(to_x, to_y, high), places.at(x, y, high)});
	}
}

void addPrism(RawBlock& block, const Outline& outline, int low, int high)
{
	Places places(block);
	std::vector<Ids> faces{layer(places, outline, low), layer(places, outline, high)};
	addSides(places, outline, low, high, faces);
	addCell(block, std::move(faces));
}

const Outline kOuter{{0, 0}, {3, 0}, {3, 3}, {0, 3}};
const Outline kInner{{1, 1}, {2, 1}, {2, 2}, {1, 2}};

RawSet setOf(const char* name, RawBlock block)
{
	RawSet set{name, {std::move(block)}};
	set.flat_faces = true;
	return set;
}

} // namespace

RawSet ringCell(bool filled)
{
	RawBlock block;
	Places places(block);
	std::vector<Ids> faces;
	for (const int z : {0, 1})
	{
		const Ids outer = layer(places, kOuter, z);
		const Ids inner = layer(places, kInner, z);
		for (std::size_t i = 0; i < 4; ++i)
			faces.push_back({outer[i], outer[(i + 1) % 4], inner[(i + 1) % 4], inner[i]});
	}
	addSides(places, kOuter, 0, 1, faces);
	addSides(places, kInner, 0, 1, faces);
	addCell(block, std::move(faces));
	if (filled)
		addPrism(block, kInner, 0, 1);
	return setOf("ring", std::move(block));
}

RawSet shellCell(bool filled)
{
	RawBlock block;
	Places places(block);
	std::vector<Ids> faces{layer(places, kOuter, 0), layer(places, kOuter, 3), layer(places, kInner, 1),
	                       layer(places, kInner, 2)};
	addSides(places, kOuter, 0, 3, faces);
	addSides(places, kInner, 1, 2, faces);
	addCell(block, std::move(faces));
	if (filled)
		addPrism(block, kInner, 1, 2);
	return setOf("shell", std::move(block));
}

RawSet uCell(bool filled)
{
	RawBlock block;
	addPrism(block, {{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}, 0, 1);
	if (filled)
		addPrism(block, {{1, 1}, {2, 1}, {2, 3}, {1, 3}}, 0, 1);
	return setOf("u", std::move(block));
}

} // namespace vp::test
