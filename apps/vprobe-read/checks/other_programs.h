#pragma once

namespace vp::reader::checks
{

class FileHead;

// Throws a Refusal for files and folders that are known but not read: those of other programs, and newer or wider kinds
// than are read of a format. The Refusal names the remedy. This is cheap: it looks only at the name and the first
// bytes.
void refuseOtherPrograms(const FileHead& head);

} // namespace vp::reader::checks
