#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace vp::app
{

// Shows the files of a folder. The user chooses one, or types a name for a new one. It is drawn within a window of
// ImGui, and works with the keyboard too.
class FileBrowser
{
public:
	// endings: file endings with their dots. Other files are left out unless the user wants all. name: a suggestion for
	// a new file.
	void begin(std::filesystem::path folder, std::vector<std::string> endings, std::string name);

	// Returns true if the user chose a file, by Enter or a double click. height: the height of the list.
	bool show(float height);

	// Returns the path of the file in the name field. Empty if the field is empty.
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
	std::string place_; // the folder as it is typed
	std::string complaint_;
	std::vector<Entry> entries_;
	bool all_ = false;
	bool appears_ = true;
};

} // namespace vp::app
