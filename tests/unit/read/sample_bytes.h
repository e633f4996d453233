#pragma once

#include "sample_files.h"

#include <string>

// The box of points that the samples of most formats hold, and bytes of numbers.

constexpr std::size_t kSamplePointCount = 5 * 4 * 6;
constexpr std::size_t kSampleCellCount = 4 * 3 * 5;

template <class Number>
void addBytes(std::string& bytes, Number number)
{
	bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

// Calls `use` with the place and the index of each point of a box.
template <class Use>
void eachSamplePoint(Use&& use)
{
	int index = 0;
	for (int k = 0; k < kSamplePoints[2]; ++k)
		for (int j = 0; j < kSamplePoints[1]; ++j)
			for (int i = 0; i < kSamplePoints[0]; ++i)
				use(vp::Vec3(i, j, k), index++);
}

// Calls `use` with the middle, the corners and the index of each hexahedron.
template <class Use>
void eachSampleCell(Use&& use)
{
	int index = 0;
	for (int k = 0; k + 1 < kSamplePoints[2]; ++k)
		for (int j = 0; j + 1 < kSamplePoints[1]; ++j)
			for (int i = 0; i + 1 < kSamplePoints[0]; ++i)
			{
				std::array<int, 8> corners = {0, 1, 6, 5, 20, 21, 26, 25};
				for (int& corner : corners)
					corner += i + 5 * j + 20 * k;
				use(vp::Vec3(i, j, k) + 0.5, corners, index++);
			}
}

template <class Number>
void addBigEndian(std::string& bytes, Number number)
{
	std::string little;
	addBytes(little, number);
	bytes.append(little.rbegin(), little.rend());
}
