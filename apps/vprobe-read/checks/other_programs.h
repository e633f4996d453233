#pragma once

class FileHead;

// Throws a Refusal that names the remedy for files and folders that are known but not read: those of other programs,
// and newer or wider kinds of formats that are read in part. Cheap: it looks at the name and the first bytes.
void refuseOtherPrograms(const FileHead& head);
