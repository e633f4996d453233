#pragma once

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace cli
{

using Arguments = std::vector<std::string>;

struct Surroundings
{
	std::map<std::string, std::string> environment{}; // set on top of ours
	std::string standard_output{};                    // a file to write to instead of being caught
	std::string standard_error{};                     // likewise
	std::string standard_input{"/dev/null"};          // a file to read from
	std::vector<int> closed{};                        // those of the three streams that are closed
	std::string folder{};                             // where it runs; empty: where the test does
	long file_size_limit = 0; // bytes any file may grow to; 0: as it pleases. Stands for a full disk
	long memory_limit = 0;    // bytes of address space; 0: as it pleases
};

// The outcome of a run of the program. A program killed by a signal has the status 128 + signal, as in a shell.
struct Outcome
{
	int status = 0;
	std::string out;
	std::string err;

	nlohmann::json json() const { return nlohmann::json::parse(out, nullptr, false); }
};

// A test with a folder of its own, which is empty at its start and gone after it.
class Program : public testing::Test
{
protected:
	Program();
	~Program() override;

	Outcome run(const Arguments& arguments, const Surroundings& surroundings = {}) const;
	// Runs it until `ripe`, and then presses Ctrl-C.
	Outcome interrupted(const Arguments& arguments, const std::function<bool()>& ripe) const;
	// The stats of a slice that must succeed, with the CPU classifier.
	nlohmann::json stats(const Arguments& inputs_and_probe) const;

	std::string path(const std::string& name) const { return (folder_ / name).string(); }
	std::string write(const std::string& name, const std::string& contents) const; // gives its path
	std::vector<std::string> files() const;                                        // names in the folder

private:
	int start(const Arguments& arguments, const Surroundings& surroundings) const; // the process
	Outcome outcomeOf(int process, const Surroundings& surroundings) const;

	std::filesystem::path folder_;
	std::filesystem::path caught_; // standard output and error; outside the folder
};

// Skipped where there is no device to draw with.
class Drawing : public Program
{
protected:
	void SetUp() override;
};

struct PictureSize
{
	std::uint32_t width = 0, height = 0;
	bool operator==(const PictureSize&) const = default;
};

// From a PNG's header, which comes first; 0 x 0 of anything else, and where the file's end is missing.
PictureSize sizeOf(const std::string& png);

std::string contents(const std::string& path);
bool contains(const std::string& text, const std::string& part);

// One line on standard error that holds all the words, nothing on standard output, the status asked for.
testing::AssertionResult isError(const Outcome& outcome, int status, const std::vector<std::string>& words);
// Status 0 and nothing on standard error.
testing::AssertionResult isQuiet(const Outcome& outcome);
// Status 0 and one line on standard error that holds all the words.
testing::AssertionResult isDoneWithAWord(const Outcome& outcome, const std::vector<std::string>& words);

Arguments operator+(Arguments a, const Arguments& b);

// Surroundings in which no Vulkan device is found.
Surroundings noDevice();

} // namespace cli
