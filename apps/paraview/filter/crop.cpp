#include "wrap_lattice.h"

#include <vtkDataSet.h>
#include <vtkImageData.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>

#include <algorithm>
#include <cstring>

namespace vprobe_paraview
{

namespace
{

using Sizes = std::array<std::size_t, 3>;

std::size_t bytesOf(vprobe::NumberType type)
{
	constexpr std::array<std::size_t, 10> kBytes{1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
	return kBytes[static_cast<std::size_t>(type)];
}

// The tuples of a box of a lattice, row by row.
vprobe::Numbers copied(const vprobe::Numbers& numbers, std::size_t components, const Sizes& whole, const Sizes& low,
                       const Sizes& size)
{
	const std::size_t tuple = components * bytesOf(numbers.type), row = size[0] * tuple;
	auto part = std::make_shared<std::vector<std::byte>>(size[2] * size[1] * row);
	const auto* from = static_cast<const std::byte*>(numbers.data);
	std::byte* to = part->data();
	for (std::size_t k = low[2]; k < low[2] + size[2]; ++k)
		for (std::size_t j = low[1]; j < low[1] + size[1]; ++j, to += row)
			std::memcpy(to, from + ((k * whole[1] + j) * whole[0] + low[0]) * tuple, row);
	const std::size_t count = size[0] * size[1] * size[2] * components;
	return {part->data(), count, numbers.type, part};
}

Sizes lessOne(const Sizes& points)
{
	return {points[0] - 1, points[1] - 1, points[2] - 1};
}

} // namespace

vprobe::Numbers Crop::ofPoints(const vprobe::Numbers& numbers, std::size_t components) const
{
	return copied(numbers, components, whole, low, points);
}

vprobe::Numbers Crop::ofCells(const vprobe::Numbers& numbers, std::size_t components) const
{
	return copied(numbers, components, lessOne(whole), low, lessOne(points));
}

std::int64_t Crop::sourceCell(std::int64_t cell) const
{
	const Sizes cells = lessOne(whole), own = lessOne(points);
	const auto number = static_cast<std::size_t>(cell);
	const std::size_t i = number % own[0], j = number / own[0] % own[1], k = number / own[0] / own[1];
	return static_cast<std::int64_t>(((k + low[2]) * cells[1] + j + low[1]) * cells[0] + i + low[0]);
}

std::optional<Crop> cropOf(vtkDataSet& data)
{
	std::array<int, 3> lattice{};
	if (!dimensionsOf(data, lattice.data()) || *std::ranges::min_element(lattice) < 2)
		return std::nullopt;
	const auto hidden = hiddenCells(data, lattice.data());
	if (!hidden)
		return std::nullopt;
	Crop crop;
	std::copy(lattice.begin(), lattice.end(), crop.whole.begin());
	Sizes low = crop.whole, high{};
	const Sizes cells = lessOne(crop.whole);
	std::size_t shown = 0, cell = 0;
	for (std::size_t k = 0; k < cells[2]; ++k)
		for (std::size_t j = 0; j < cells[1]; ++j)
			for (std::size_t i = 0; i < cells[0]; ++i)
			{
				if ((*hidden)[cell++])
					continue;
				++shown;
				const Sizes at{i, j, k};
				for (std::size_t a = 0; a < 3; ++a)
				{
					low[a] = std::min(low[a], at[a]);
					high[a] = std::max(high[a], at[a] + 1);
				}
			}
	if (shown == 0 || shown != (high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]))
		return std::nullopt;
	crop.low = low;
	for (std::size_t a = 0; a < 3; ++a)
		crop.points[a] = high[a] - low[a] + 1;
	return crop;
}

} // namespace vprobe_paraview
