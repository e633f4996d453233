#include "viewer/panels/file_browser.h"

#include "viewer/panels/widgets.h"

#include <fmt/format.h>
#include <imgui/imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace vp::app
{

namespace
{

namespace fs = std::filesystem;

std::string lower(std::string text)
{
	for (char& letter : text)
		letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
	return text;
}

} // namespace

void FileBrowser::begin(fs::path folder, std::vector<std::string> endings, std::string name)
{
	endings_ = std::move(endings);
	name_ = std::move(name);
	all_ = false;
	appears_ = true;
	enter(folder);
}

void FileBrowser::enter(const fs::path& folder)
{
	std::error_code error;
	const fs::path whole = fs::weakly_canonical(folder, error);
	if (error || !fs::is_directory(whole, error))
	{
		complaint_ = fmt::format("{} is no folder", folder.string());
		return;
	}
	folder_ = whole;
	place_ = whole.string();
	list();
}

bool FileBrowser::fits(const std::string& name) const
{
	return all_ || endings_.empty() ||
	       std::ranges::any_of(endings_,
	                           [&](const std::string& ending) { return lower(name).ends_with(lower(ending)); });
}

// Lists folders first. Names that begin with a dot are left out.
void FileBrowser::list()
{
	entries_.clear();
	complaint_.clear();
	std::error_code error;
	for (fs::directory_iterator at(folder_, error), end; !error && at != end; at.increment(error))
	{
		std::error_code ignored;
		Entry entry{at->path().filename().string(), at->is_directory(ignored), 0};
		if (entry.name.starts_with('.') || (!entry.is_folder && !fits(entry.name)))
			continue;
		if (!entry.is_folder)
			entry.size = at->file_size(ignored);
		entries_.push_back(std::move(entry));
	}
	if (error)
		complaint_ = fmt::format("{}: {}", folder_.string(), error.message());
	std::ranges::sort(entries_, [](const Entry& a, const Entry& b)
	                  { return a.is_folder != b.is_folder ? a.is_folder : lower(a.name) < lower(b.name); });
}

void FileBrowser::showPlace()
{
	const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
	if (ImGui::Button("Up"))
		enter(folder_.parent_path());
	tip("To the folder above");
	ImGui::SameLine(0.0f, gap);
	const char* home = std::getenv("HOME");
	if (ImGui::Button("Home") && home)
		enter(home);
	tip("To your own folder");
	ImGui::SameLine(0.0f, gap);
	const bool filters = !endings_.empty();
	const float box = ImGui::CalcTextSize("All files").x + ImGui::GetFrameHeight() + 3.0f * gap;
	ImGui::SetNextItemWidth(filters ? -box : -1.0f);
	if (ImGui::InputText("##place", &place_, ImGuiInputTextFlags_EnterReturnsTrue))
		enter(place_);
	tip("The folder; another may be typed");
	if (!filters)
		return;
	ImGui::SameLine(0.0f, gap);
	if (ImGui::Checkbox("All files", &all_))
		list();
	tip("Shows files with other endings too");
}

// Returns true if the user takes this entry at once.
bool FileBrowser::choose(const Entry& entry, bool twice)
{
	if (!entry.is_folder)
	{
		name_ = entry.name;
		return twice;
	}
	if (twice)
		enter(folder_ / std::string(entry.name)); // a copy: the list is made anew
	return false;
}

bool FileBrowser::showEntries(float height)
{
	bool chosen = false;
	if (!ImGui::BeginTable("entries", 2, ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg, {0.0f, height}))
		return false;
	ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch);
	ImGui::TableSetupColumn("size", ImGuiTableColumnFlags_WidthFixed, 6.0f * ImGui::GetFontSize());
	for (std::size_t i = 0; i < entries_.size(); ++i)
	{
		const Entry entry = entries_[i]; // a copy: the list may be made anew
		ImGui::TableNextRow();
		ImGui::TableNextColumn();
		ImGui::PushID(static_cast<int>(i));
		const std::string label = entry.name + (entry.is_folder ? "/" : "");
		const bool clicked =
		    ImGui::Selectable(label.c_str(), entry.name == name_,
		                      ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_DontClosePopups |
		                          ImGuiSelectableFlags_AllowDoubleClick);
		// With the keyboard, one press is enough.
		const bool by_key = clicked && !ImGui::IsMouseClicked(0) && !ImGui::IsMouseReleased(0);
		if (clicked)
			chosen = choose(entry, by_key || ImGui::IsMouseDoubleClicked(0)) || chosen;
		ImGui::PopID();
		ImGui::TableNextColumn();
		if (!entry.is_folder)
			ImGui::TextDisabled("%s", bytes(static_cast<double>(entry.size)).c_str());
	}
	ImGui::EndTable();
	return chosen;
}

bool FileBrowser::show(float height)
{
	showPlace();
	const bool listed = showEntries(height);
	if (!complaint_.empty())
		ImGui::TextWrapped("%s", complaint_.c_str());
	ImGui::AlignTextToFramePadding();
	ImGui::TextUnformatted("Name");
	ImGui::SameLine();
	ImGui::SetNextItemWidth(-1.0f);
	if (appears_)
		ImGui::SetKeyboardFocusHere();
	appears_ = false;
	const bool entered = ImGui::InputText("##name", &name_, ImGuiInputTextFlags_EnterReturnsTrue);
	if (!entered || name_.empty())
		return listed;
	std::error_code ignored;
	if (!fs::is_directory(folder_ / name_, ignored))
		return true;
	enter(folder_ / std::exchange(name_, {}));
	appears_ = true;
	return listed;
}

std::string FileBrowser::path() const
{
	return name_.empty() ? std::string() : (folder_ / name_).string();
}

bool FileBrowser::exists() const
{
	std::error_code ignored;
	return !name_.empty() && fs::exists(folder_ / name_, ignored);
}

} // namespace vp::app
