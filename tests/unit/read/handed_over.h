#pragma once

#include "read/child.h"

#include <nlohmann/json.hpp>

#include <string>

// Returns what the reader's program hands over of a file: its manifest, with the contents of each array in place of its
// position. If the program fails, returns its error: {"error": message, "kind": ErrorKind as a number}.
nlohmann::json handedOver(const std::string& file, const vp::read::ReadOptions& options = {});

// Returns the same by VTK's readers, even if the file needs none.
nlohmann::json handedOverByVtk(const std::string& file, const vp::read::ReadOptions& options = {});

// Returns true if the program reads the file without VTK.
bool isReadQuickly(const std::string& file);
