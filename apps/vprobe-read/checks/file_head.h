#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace vp::reader::checks
{

// Holds what formats are recognized by: the first bytes of a file, its name, and the names in HDF5 and netCDF files.
class FileHead
{
public:
	explicit FileHead(const std::string& file);

	std::string_view text() const { return head_; }
	const std::string& file() const { return file_; }
	bool starts(std::string_view with) const { return text().starts_with(with); }
	bool has(std::string_view words) const { return text().find(words) != head_.npos; }
	bool at(std::size_t place, std::string_view bytes) const
	{
		return place < head_.size() && text().substr(place, bytes.size()) == bytes;
	}
	bool isBefore(std::string_view words, std::size_t place) const { return text().find(words) < place; }
	// Returns true if the file's name has one of these endings, which are in small letters.
	bool ends(std::initializer_list<std::string_view> endings) const;

	bool isText() const;
	bool isHdf5() const { return starts("\x89HDF\r\n"); }
	bool isNetcdf() const { return starts("CDF\1") || starts("CDF\2") || starts("CDF\5"); }
	bool isNifti() const;
	bool isFolder() const;
	bool holdsFile(const std::string& name) const; // a folder
	bool isOfSlices() const;                       // a folder or a pattern (slice_files.h)
	bool isTecplot() const;                        // text
	bool isUcd() const;                            // text
	bool isBinaryUcd() const;
	bool isFluent() const;
	bool isSlc() const;
	bool isSegy() const;
	bool isD3plot() const;
	bool isXmlOfVtk() const { return has("<VTKFile"); }
	bool namesFiles() const; // VTK XML that is an index of other files

	// Returns true if an HDF5 file has a group, data set or attribute of this name at its root, or if a netCDF file has
	// a dimension, variable or attribute of this name. Returns false for other files.
	bool holds(const std::string& name) const;
	bool holdsLike(const std::string& start) const; // a name that begins so

private:
	std::string file_;
	std::string name_; // in small letters, without folders
	std::string head_;
	mutable std::optional<std::set<std::string>> names_;
};

// Returns the names of everything at the root of an HDF5 file, or none if HDF5 cannot open it. Only vprobe-read-more
// has HDF5, so vprobe-read becomes that program.
std::set<std::string> hdf5Names(const std::string& file);

// Returns the value of type="..." in the VTKFile element. Empty if there is none.
std::string xmlTypeOf(std::string_view head);

} // namespace vp::reader::checks
