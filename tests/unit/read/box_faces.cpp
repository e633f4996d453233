#include "box_faces.h"

#include "sample_bytes.h"

#include <algorithm>
#include <map>

using vp::Vec3;

std::vector<BoxFace> facesOfBox()
{
	constexpr std::array<std::array<int, 4>, 6> kInward = {
	    {{0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1}, {3, 2, 6, 7}, {0, 3, 7, 4}, {1, 5, 6, 2}}};
	std::map<std::array<int, 4>, BoxFace> faces;
	eachSampleCell(
	    [&](const Vec3&, const std::array<int, 8>& corners, int cell)
	    {
		    for (const auto& inward : kInward)
		    {
			    BoxFace face;
			    for (std::size_t i = 0; i < 4; ++i)
				    face.corners[i] = corners[static_cast<std::size_t>(inward[i])];
			    std::array<int, 4> key = face.corners;
			    std::sort(key.begin(), key.end());
			    BoxFace& known = faces.emplace(key, face).first->second;
			    known.cells[known.cells[0] < 0 ? 0 : 1] = cell;
		    }
	    });
	std::vector<BoxFace> all;
	for (const bool inside : {true, false})
		for (const auto& [key, face] : faces)
			if ((face.cells[1] >= 0) == inside)
				all.push_back(face);
	return all;
}
