#include "grid/demo/demo_points.h"

#include "base/parallel_for.h"

#include <cmath>
#include <numbers>

namespace vp::grid::demo
{

std::vector<Field> fieldsAt(const Filled<float>& xyz)
{
	const std::size_t count = xyz.size / 3;
	const FieldsOfPoints fields(count);
	parallelFor(tbb::blocked_range<std::size_t>(0, count, 4096),
	            [&](const tbb::blocked_range<std::size_t>& range)
	            {
		            for (std::size_t p = range.begin(); p < range.end(); ++p)
		            {
			            const Vec3 at(xyz[3 * p], xyz[3 * p + 1], xyz[3 * p + 2]);
			            fields.set(p, std::sin(3.0 * at.x), std::cos(2.0 * at.y), at);
		            }
	            });
	return fields.fields();
}

Filled<float> shellPoints(int n)
{
	const LatticePoints points(n);
	std::vector<double> cos_lon(points.side);
	std::vector<double> sin_lon(points.side);
	std::vector<double> cos_lat(points.side);
	std::vector<double> sin_lat(points.side);
	for (std::size_t i = 0; i < points.side; ++i)
	{
		const double t = static_cast<double>(i) / n;
		cos_lon[i] = std::cos(std::numbers::pi * t);
		sin_lon[i] = std::sin(std::numbers::pi * t);
		cos_lat[i] = std::cos(std::numbers::pi * (-0.45 + 0.9 * t));
		sin_lat[i] = std::sin(std::numbers::pi * (-0.45 + 0.9 * t));
	}
	Filled<float> xyz(3 * points.count());
	forRows(points.side,
	        [&](std::size_t j, std::size_t k)
	        {
		        float* row = &xyz[3 * points(0, j, k)];
		        for (std::size_t i = 0; i < points.side; ++i, row += 3)
		        {
			        const double r = 1.0 + 2.0 * static_cast<double>(i) / n;
			        row[0] = static_cast<float>(r * cos_lat[k] * cos_lon[j]);
			        row[1] = static_cast<float>(r * cos_lat[k] * sin_lon[j]);
			        row[2] = static_cast<float>(r * sin_lat[k]);
		        }
	        });
	return xyz;
}

Filled<float> layerPoints(int n)
{
	constexpr double kHalfChord = 1.0;
	constexpr double kHalfThickness = 0.12;
	constexpr double kSpan = 2.0;
	constexpr double kSweep = 0.3;     // shift of x per unit of the span
	constexpr double kFlattest = 1e-4; // height of a cell at the wall as a part of its length; 1 at the outside
	const LatticePoints points(n);
	const double length = 2.0 * kHalfChord / n; // length of a cell along the chord
	std::vector<double> height{0.0};            // heights of a column's points above the wall
	for (int j = 0; j < n; ++j)
		height.push_back(height.back() +
		                 length * std::pow(kFlattest, n > 1 ? 1.0 - static_cast<double>(j) / (n - 1) : 0.0));
	Filled<float> xyz(3 * points.count());
	forRows(points.side,
	        [&](std::size_t j, std::size_t k)
	        {
		        float* row = &xyz[3 * points(0, j, k)];
		        const double z = kSpan * static_cast<double>(k) / n;
		        for (std::size_t i = 0; i < points.side; ++i, row += 3)
		        {
			        // Half an ellipse, and the normal there.
			        const double angle = std::numbers::pi * (1.0 - static_cast<double>(i) / n);
			        const double x = kHalfChord * std::cos(angle);
			        const double y = kHalfThickness * std::sin(angle);
			        const double across = x / (kHalfChord * kHalfChord);
			        const double up = y / (kHalfThickness * kHalfThickness);
			        const double away = height[j] / std::hypot(across, up);
			        row[0] = static_cast<float>(x + away * across + kSweep * z);
			        row[1] = static_cast<float>(y + away * up);
			        row[2] = static_cast<float>(z);
		        }
	        });
	return xyz;
}

} // namespace vp::grid::demo
