#pragma once

#include "vprobe-read/base/memory_file.h"
#include "vprobe-read/base/request.h"
#include "vprobe-read/quick/xml_arrays.h"
#include "vprobe-read/text/xml_tree.h"

#include <list>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace vp::reader::vtk
{

// VTK 9.1 reads a VTK XML file wrongly, or not at all, if it holds several times, pieces without points, two arrays of
// one name, or numbers in text such as nan, 1D2 and 1.0-100. Such a file becomes a copy in memory: of one time, without
// those pieces, with a name for each array, and with the numbers as bytes. Of an index of pieces, the pieces are looked
// at too. Other files stay what they are. Arrays of the wrong size are refused.
class PlainXml
{
public:
	// Throws a Refusal if the times cannot be told apart, if there is none that is asked for, for a word that is no
	// number, and for an array with too few or too many values.
	explicit PlainXml(const Request& request);

	// Returns the request to follow in place of the one for the file.
	const Request& request() const { return request_; }
	// The data files themselves, or copies of them: those of the pieces, or the only one.
	const std::vector<std::string>& dataFiles() const { return data_files_; }
	// Those that the elements name, in order.
	const std::vector<double>& times() const { return times_; }
	// Whether there is no piece with points.
	bool isEmpty() const { return is_empty_; }
	// Whether the file may have numbers in text that were not looked at.
	bool hasUnknownText() const { return has_unknown_text_; }
	// Returns the lines that the user has to know.
	const std::vector<std::string>& warnings() const { return warnings_; }

private:
	void takeData(const text::XmlFile& xml, std::string_view text);
	void takeIndex(const text::XmlFile& xml, std::string_view text);
	void leaveOutOtherTimes(text::XmlElement& data);
	// Writes the arrays anew where VTK's readers would not know a number. Else they are only looked at; false.
	bool copyNumbers(const text::XmlFile& given, text::XmlFile& xml, std::string_view text);
	// given: the elements of the file; xml: those that stay.
	void copy(const text::XmlFile& given, const text::XmlFile& xml, std::string_view text);
	void warn(const std::vector<std::string>& lines);
	MemoryFile& newFile() { return files_.emplace_back(); }

	Request request_;
	std::list<MemoryFile> files_;
	std::vector<std::string> data_files_;
	std::vector<double> times_;
	std::vector<std::string> warnings_;
	std::string type_;     // the type of the data; empty if VTK has to tell about them
	quick::Fields fields_; // the fields of the pieces of a data file
	bool has_unknown_text_ = false;
	bool is_empty_ = false;
};

} // namespace vp::reader::vtk
