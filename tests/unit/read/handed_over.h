#pragma once

#include "read/child.h"

#include <nlohmann/json.hpp>

#include <string>

// What the reader's program hands over of a file: its manifest, with what each array holds in place of where it is. Its
// error, where it has one: {"error": message, "kind": ErrorKind as a number}.
nlohmann::json handedOver(const std::string& file, const vp::read::ReadOptions& options = {});

// The same by VTK's readers, whatever the file is.
nlohmann::json handedOverByVtk(const std::string& file, const vp::read::ReadOptions& options = {});

// Whether the reader reads the file without VTK.
bool isReadQuickly(const std::string& file);
