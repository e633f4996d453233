#include "complaints.h"

#include "refusal.h"

#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace
{

std::string first_complaint;
bool warnings_too = false;

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
	// What a damaged file has in place of a name need not be text.
	std::replace_if(
	    words.begin(), words.end(), [](unsigned char c) { return c < 0x20 || c >= 0x7F; }, '?');
	return words;
}

void keep(const char* text)
{
	if (first_complaint.empty())
		first_complaint = text ? wordsOf(text) : std::string();
	if (first_complaint.empty())
		first_complaint = "the reader reported an error";
}

class ComplaintWindow : public vtkOutputWindow
{
public:
	static ComplaintWindow* New();
	vtkTypeMacro(ComplaintWindow, vtkOutputWindow);

	void DisplayText(const char*) override {}
	void DisplayErrorText(const char* text) override { keep(text); }
	// "Error reading binary data!" of the legacy readers comes as a generic warning.
	void DisplayGenericWarningText(const char* text) override { keep(text); }
	void DisplayWarningText(const char* text) override
	{
		if (warnings_too)
			keep(text);
	}
	void DisplayDebugText(const char*) override {}
};

vtkStandardNewMacro(ComplaintWindow);

} // namespace

void installComplaints()
{
	vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
	vtkNew<ComplaintWindow> window;
	vtkOutputWindow::SetInstance(window);
}

void takeWarningsToo()
{
	warnings_too = true;
}

void refuseOnComplaint()
{
	if (!first_complaint.empty())
		throw damaged(first_complaint);
}
