#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace vp::app
{

// A folder's files, of which one is chosen, or a name for a new one. Drawn within a window of ImGui's; what is drawn
// can be gone through by the keyboard.
class FileBrowser
{
public:
	// endings: with their dots; files with others are left out unless the user wants all. name: offered for a new file.
	void begin(std::filesystem::path folder, std::vector<std::string> endings, std::string name);

	// True where a file was chosen, by Enter or twice clicking. height: of the list.
	bool show(float height);

	// What the name field says, in the folder; empty where it says nothing.
	std::string path() const;
	bool exists() const;
	const std::filesystem::path& folder() const { return folder_; }

private:
	struct Entry
	{
		std::string name;
		bool is_folder;
		std::uintmax_t size;
	};

	void enter(const std::filesystem::path& folder);
	void list();
	bool fits(const std::string& name) const;
	void showPlace();
	bool showEntries(float height);
	bool choose(const Entry& entry, bool twice);

	std::filesystem::path folder_;
	std::vector<std::string> endings_;
	std::string name_;
	std::string place_; // as it is typed
	std::string complaint_;
	std::vector<Entry> entries_;
	bool all_ = false;
	bool appears_ = true;
};

} // namespace vp::app
