#include "complaints.h"

#include "complaint_words.h"
#include "vprobe-read/base/read_files.h"
#include "vprobe-read/base/refusal.h"

#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <new>
#include <streambuf>
#include <string>
#include <string_view>
#include <utility>

namespace vp::reader::checks
{

namespace
{

std::string first_complaint;
std::string complained_at; // the file that was being read then
std::vector<std::string> notes;
std::size_t more_notes = 0;

constexpr std::size_t kMaxNotes = 4;
constexpr std::size_t kMaxNoteLength = 160;

// Readers report these only as warnings, or print them, and continue with values that were never read. docs/FORMATS.md
// lists them by reader.
constexpr std::array<std::string_view, 8> kLosesValues = {
    "Uncompress failed",            // MetaImage: packed data that are shown as 0
    "Error reading binary data",    // legacy VTK
    "Error reading ascii data",     // legacy VTK
    "File operation failed",        // images
    "Unknown data type",            // images
    "cgio_read",                    // CGNS
    "Unexpected data type for dim", // CGNS: the cells of a section
    "Error in cgio_get_data_type",  // CGNS
};

// "ERROR: In file.cxx, line 12\nvtkReader (0x1234): Words\n\n" leaves "Words".
std::string wordsOf(std::string_view text)
{
	if (const auto line_end = text.find('\n'); line_end != text.npos && text.find(", line ") < line_end)
		text.remove_prefix(line_end + 1);
	if (const auto address = text.find(" (0x"); address != text.npos)
		if (const auto colon = text.find("): ", address); colon != text.npos)
			text.remove_prefix(colon + 3);
	while (!text.empty() && (text.back() == '\n' || text.back() == ' '))
		text.remove_suffix(1);
	std::string words(text);
	// A damaged file may have bytes in place of a name that are not text.
	std::replace_if(
	    words.begin(), words.end(), [](unsigned char c) { return c < 0x20 || c >= 0x7F; }, '?');
	return words;
}

void keep(const char* text)
{
	if (!first_complaint.empty())
		return;
	complained_at = pieceBeingRead();
	first_complaint = text ? wordsOf(text) : std::string();
	if (first_complaint.empty())
		first_complaint = "the reader reported an error";
}

void note(const char* text)
{
	std::string words = text ? wordsOf(text) : std::string();
	if (words.empty())
		return;
	const auto is_in_words = [&](std::string_view sign) { return words.find(sign) != words.npos; };
	if (std::any_of(kLosesValues.begin(), kLosesValues.end(), is_in_words))
		return keep(text);
	if (words.size() > kMaxNoteLength)
		words.replace(kMaxNoteLength, words.npos, "...");
	if (std::find(notes.begin(), notes.end(), words) != notes.end())
		return;
	if (notes.size() == kMaxNotes)
		++more_notes;
	else
		notes.push_back(std::move(words));
}

class ComplaintWindow : public vtkOutputWindow
{
public:
	static ComplaintWindow* New();
	vtkTypeMacro(ComplaintWindow, vtkOutputWindow);

	void DisplayText(const char*) override {}
	void DisplayErrorText(const char* text) override { keep(text); }
	void DisplayGenericWarningText(const char* text) override { note(text); }
	void DisplayWarningText(const char* text) override { note(text); }
	void DisplayDebugText(const char*) override {}
};

vtkStandardNewMacro(ComplaintWindow);

// Takes the lines that readers print on std::cerr for warnings.
class NoteBuffer : public std::streambuf
{
protected:
	int_type overflow(int_type c) override
	{
		if (c == traits_type::eof() || c == '\n')
		{
			note(line_.c_str());
			line_.clear();
		}
		else if (line_.size() < 2 * kMaxNoteLength)
			line_ += static_cast<char>(c);
		return traits_type::not_eof(c);
	}

private:
	std::string line_;
};

} // namespace

void installComplaints()
{
	vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
	vtkNew<ComplaintWindow> window;
	vtkOutputWindow::SetInstance(window);
	static NoteBuffer printed;
	std::cerr.rdbuf(&printed);
}

void refuseOnComplaint()
{
	if (first_complaint.find("No Points element available") != std::string::npos) // as writers leave it without any
		throw Refusal("nothing to slice: it has no points");
	if (first_complaint.empty())
		return;
	blame(complained_at); // others may have been read since
	if (tellsOfMemory(first_complaint))
		throw std::bad_alloc();
	throw damaged(inOurWords(first_complaint));
}

bool hasComplaint()
{
	return !first_complaint.empty();
}

bool wasNoted(std::string_view words)
{
	return std::any_of(notes.begin(), notes.end(), [&](const std::string& n) { return n.find(words) != n.npos; });
}

std::vector<std::string> takeNotes()
{
	if (more_notes > 0)
		notes.push_back(fmt::format("the reader warned {} more times", more_notes));
	more_notes = 0;
	return std::exchange(notes, {});
}

} // namespace vp::reader::checks
