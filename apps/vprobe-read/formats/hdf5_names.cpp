#include "formats.h"
#include "vprobe-read/checks/file_head.h"

#include <hdf5.h>

namespace vp::reader
{

namespace
{

herr_t addLink(hid_t, const char* name, const H5L_info_t*, void* names)
{
	static_cast<std::set<std::string>*>(names)->insert(name);
	return 0;
}

herr_t addAttribute(hid_t, const char* name, const H5A_info_t*, void* names)
{
	static_cast<std::set<std::string>*>(names)->insert(name);
	return 0;
}

} // namespace

void formats::needHdf5(const Request&) {}

std::set<std::string> checks::hdf5Names(const std::string& file)
{
	std::set<std::string> names;
	H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); // it would print its own stack of errors
	const hid_t opened = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
	if (opened < 0)
		return names;
	H5Literate(opened, H5_INDEX_NAME, H5_ITER_INC, nullptr, addLink, &names);
	H5Aiterate2(opened, H5_INDEX_NAME, H5_ITER_INC, nullptr, addAttribute, &names);
	H5Fclose(opened);
	return names;
}

} // namespace vp::reader
