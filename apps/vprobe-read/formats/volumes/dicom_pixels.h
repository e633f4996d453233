#pragma once

#include "dicom_form.h"

#include <gdcmReader.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace gdcm
{
class SequenceOfFragments;
}

namespace vp::reader::volumes
{

// The pixels of one file, unpacked frame by frame. Throws a Refusal for kinds that are not read, and where bytes are
// missing or do not unpack.
class DicomPixels
{
public:
	explicit DicomPixels(const std::string& file);

	DicomPixels(const DicomPixels&) = delete;
	DicomPixels& operator=(const DicomPixels&) = delete;

	const DicomPixelForm& form() const { return form_; }
	// One row after the other, samples fastest. The file's table has been applied, its slope not.
	std::vector<double> frame(std::size_t index);
	// How many of the values so far were padding.
	std::size_t padded() const { return padded_; }

private:
	void findPixels();
	void findFragments();
	std::string packedBytes(std::size_t index) const;
	bool isWhole(std::size_t index) const;
	std::string unpacked(std::size_t index) const;
	std::vector<double> storedValues(std::size_t index) const;

	std::string name_;
	gdcm::Reader reader_;
	DicomPixelForm form_;
	std::string_view plain_;                                    // the bytes of all frames, if they are not packed
	std::string swapped_;                                       // what it shows, where GDCM has not turned it round
	const gdcm::SequenceOfFragments* packed_ = nullptr;         // otherwise
	std::vector<std::pair<std::size_t, std::size_t>> of_frame_; // the fragments of each frame, first and past last
	std::size_t padded_ = 0;
};

} // namespace vp::reader::volumes
