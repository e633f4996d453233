#include "opening.h"

#include "read/formats.h"

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <set>
#include <string_view>

#include <dlfcn.h>
#include <link.h>

namespace vp::reader::door
{

namespace fs = std::filesystem;

namespace
{

// The system's own folders of libraries. Others are found as the loader finds them.
constexpr const char* kOfTheSystem[] = {"/usr/lib",
                                        "/usr/lib64",
                                        "/lib",
                                        "/lib64",
                                        "/usr/local/lib",
                                        "/etc/ld.so.cache",
                                        "/etc/ld.so.preload",
                                        "/etc/localtime",
                                        "/usr/share/zoneinfo",
                                        "/usr/share/locale"};

using Places = std::set<std::string>;

void addFolderOf(const fs::path& file, Places& places)
{
	places.insert(file.has_parent_path() ? file.parent_path().string() : ".");
}

// Folders in which the loader has found libraries, and those in which it looks for others.
Places folderOfLibraries()
{
	Places folders(std::begin(kOfTheSystem), std::end(kOfTheSystem));
	dl_iterate_phdr(
	    [](dl_phdr_info* object, std::size_t, void* found)
	    {
		    if (object->dlpi_name && object->dlpi_name[0] == '/')
			    addFolderOf(object->dlpi_name, *static_cast<Places*>(found));
		    return 0;
	    },
	    &folders);
	void* const self = dlopen(nullptr, RTLD_LAZY);
	Dl_serinfo size = {};
	if (!self || dlinfo(self, RTLD_DI_SERINFOSIZE, &size) != 0)
		return folders;
	const auto memory = std::make_unique<char[]>(size.dls_size);
	auto* const search = reinterpret_cast<Dl_serinfo*>(memory.get());
	*search = size;
	if (dlinfo(self, RTLD_DI_SERINFO, search) == 0)
		for (unsigned i = 0; i < search->dls_cnt; ++i)
			if (const char* folder = search->dls_serpath[i].dls_name; folder && folder[0] == '/')
				folders.insert(folder);
	if (const char* plugins = std::getenv("HDF5_PLUGIN_PATH"); plugins && plugins[0] == '/')
		folders.insert(plugins);
	return folders;
}

// A file's format is only known once it is read. So all that its name may be are asked for what they name.
bool mayNameFiles(const Request& request)
{
	if (request.format.empty() && !request.raw.empty())
		return false;
	if (const read::Format* format = read::findFormat(request.format))
		return format->files != read::FormatFiles::alone;
	return read::mayNameFiles(request.file);
}

void addInput(const Request& request, Places& places)
{
	places.insert(request.slices.begin(), request.slices.end());
	std::error_code error;
	const bool takes_folder = !fs::is_directory(request.file, error) && mayNameFiles(request);
	const fs::path real = fs::canonical(request.file, error);
	if (!takes_folder)
		places.insert(request.file);
	else
		for (const fs::path& file : {fs::path(request.file), error ? fs::path(request.file) : real})
			addFolderOf(file, places);
}

} // namespace

std::string programWithMore()
{
	std::error_code error;
	const std::string self = fs::read_symlink("/proc/self/exe", error).string();
	return self.empty() || self.ends_with("-more") ? std::string() : self + "-more";
}

Opening openingFor(const Request& request)
{
	Places places = folderOfLibraries();
	addInput(request, places);
	if (!request.solution.empty())
		places.insert(request.solution);
	for (const std::string& folder : request.follow)
		places.insert(folder == "anywhere" ? "/" : folder);
	if (kSanitized)
		places.insert({"/proc", "/usr", "/sys", fs::path(programWithMore()).parent_path()});
	Opening opening;
	opening.read.assign(places.begin(), places.end());
	opening.write = request.convert_folder;
	opening.execute = programWithMore();
	return opening;
}

} // namespace vp::reader::door
