#pragma once

#include "base/vec.h"

#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

class vtkDataArray;
class vtkIdList;
class vtkPointData;
class vtkPoints;
class vtkUnstructuredGrid;

namespace vp::reader::cells
{

// Holds the points of a grid and the points added to it, with their arrays. A point in the middle of an edge or a face
// is identified by the points about it, so that cells on both sides share it. New values are weighted sums in double
// precision, so polynomials up to the cell's degree are exact. Arrays keep their type: integers are rounded to the
// nearest, within the range of their component.
class NewNodes
{
public:
	using Ranges = std::vector<std::pair<double, double>>; // per component

	explicit NewNodes(vtkUnstructuredGrid* grid);

	// Takes the cell of the file from whose nodes the next ones are interpolated.
	void enterCell(vtkIdList* points);

	// Returns the node between 2 to 4 others, which ascend. With more corners, the node lies inside the cell and is not
	// shared. `weights` returns the shape functions at the new node, and is called only if needed.
	template <class Weights>
	vtkIdType between(std::span<const vtkIdType> corners, Weights&& weights)
	{
		if (corners.size() > 4)
			return add(weights());
		const auto [known, is_new] = between_.try_emplace(keyOf(corners), 0);
		if (is_new)
			known->second = add(weights());
		return known->second;
	}

	// Moves a point of the file, with its values, to where the shape functions put it: the points of a Bézier cell are
	// control points, not places.
	void place(vtkIdType point, std::span<const double> weights);

	Vec3 at(vtkIdType point) const;
	std::size_t count() const;
	vtkPoints* points() const { return points_; }
	vtkPointData* data() const { return data_; }

private:
	using Key = std::array<vtkIdType, 4>;
	struct Hash
	{
		std::size_t operator()(const Key& key) const;
	};
	struct Values
	{
		vtkDataArray* given;
		vtkDataArray* grown;
		bool whole;   // integers
		Ranges range; // the range of integers

		double kept(double value, int component) const;
	};

	static Key keyOf(std::span<const vtkIdType> corners);
	void gather();
	const std::vector<double>& sum(std::span<const double> weights);
	vtkIdType add(std::span<const double> weights);

	vtkSmartPointer<vtkPoints> points_;
	vtkSmartPointer<vtkPointData> data_;
	vtkPoints* given_points_;
	std::vector<Values> arrays_;
	std::size_t width_ = 3; // numbers a node: coordinates and every component
	vtkIdList* cell_ = nullptr;
	bool gathered_ = false;
	std::vector<double> cell_values_; // the values at the cell's nodes
	std::vector<double> sum_;
	std::unordered_map<Key, vtkIdType, Hash> between_;
};

} // namespace vp::reader::cells
