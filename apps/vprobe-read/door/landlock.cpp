#include "landlock.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include <fcntl.h>
#include <link.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace vp::reader::door
{

namespace
{

// The numbers are part of the kernel's interface. Its headers may be older than the kernel that runs.
#ifndef SYS_landlock_create_ruleset
#define SYS_landlock_create_ruleset 444
#define SYS_landlock_add_rule 445
#define SYS_landlock_restrict_self 446
#endif

constexpr std::uint64_t kExecute = 1u << 0;
constexpr std::uint64_t kWriteFile = 1u << 1;
constexpr std::uint64_t kReadFile = 1u << 2;
constexpr std::uint64_t kReadFolder = 1u << 3;
constexpr std::uint64_t kMakeFile = 1u << 8;
constexpr std::uint64_t kTruncate = 1u << 14;
constexpr std::uint64_t kOfFiles = kExecute | kWriteFile | kReadFile | kTruncate; // the rest is for folders

// All that each version can refuse: of files, of ports, and of processes outside.
struct Refusable
{
	std::uint64_t files;
	std::uint64_t ports = 0;
	std::uint64_t others = 0; // sockets without a file, signals
};
static_assert(sizeof(Refusable) == 24);

constexpr std::array<Refusable, 6> kVersions = {
    Refusable{0x1FFF},          // Linux 5.13
    Refusable{0x3FFF},          // 5.19: links and renames from folder to folder
    Refusable{0x7FFF},          // 6.2: truncate
    Refusable{0x7FFF, 0x3},     // 6.7: TCP
    Refusable{0xFFFF, 0x3},     // 6.10: control of devices
    Refusable{0xFFFF, 0x3, 0x3} // 6.12
};

struct Rule
{
	std::uint64_t access;
	std::int32_t beneath;
} __attribute__((packed));
constexpr int kRuleOfPath = 1;
constexpr unsigned kAskVersion = 1;

class Ruleset
{
public:
	explicit Ruleset(int version) : refused_(kVersions[std::min<std::size_t>(version, kVersions.size()) - 1])
	{
		if (kSanitized)
			refused_.files &= ~kExecute;
		const std::size_t size = version < 4 ? 8 : version < 6 ? 16 : 24;
		set_ = static_cast<int>(syscall(SYS_landlock_create_ruleset, &refused_, size, 0));
	}
	~Ruleset()
	{
		if (set_ >= 0)
			close(set_);
	}
	Ruleset(const Ruleset&) = delete;
	Ruleset& operator=(const Ruleset&) = delete;

	void allow(const std::string& path, std::uint64_t access) const
	{
		const int place = open(path.c_str(), O_PATH | O_CLOEXEC);
		if (place < 0)
			return;
		struct stat about = {};
		const bool is_folder = fstat(place, &about) == 0 && S_ISDIR(about.st_mode);
		const Rule rule{access & refused_.files & (is_folder ? ~std::uint64_t(0) : kOfFiles), place};
		syscall(SYS_landlock_add_rule, set_, kRuleOfPath, &rule, 0);
		close(place);
	}

	bool hold() const { return set_ >= 0 && syscall(SYS_landlock_restrict_self, set_, 0) == 0; }

private:
	Refusable refused_;
	int set_ = -1;
};

// The program that loads this one and its libraries.
std::string loaderOfThis()
{
	std::string loader;
	dl_iterate_phdr(
	    [](dl_phdr_info* object, std::size_t, void* found)
	    {
		    for (int i = 0; i < object->dlpi_phnum; ++i)
			    if (object->dlpi_phdr[i].p_type == PT_INTERP)
				    *static_cast<std::string*>(found) =
				        reinterpret_cast<const char*>(object->dlpi_addr + object->dlpi_phdr[i].p_vaddr);
		    return 1; // the program itself comes first
	    },
	    &loader);
	return loader;
}

} // namespace

int holdByLandlock(const Opening& opening)
{
	const long version = syscall(SYS_landlock_create_ruleset, nullptr, 0, kAskVersion);
	if (version < 1)
		return 0;
	const Ruleset rules(static_cast<int>(version));
	for (const std::string& path : opening.read)
		rules.allow(path, kReadFile | kReadFolder);
	if (!opening.write.empty())
		rules.allow(opening.write, kReadFile | kReadFolder | kWriteFile | kMakeFile | kTruncate);
	if (!opening.execute.empty())
		for (const std::string& path : {opening.execute, loaderOfThis()})
			rules.allow(path, kReadFile | kExecute);
	return rules.hold() ? static_cast<int>(version) : 0;
}

} // namespace vp::reader::door
