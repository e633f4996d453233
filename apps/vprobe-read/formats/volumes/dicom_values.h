#pragma once

#include "grid/field.h"

#include <vector>

namespace vp::reader::volumes
{

struct DicomPixelForm;

// Finds the type that holds the rescaled values of every frame without loss: an integer where all slopes and intercepts
// are integers, else float where it is exact, else double.
class DicomValueType
{
public:
	void add(const DicomPixelForm& form, double slope, double intercept);
	grid::NumberType type() const;

private:
	double low_ = 0.0;
	double high_ = 0.0;
	unsigned bits_ = 8; // as many as the stored values have, at least
	bool is_empty_ = true;
	bool is_integer_ = true;
	bool is_float_ = true; // whether float32 is exact
	bool is_signed_ = false;
};

// Writes slope * value + intercept, each as one of that type.
void rescale(const std::vector<double>& values, double slope, double intercept, grid::NumberType type, char* to);

} // namespace vp::reader::volumes
