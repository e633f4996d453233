#pragma once

#include "vprobe-read/base/request.h"

#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <string>
#include <string_view>

class ManifestWriter;

// One function a format: reads the file and adds what it holds. They throw a Refusal. Where another program reads the
// format, the process becomes that program.
#define VP_FORMAT(NAME, ENDINGS, WHAT, READ, BY, FILES, SIGN, PROGRAM, FUNCTION)                                       \
	void read##FUNCTION(const Request& request, ManifestWriter& manifest);
#include "read/format_table.inl"
#undef VP_FORMAT

// VTK XML, by the type that its VTKFile element gives.
void readXml(const Request& request, const std::string& type, ManifestWriter& manifest);
void readMultiBlock(const Request& request, const std::string& type, ManifestWriter& manifest);
void readAmr(const Request& request, const std::string& type, ManifestWriter& manifest);
void readCollection(const Request& request, ManifestWriter& manifest);

// The data set of one VTK XML file that is no index of blocks.
vtkSmartPointer<vtkDataObject> loadXml(const Request& request, const std::string& type, ManifestWriter& manifest);

// Adds the block of such a file: without VTK where that is possible.
void addXml(const Request& request, const std::string& type, ManifestWriter& manifest);

// Where parts are asked for, reads the pieces of a parallel file that can be cut on their own, each as a block. False,
// and nothing read, for other types, and where pieces lie on each other.
bool readPieces(const Request& request, const std::string& type, ManifestWriter& manifest);

// About how many cells a VTK XML file has, from its first bytes.
std::size_t cellsOfXml(const std::string& file);

// The type its VTKFile element gives; empty where there is none.
std::string xmlTypeOfFile(const std::string& file);

// HDF5 files are told apart by what they hold, for which vprobe-read becomes vprobe-read-more.
void needHdf5(const Request& request);

// Reads the slices of a request, a file each, as one volume.
void readStack(const Request& request, ManifestWriter& manifest);

// Makes a built-in data set: what stands behind the prefix.
constexpr std::string_view kDemoPrefix = "demo:";
void readDemo(const Request& request, ManifestWriter& manifest);

// Unpacks parts of an array that stays in its file, as the request says, until nobody asks for more (protocol.h). Each
// answer is bytes for the parent. Throws a Refusal.
void unpackParts(const Request& request, const std::function<void(std::string_view)>& answer);

// Finds out what a file is, where the request does not say it, and reads it.
void readAnyFormat(const Request& request, ManifestWriter& manifest);
