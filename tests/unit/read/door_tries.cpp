// A reader for tests. It closes the program's own door, tries what no reader needs, and tells the parent what came of
// it: a line for each try, with its name and the error's number, 0 if it worked.
#include "read/protocol.h"
#include "read/reader_process.h"
#include "read/ready_reader.h"
#include "vprobe-read/door/opening.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <grp.h>
#include <linux/io_uring.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <sys/xattr.h>
#include <unistd.h>

namespace
{

namespace fs = std::filesystem;

int errorOf(long result)
{
	return result >= 0 ? 0 : errno;
}

int errorOfOpen(const std::string& path, int flags)
{
	const int file = open(path.c_str(), flags | O_CLOEXEC, 0666);
	const int error = errorOf(file);
	if (file >= 0)
		close(file);
	return error;
}

// In a process of its own where there may be one, since it would end this one.
int errorOfExec(const std::function<void()>& become)
{
	const pid_t child = fork();
	if (child <= 0)
		become();
	if (child == 0)
		_exit(errno);
	if (child < 0)
		return errno;
	int status = 0;
	waitpid(child, &status, 0);
	return WEXITSTATUS(status);
}

// Another process of the same user, outside of the door.
pid_t startNeighbor()
{
	const pid_t neighbor = fork();
	if (neighbor != 0)
		return neighbor;
	close_range(0, ~0u, 0);    // the parent would wait for its pipes; it ends the group
	prctl(PR_SET_DUMPABLE, 1); // changing users takes it away
	for (;;)
		pause();
}

void becomeOrdinary()
{
	constexpr unsigned nobody = 65534;
	if (geteuid() != 0)
		return;
	if (setgroups(0, nullptr) != 0 || setresgid(nobody, nobody, nobody) != 0 || setresuid(nobody, nobody, nobody) != 0)
		_exit(1);
	prctl(PR_SET_DUMPABLE, 1);
}

// Writes the number of this process into a file that appears whole.
void tellNumber(const std::string& path)
{
	const std::string number = std::to_string(getpid()), beside = path + ".new";
	const int file = open(beside.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
	if (write(file, number.data(), number.size()) < 0)
		_exit(1);
	close(file);
	rename(beside.c_str(), path.c_str());
}

struct Try
{
	const char* name;
	std::function<int()> run;
};

std::vector<Try> triesOnFiles(const std::string& home)
{
	const std::string key = home + "/key", own = home + "/own";
	return {{"read", [=] { return errorOfOpen(key, O_RDONLY); }},
	        {"list", [=] { return errorOfOpen(home, O_RDONLY | O_DIRECTORY); }},
	        {"create", [=] { return errorOfOpen(home + "/new", O_WRONLY | O_CREAT); }},
	        {"append", [=] { return errorOfOpen(key, O_WRONLY | O_APPEND); }},
	        {"truncate", [=] { return errorOf(truncate(key.c_str(), 0)); }},
	        {"chmod", [=] { return errorOf(chmod(own.c_str(), 0600)); }},
	        {"setxattr", [=] { return errorOf(setxattr(own.c_str(), "user.a", "b", 1, 0)); }},
	        {"utime", [=] { return errorOf(utimensat(AT_FDCWD, own.c_str(), nullptr, 0)); }},
	        {"link", [=] { return errorOf(link(own.c_str(), (home + "/linked").c_str())); }},
	        {"symlink", [=] { return errorOf(symlink(own.c_str(), (home + "/symlinked").c_str())); }},
	        {"mkdir", [=] { return errorOf(mkdir((home + "/folder").c_str(), 0777)); }},
	        {"rename", [=] { return errorOf(rename(own.c_str(), (home + "/renamed").c_str())); }},
	        {"unlink", [=] { return errorOf(unlink((home + "/second").c_str())); }}};
}

int errorOfMemoryFile()
{
	const int file = memfd_create("program", 0);
	const int program = open("/bin/true", O_RDONLY | O_CLOEXEC);
	std::vector<char> bytes(1 << 20);
	const ssize_t size = program < 0 ? 0 : read(program, bytes.data(), bytes.size());
	if (write(file, bytes.data(), static_cast<std::size_t>(size)) != size)
		return errno;
	char* const none[] = {nullptr};
	return errorOfExec([&] { syscall(SYS_execveat, file, "", none, none, AT_EMPTY_PATH); });
}

std::vector<Try> triesOnOthers(pid_t neighbor)
{
	const std::string about = "/proc/" + std::to_string(neighbor);
	return {{"signal", [=] { return errorOf(kill(neighbor, 0)); }},
	        {"owner", [] { return errorOf(fcntl(vp::read::kManifestFd, F_SETOWN, getppid())); }},
	        {"pidfd", [=] { return errorOf(syscall(SYS_pidfd_open, neighbor, 0)); }},
	        {"limits", [=] { return errorOf(prlimit(neighbor, RLIMIT_CORE, nullptr, nullptr)); }},
	        {"priority", [=] { return errorOf(setpriority(PRIO_PROCESS, static_cast<id_t>(neighbor), 19)); }},
	        {"environment", [=] { return errorOfOpen(about + "/environ", O_RDONLY); }},
	        {"memory", [=] { return errorOfOpen(about + "/mem", O_RDWR); }},
	        {"process_vm_readv",
	         [=]
	         {
		         int here = 0;
		         static int there = 0;
		         const iovec to = {&here, sizeof here}, from = {&there, sizeof there};
		         return errorOf(process_vm_readv(neighbor, &to, 1, &from, 1, 0));
	         }},
	        {"ptrace", [=] { return errorOf(ptrace(PTRACE_SEIZE, neighbor, nullptr, nullptr)); }}};
}

std::vector<Try> triesOnTheSystem()
{
	return {{"socket", [] { return errorOf(socket(AF_INET, SOCK_STREAM, 0)); }},
	        {"local socket", [] { return errorOf(socket(AF_UNIX, SOCK_STREAM, 0)); }},
	        {"io_uring",
	         []
	         {
		         io_uring_params parameters = {};
		         return errorOf(syscall(SYS_io_uring_setup, 1, &parameters));
	         }},
	        {"key", [] { return errorOf(syscall(SYS_keyctl, 0, -3, 1)); }},
	        {"namespace", [] { return errorOf(unshare(CLONE_NEWUSER)); }},
	        {"session", [] { return errorOf(setsid() == -1 && errno == ENOSYS ? -1 : 0); }},
	        {"life without a parent",
	         []
	         {
		         const int other = dup(vp::read::kManifestFd);
		         const int file = vp::read::kLifeFd;
		         int cleared = 0;
		         for (const long result :
		              {long(fcntl(file, F_SETFL, 0)), long(fcntl(file, F_SETFD, FD_CLOEXEC)),
		               long(ioctl(file, FIOCLEX)), long(dup(file)), long(dup2(other, file)), long(close(file))})
			         cleared += result >= 0;
		         return cleared > 0 ? 0 : EBADF;
	         }},
	        {"all files closed", [] { return errorOf(close_range(100, 200, 0)); }},
	        {"death signal", [] { return errorOf(prctl(PR_SET_PDEATHSIG, 0)); }},
	        {"written and run",
	         []
	         {
		         void* const at =
		             mmap(nullptr, 4096, PROT_READ | PROT_WRITE | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
		         return at == MAP_FAILED ? errno : 0;
	         }},
	        {"written, then run",
	         []
	         {
		         void* const at = mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
		         return errorOf(mprotect(at, 4096, PROT_READ | PROT_EXEC));
	         }},
	        {"process",
	         []
	         {
		         const pid_t child = fork();
		         if (child == 0)
			         _exit(0);
		         return errorOf(child);
	         }},
	        {"program",
	         []
	         {
		         char* const none[] = {nullptr};
		         return errorOfExec([&] { execve("/bin/true", none, none); });
	         }},
	        {"program in memory", errorOfMemoryFile}};
}

std::vector<Try> whatReadersNeed(const std::string& input)
{
	return {{"may read", [=] { return errorOfOpen(input, O_RDONLY); }},
	        {"may load", [] { return errorOfOpen("/etc/ld.so.cache", O_RDONLY); }},
	        {"may hold memory", [] { return errorOf(memfd_create("some", 0)); }},
	        {"may use threads",
	         []
	         {
		         int ran = 0;
		         std::thread([&] { ran = 1; }).join();
		         return ran ? 0 : EINVAL;
	         }},
	        {"may open more files", []
	         {
		         rlimit limit = {};
		         getrlimit(RLIMIT_NOFILE, &limit);
		         limit.rlim_cur = limit.rlim_max;
		         return errorOf(setrlimit(RLIMIT_NOFILE, &limit));
	         }}};
}

int run(int count, char** arguments)
{
	if (count != 20)
		return 1;
	vp::reader::Request request;
	request.solution = arguments[2];
	request.format = arguments[8];
	request.convert_folder = arguments[11];
	request.sandbox = arguments[14];
	request.file = arguments[19];
	if (request.solution == "nothing")
		return 0;
	const fs::path folder = fs::path(request.file).parent_path();
	const std::string home = folder.parent_path() / "home";
	becomeOrdinary();
	for (const char* name : {"/own", "/second"})
		close(open((home + name).c_str(), O_WRONLY | O_CREAT, 0666));
	const pid_t neighbor = startNeighbor();

	const bool waits = request.solution == "wait";
	if (waits)
		tellNumber(home + "/number");

	vp::reader::door::Hold hold;
	if (request.sandbox != "off")
		hold = vp::reader::door::closeDoor(vp::reader::door::openingFor(request));
	vp::reader::door::refuseExec();
	while (waits)
		pause();
	std::string told = "holds: " + vp::reader::door::holdText(hold) + "\n";
	std::vector<Try> tries = whatReadersNeed(request.file);
	tries.push_back({"read beside", [=] { return errorOfOpen(folder / "beside.txt", O_RDONLY); }});
	if (!request.convert_folder.empty())
		tries.push_back({"may write", [=] { return errorOfOpen(request.convert_folder + "/a", O_WRONLY | O_CREAT); }});
	for (const auto& more : {triesOnFiles(home), triesOnOthers(neighbor), triesOnTheSystem()})
		tries.insert(tries.end(), more.begin(), more.end());
	for (const Try& one : tries)
		told += std::string(one.name) + ": " + std::to_string(one.run()) + "\n";
	const bool is_told = write(vp::read::kManifestFd, told.data(), told.size()) == static_cast<ssize_t>(told.size());
	_exit(is_told ? 0 : 1);
}

} // namespace

int main(int count, char** arguments)
{
	if (!vp::read::isAskedForCopies(count, arguments))
		return run(count, arguments);
	std::vector<std::string> own = vp::read::makeCopies();
	return run(static_cast<int>(own.size()), vp::read::pointersTo(own).data());
}
