#pragma once

#include "dicom_frames.h"
#include "dicom_item.h"

#include <optional>
#include <string>
#include <vector>

namespace vp::reader::volumes
{

// A frame's functional groups: its own come before those that it shares with others.
class FrameGroups
{
public:
	// The items have to live as long; null: there are none.
	FrameGroups(const DicomItem* own, const DicomItem* shared) : own_(own), shared_(shared) {}

	std::optional<DicomItem> group(const gdcm::Tag& sequence) const;

private:
	const DicomItem* own_;
	const DicomItem* shared_;
};

// A dimension of the frames that is neither a place nor a stack; these are looked at by themselves.
struct DicomDimension
{
	std::size_t position; // in the values of each frame
	std::string name;
	bool is_time;
};
std::vector<DicomDimension> dimensionsOf(const DicomItem& root);

// Adds the keys that tell a frame and its stack apart from others in its place, from its functional groups.
void addKeys(const std::vector<DicomDimension>& dimensions, const FrameGroups& groups, DicomFrame& frame);
// The same from the top of a file of one picture.
void addKeys(const DicomItem& root, DicomFrame& frame);

} // namespace vp::reader::volumes
