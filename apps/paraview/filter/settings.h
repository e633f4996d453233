#pragma once

#include <vprobe/view.h>

#include <array>
#include <string>
#include <vector>

namespace vprobe_paraview
{

enum class Probe
{
	single,
	trihedral,
	paddlewheel,
	stack,
	file
};

enum class Surface
{
	plane,
	sphere,
	cylinder,
	cone,
	expression,
	iso
};

enum class Vectors
{
	none,
	tufts,
	lines
};

// What a user has set. The numbers of the enumerations are those of VolumeProbe.xml.
struct Settings
{
	Probe probe = Probe::single;
	std::string probe_text; // of a probe's file
	std::string probe_file; // its name
	vprobe::Vector3 origin{0.0, 0.0, 0.0};
	vprobe::Vector3 normal{0.0, 0.0, 1.0};
	vprobe::Vector3 up{0.0, 1.0, 0.0};
	int vanes = 4;
	int sheets = 5;
	std::vector<double> offsets{}; // along the normal; empty: in the middles of equal slabs of the bounds
	bool has_window = false;
	std::array<double, 2> window{1.0, 1.0};
	Surface surface = Surface::plane;
	double radius = 1.0;
	double angle = 30.0;
	std::string expression;
	bool expression_moves = true; // its coordinates are those of the plane
	double iso_value = 0.0;
	bool crinkle = false;
	bool has_threshold = false;
	std::array<double, 2> threshold{0.0, 1.0};
	std::string array; // "point:NAME" or "cell:NAME"; empty: the first
	int component = -1;
	bool has_contour_lines = false;
	std::vector<double> line_values{}; // of contour lines
	bool has_contours = false;
	std::vector<double> contours{}; // values of surfaces that grow from the sheets
	double contour_depth = 0.0;
	Vectors vectors = Vectors::none;
	std::string vector_array;
	int vector_lattice = 20;
	double vector_steps = 200.0;
	double vector_dt = 0.0; // 0: the fastest particle moves by a spacing of the lattice
	int vector_direction = 0;
	int threads = 0;

	bool growsContours() const { return has_contours && !contours.empty(); }
	bool drawsLines() const { return has_contour_lines && !line_values.empty(); }
	bool launches() const { return vectors != Vectors::none; }
	// The array decides what is cut, so it has to be there.
	bool needsArray() const { return has_threshold || growsContours() || surface == Surface::iso; }
	// Whether the output is more than one sheet.
	bool hasParts() const { return probe != Probe::single || drawsLines() || growsContours() || launches(); }
};

// What all ranks have together, where a setting follows from it.
struct Whole
{
	int ranks = 1;
	std::array<double, 6> bounds{}; // low x, high x, low y ...
	double fastest = 0.0;           // the length of the longest vector
};

// The library's settings. They are the same on all ranks: what the library would take from the grid that it knows, it
// is told here.
vprobe::Result<vprobe::View> viewOf(const Settings& settings, const Whole& whole);

} // namespace vprobe_paraview
