#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace vp::reader::volumes
{

class DicomItem;

// How a file stores the values of its pixels.
struct DicomPixelForm
{
	unsigned allocated = 0; // bits of each value
	unsigned stored = 0;    // those bits that belong to the value; others may hold overlays
	unsigned high_bit = 0;  // the highest of them
	unsigned samples = 1;   // 3 for colors
	bool is_signed = false;
	bool is_real = false;
	bool is_by_plane = false; // all reds come before all greens
	std::uint32_t columns = 0;
	std::uint32_t rows = 0;
	std::uint32_t frames = 1;
	// The meanings of stored values, from that of `table_first` on (ModalityLUTSequence); mostly null.
	std::shared_ptr<const std::vector<double>> table;
	double table_first = 0.0;
	// Stored values that stand for no part of the picture (PixelPaddingValue); none where the second is less.
	std::pair<double, double> padding{0.0, -1.0};

	std::size_t valuesOfFrame() const { return std::size_t(columns) * rows * samples; }
	// Returns the range of possible values, after the table and before rescaling. Not for real values.
	std::pair<double, double> range() const;
};

// root: the data set of a file, with or without its pixels. Throws a Refusal for kinds that are not read.
DicomPixelForm pixelFormOf(const DicomItem& root);

} // namespace vp::reader::volumes
