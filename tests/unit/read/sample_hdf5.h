#pragma once

#include <hdf5.h>

#include <string>
#include <vector>

// Writes data sets and attributes by paths; groups on the way are made.
class SampleHdf5
{
public:
	explicit SampleHdf5(const std::string& path)
	    : file_(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)), links_(H5Pcreate(H5P_LINK_CREATE))
	{
		H5Pset_create_intermediate_group(links_, 1);
	}
	~SampleHdf5()
	{
		H5Pclose(links_);
		H5Fclose(file_);
	}

	void group(const std::string& path) { H5Gclose(H5Gcreate2(file_, path.c_str(), links_, H5P_DEFAULT, H5P_DEFAULT)); }
	// chunk: the sides of a chunk; none for values in one piece.
	void set(const std::string& path, const std::vector<hsize_t>& sides, hid_t type, const void* values,
	         const std::vector<hsize_t>& chunk = {})
	{
		const hid_t space = H5Screate_simple(static_cast<int>(sides.size()), sides.data(), nullptr);
		const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
		if (!chunk.empty())
			H5Pset_chunk(properties, static_cast<int>(chunk.size()), chunk.data());
		const hid_t made = H5Dcreate2(file_, path.c_str(), type, space, links_, properties, H5P_DEFAULT);
		H5Pclose(properties);
		H5Dwrite(made, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
		H5Dclose(made);
		H5Sclose(space);
	}
	void attribute(const std::string& object, const char* name, const std::vector<double>& values)
	{
		const hsize_t count = values.size();
		const hid_t space = H5Screate_simple(1, &count, nullptr);
		put(object, name, H5T_NATIVE_DOUBLE, space, values.data());
	}
	void attribute(const std::string& object, const char* name, const std::string& text)
	{
		const hid_t type = H5Tcopy(H5T_C_S1);
		H5Tset_size(type, text.size() + 1);
		put(object, name, type, H5Screate(H5S_SCALAR), text.c_str());
		H5Tclose(type);
	}

	// Texts, each in so many bytes.
	void texts(const std::string& path, const std::vector<hsize_t>& sides, std::size_t width,
	           const std::vector<std::string>& values)
	{
		std::string bytes;
		for (std::string value : values)
		{
			value.resize(width, ' ');
			bytes += value;
		}
		const hid_t type = H5Tcopy(H5T_C_S1);
		H5Tset_size(type, width);
		set(path, sides, type, bytes.data());
		H5Tclose(type);
	}

private:
	void put(const std::string& object, const char* name, hid_t type, hid_t space, const void* values)
	{
		const hid_t made =
		    H5Acreate_by_name(file_, object.c_str(), name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
		H5Awrite(made, type, values);
		H5Aclose(made);
		H5Sclose(space);
	}

	hid_t file_;
	hid_t links_;
};
