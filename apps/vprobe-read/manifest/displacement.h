#pragma once

#include <vtkSmartPointer.h>

#include <array>
#include <map>
#include <set>
#include <string>

class vtkDataArray;
class vtkDataSet;
class vtkPointSet;

namespace vp::reader::manifest
{

// Moves the points of data sets by an array of theirs: the one that is named, or one whose name says that it holds
// displacements.
class Displacement
{
public:
	Displacement() = default;
	// text: "FACTOR" or "FACTOR NAME"; empty for none. keeps_places: whether movePatch() is to come.
	Displacement(const std::string& text, bool keeps_places);

	bool isOn() const { return is_on_; }
	// The coordinates of the file are those of points that have moved.
	void areInCoordinates() { is_in_coordinates_ = true; }

	// Returns a data set with points that have moved: a lattice becomes a structured grid. Returns the same one if
	// there is nothing to move, or while a Pause lasts.
	vtkSmartPointer<vtkDataSet> moved(vtkDataSet* data);
	// Moves the points of a part of the boundary as those of the data sets at their places were moved.
	vtkSmartPointer<vtkPointSet> movedPatch(vtkPointSet* patch) const;

	// The note about it, if there is one to tell. Throws a Refusal if nothing could be moved.
	std::string note() const;

	class Pause
	{
	public:
		explicit Pause(Displacement& one) : one_(one) { ++one_.pauses_; }
		~Pause() { --one_.pauses_; }
		Pause(const Pause&) = delete;
		Pause& operator=(const Pause&) = delete;

	private:
		Displacement& one_;
	};

private:
	vtkDataArray* arrayOf(vtkDataSet* data);

	bool is_on_ = false;
	bool keeps_places_ = false;
	bool is_in_coordinates_ = false;
	double factor_ = 0.0;
	std::string name_;
	int pauses_ = 0;
	std::size_t seen_ = 0;
	std::size_t moved_ = 0;
	std::set<std::string> vectors_;    // names of vectors at points
	std::set<std::string> candidates_; // whose names say that they hold displacements
	std::map<std::array<double, 3>, std::array<double, 3>> places_;
};

} // namespace vp::reader::manifest
