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

// The points of a grid and those added to it, with their arrays. A point in the middle of an edge or a face is known by
// the points about it, so that cells on both sides share it. New values are weighted sums in double, and so polynomials
// of the cell's degree come out exact. Arrays keep their type: integers are rounded to the nearest, within the range of
// their component.
class NewNodes
{
public:
	using Ranges = std::vector<std::pair<double, double>>; // per component

	explicit NewNodes(vtkUnstructuredGrid* grid);

	// The cell of the file whose nodes the next ones are interpolated from.
	void enterCell(vtkIdList* points);

	// The node between 2 to 4 others, ascending, or one of the cell's own inside it (more). `weights` gives the shape
	// functions at the new node where it is needed.
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

	// Moves a point of the file to where the shape functions put it, and its values with it: a Bézier cell's points are
	// handles, not places.
	void place(vtkIdType point, std::span<const double> weights);

	vp::Vec3 at(vtkIdType point) const;
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
		Ranges range; // of integers

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
	std::vector<double> cell_values_; // of the cell's nodes
	std::vector<double> sum_;
	std::unordered_map<Key, vtkIdType, Hash> between_;
};
