#pragma once

#include "vprobe-read/arrays/value_image.h"
#include "vprobe-read/base/bytes.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace vp::reader::volumes
{

// Reads the header of an MRC or CCP4 map (MRC2014, and IMOD's additions to it). The bytes must outlive it.
class MrcHeader
{
public:
	// Throws a Refusal where it is none, or of a kind that is not read.
	explicit MrcHeader(std::string_view file);

	// As the values of one volume lie in the file.
	const arrays::ValueLayout& layout() const { return layout_; }
	bool isHalf() const { return mode_ == 12; }    // floats of 16 bits
	bool isPacked() const { return mode_ == 101; } // two values of 4 bits in a byte, rows of whole bytes
	std::uint32_t volumes() const { return volumes_; }
	std::uint64_t bytesOfVolume() const;
	std::uint64_t valuesBegin() const { return values_begin_; }

	// The place of the first value, and the step along columns, rows and sections, in Å.
	struct Place
	{
		std::array<double, 3> origin;
		std::array<double, 3> spacing;
		std::array<double, 9> direction; // rows of a matrix; its columns are unit vectors
	};
	Place place() const;

private:
	template <class Number>
	Number number(std::size_t word) const;
	int integer(std::size_t word) const { return number<int>(word); }
	double real(std::size_t word) const { return number<float>(word); }
	void chooseOrder();
	void setType();
	void splitVolumes();
	bool hasOrderOfAxes() const;
	std::array<std::array<double, 3>, 3> cellAxes() const;

	std::string_view file_;
	ByteOrder order_ = ByteOrder::little;
	int mode_ = 0;
	bool by_imod_ = false;
	arrays::ValueLayout layout_;
	std::uint32_t volumes_ = 1;
	std::uint64_t values_begin_ = 0;
};

} // namespace vp::reader::volumes
