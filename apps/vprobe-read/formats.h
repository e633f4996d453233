#pragma once

#include "request.h"

#include <string>

class ManifestWriter;

// One function a family of formats: reads the file and adds what it holds. They throw a Refusal.
void readXml(const Request& request, const std::string& type, ManifestWriter& manifest);
void readLegacy(const Request& request, ManifestWriter& manifest);
void readMetaImage(const Request& request, ManifestWriter& manifest);
void readPlot3d(const Request& request, ManifestWriter& manifest);
void readExodus(const Request& request, ManifestWriter& manifest);

// Finds out what a file is, by its first bytes where they tell and by its ending where they do not, and reads it.
void readAnyFormat(const Request& request, ManifestWriter& manifest);
