#pragma once

#include "vprobe-read/base/request.h"

#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <string>
#include <string_view>

namespace vp::reader::manifest
{
class Writer;
}

namespace vp::reader
{

// Each format has one function, in the namespace of the folder that reads it: it reads the file and adds what the file
// holds. It throws a Refusal. If another program reads the format, the process becomes that program.
#define VP_FORMAT(NAME, ENDINGS, WHAT, READ, BY, FILES, SIGN, PROGRAM, ROOM, FUNCTION)                                 \
	namespace ROOM                                                                                                     \
	{                                                                                                                  \
	void read##FUNCTION(const Request& request, manifest::Writer& manifest);                                           \
	}
#include "read/format_table.inl"
#undef VP_FORMAT

namespace vtk
{

// VTK XML, by the type that its VTKFile element gives.
void readXml(const Request& request, const std::string& type, manifest::Writer& manifest);
void readMultiBlock(const Request& request, const std::string& type, manifest::Writer& manifest);
void readAmr(const Request& request, const std::string& type, manifest::Writer& manifest);
void readCollection(const Request& request, manifest::Writer& manifest);

// The data set of one VTK XML file that is no index of blocks.
vtkSmartPointer<vtkDataObject> loadXml(const Request& request, const std::string& type, manifest::Writer& manifest);

// Adds the block of such a file: without VTK where that is possible.
void addXml(const Request& request, const std::string& type, manifest::Writer& manifest);

// Where parts are asked for, reads the pieces of a parallel file that can be cut on their own, each as a block. False,
// and nothing read, for other types, and where pieces lie on each other.
bool readPieces(const Request& request, const std::string& type, manifest::Writer& manifest);

// About how many cells a VTK XML file has, from its first bytes.
std::size_t cellsOfXml(const std::string& file);

} // namespace vtk

namespace volumes
{

// Reads the slices of a request, a file each, as one volume.
void readStack(const Request& request, manifest::Writer& manifest);

// Unpacks parts of an array that stays in its file, as the request says, until nobody asks for more (protocol.h). Each
// answer is bytes for the parent. Throws a Refusal.
void unpackParts(const Request& request, const std::function<void(std::string_view)>& answer);

} // namespace volumes

namespace formats
{

// The type its VTKFile element gives; empty where there is none.
std::string xmlTypeOfFile(const std::string& file);

// HDF5 files are told apart by what they hold, for which vprobe-read becomes vprobe-read-more.
void needHdf5(const Request& request);

// Makes a built-in data set: what stands behind the prefix.
constexpr std::string_view kDemoPrefix = "demo:";
void readDemo(const Request& request, manifest::Writer& manifest);

// Finds out what a file is, where the request does not say it, and reads it.
void readAnyFormat(const Request& request, manifest::Writer& manifest);

} // namespace formats

} // namespace vp::reader
