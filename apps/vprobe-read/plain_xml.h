#pragma once

#include "request.h"
#include "xml_tree.h"

#include <list>
#include <string>
#include <string_view>
#include <vector>

// A file in memory, which readers open by its path.
class MemoryFile
{
public:
	MemoryFile();
	~MemoryFile();
	MemoryFile(const MemoryFile&) = delete;
	MemoryFile& operator=(const MemoryFile&) = delete;

	std::string path() const;
	void append(std::string_view bytes);
	// Leaves so many bytes out; they read as zeros and take no memory.
	void skip(std::size_t bytes) { size_ += bytes; }
	// Behind all that was appended and left out.
	void end() const;

private:
	int file_ = -1;
	std::size_t size_ = 0;
};

// VTK 9.1 reads a VTK XML file wrongly, or not at all, if it holds several times or pieces without points. Such a file
// becomes a copy in memory of one time, without those pieces. Of an index of pieces, the pieces are looked at too.
// Other files stay what they are.
class PlainXml
{
public:
	// Throws a Refusal if the times cannot be told apart, or if there is none that is asked for.
	explicit PlainXml(const Request& request);

	// What to read in place of the file.
	const Request& request() const { return request_; }
	// The data files themselves, or copies of them: those of the pieces, or the only one.
	const std::vector<std::string>& dataFiles() const { return data_files_; }
	// Those that the elements name, in order.
	const std::vector<double>& times() const { return times_; }
	// Whether there is no piece with points.
	bool isEmpty() const { return is_empty_; }

private:
	void takeData(const XmlFile& xml, std::string_view text);
	void takeIndex(const XmlFile& xml, std::string_view text);
	void leaveOutOtherTimes(XmlElement& data);
	// given: the elements of the file; xml: those that stay.
	void copy(const XmlFile& given, const XmlFile& xml, std::string_view text);
	MemoryFile& newFile() { return files_.emplace_back(); }

	Request request_;
	std::list<MemoryFile> files_;
	std::vector<std::string> data_files_;
	std::vector<double> times_;
	bool is_empty_ = false;
};
