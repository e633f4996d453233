#pragma once

#include "request.h"

#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <string>

class ManifestWriter;

// One function a family of formats: reads the file and adds what it holds. They throw a Refusal.
void readXml(const Request& request, const std::string& type, ManifestWriter& manifest);
void readMultiBlock(const Request& request, const std::string& type, ManifestWriter& manifest);
void readAmr(const Request& request, const std::string& type, ManifestWriter& manifest);
void readCollection(const Request& request, ManifestWriter& manifest);
void readSeries(const Request& request, ManifestWriter& manifest);
void readLegacy(const Request& request, ManifestWriter& manifest);
void readMetaImage(const Request& request, ManifestWriter& manifest);
void readPlot3d(const Request& request, ManifestWriter& manifest);
void readNrrd(const Request& request, ManifestWriter& manifest);
void readNifti(const Request& request, ManifestWriter& manifest);
void readExodus(const Request& request, ManifestWriter& manifest);
void readHdf(const Request& request, ManifestWriter& manifest);
void readCgns(const Request& request, ManifestWriter& manifest);
void readEnSight(const Request& request, ManifestWriter& manifest);
void readFoam(const Request& request, ManifestWriter& manifest);

// The data set of one VTK XML file that is no index of blocks.
vtkSmartPointer<vtkDataObject> loadXml(const Request& request, const std::string& type, ManifestWriter& manifest);

// Adds the block of such a file: without VTK where that is possible.
void addXml(const Request& request, const std::string& type, ManifestWriter& manifest);

// The type its VTKFile element gives; empty where there is none.
std::string xmlTypeOfFile(const std::string& file);

// Finds out what a file is, by its first bytes where they tell and by its ending where they do not, and reads it.
void readAnyFormat(const Request& request, ManifestWriter& manifest);
