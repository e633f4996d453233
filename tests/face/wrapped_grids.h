#pragma once

#include <gtest/gtest.h>

#include <vprobe/vprobe.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace face
{

// A box of hexahedra in each of the kinds that can be wrapped: n cells along each axis of [0, 1]^3, with the value
// x + 2 y + 3 z at points and the cell's number in cells. Its vectors are what is shared.
struct Box
{
	explicit Box(std::size_t n) : n(n)
	{
		for (std::size_t i = 0; i <= n; ++i)
			axis.push_back(static_cast<double>(i) / static_cast<double>(n));
		for (const double z : axis)
			for (const double y : axis)
				for (const double x : axis)
				{
					coordinates.insert(coordinates.end(), {x, y, z});
					value.push_back(x + 2.0 * y + 3.0 * z);
				}
		const auto id = [&](std::size_t i, std::size_t j, std::size_t k)
		{ return static_cast<std::int64_t>((k * (n + 1) + j) * (n + 1) + i); };
		offsets.push_back(0);
		for (std::size_t k = 0; k < n; ++k)
			for (std::size_t j = 0; j < n; ++j)
				for (std::size_t i = 0; i < n; ++i)
				{
					for (const std::size_t up : {std::size_t(0), std::size_t(1)})
						for (const auto& [a, b] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
							connectivity.push_back(
							    id(i + static_cast<std::size_t>(a), j + static_cast<std::size_t>(b), k + up));
					types.push_back(12);
					offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
					number.push_back(static_cast<std::int32_t>(number.size()));
				}
		narrow.assign(connectivity.begin(), connectivity.end());
		narrow_offsets.assign(offsets.begin(), offsets.end());
	}

	std::vector<vprobe::Field> fields() const
	{
		return {{"value", vprobe::Association::point, 1, value}, {"number", vprobe::Association::cell, 1, number}};
	}
	vprobe::Block image() const
	{
		const double step = 1.0 / static_cast<double>(n);
		return {vprobe::Image3{.points = {n + 1, n + 1, n + 1}, .spacing = {step, step, step}}, fields()};
	}
	vprobe::Block rectilinear() const { return {vprobe::Rectilinear{axis, axis, axis}, fields()}; }
	vprobe::Block structured() const { return {vprobe::Structured{{n + 1, n + 1, n + 1}, coordinates}, fields()}; }
	vprobe::Block unstructured(bool is_narrow = false) const
	{
		vprobe::Unstructured grid{coordinates, types, offsets, connectivity, {}, {}};
		if (is_narrow)
		{
			grid.offsets = narrow_offsets;
			grid.connectivity = narrow;
		}
		return {grid, fields()};
	}
	// Returns the same cells as polyhedra with six faces each.
	vprobe::Block polyhedra()
	{
		static constexpr int kFaces[6][4] = {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4},
		                                     {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}};
		face_offsets.assign(1, 0);
		stream.clear();
		for (std::size_t c = 0; c < types.size(); ++c)
		{
			stream.push_back(6);
			for (const auto& face : kFaces)
			{
				stream.push_back(4);
				for (const int v : face)
					stream.push_back(connectivity[8 * c + static_cast<std::size_t>(v)]);
			}
			face_offsets.push_back(static_cast<std::int64_t>(stream.size()));
		}
		polyhedron_types.assign(types.size(), 42);
		return {vprobe::Unstructured{coordinates, polyhedron_types, offsets, connectivity, face_offsets, stream},
		        fields()};
	}

	std::size_t n;
	std::vector<double> axis, coordinates, value;
	std::vector<std::int32_t> number, narrow, narrow_offsets;
	std::vector<std::int64_t> offsets, connectivity, face_offsets, stream;
	std::vector<std::uint8_t> types, polyhedron_types;
};

inline vprobe::View onWhite()
{
	vprobe::View view;
	view.size(320, 200).normal({0.3, 0.5, 0.8});
	EXPECT_TRUE(view.set("background", "white"));
	EXPECT_TRUE(view.set("samples", "2"));
	return view;
}

} // namespace face
