#include "nrrd_file.h"

#include "nrrd_axes.h"
#include "vprobe-read/arrays/text_values.h"
#include "vprobe-read/base/refusal.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>

namespace vp::reader::volumes
{

namespace
{

// teem takes the beginning of a word for a number, and passes over what follows the last one.
void takeNrrdText(Nrrd& nrrd, const std::string& file)
{
	const std::optional<std::string> text = nrrdText(file);
	if (!text)
		return;
	arrays::parseText(*text, typeOfNrrd(nrrd.type), nrrdElementNumber(&nrrd), nrrd.data);
}

struct FileCloser
{
	void operator()(std::FILE* file) const { std::fclose(file); }
};

} // namespace

std::string biffReason()
{
	char* text = biffGetDone(NRRD);
	std::string reason = text ? text : "";
	std::free(text);
	while (!reason.empty() && reason.back() == '\n')
		reason.pop_back();
	if (const auto line = reason.rfind('\n'); line != reason.npos)
		reason.erase(0, line + 1);
	return reason.empty() ? "teem cannot read it" : reason;
}

NrrdPointer loadNrrd(const std::string& file)
{
	NrrdPointer nrrd(nrrdNew());
	const std::unique_ptr<NrrdIoState, NrrdDeleter> state(nrrdIoStateNew());
	if (nrrdLoad(nrrd.get(), file.c_str(), state.get()))
		throw damaged(biffReason());
	if (state->encoding == nrrdEncodingAscii)
		takeNrrdText(*nrrd, file);
	return nrrd;
}

std::optional<NrrdHead> plainNrrd(const std::string& file)
{
	NrrdHead head{NrrdPointer(nrrdNew()), file};
	const std::unique_ptr<NrrdIoState, NrrdDeleter> state(nrrdIoStateNew());
	nrrdIoStateSet(state.get(), nrrdIoStateSkipData, 1);
	// teem leaves the file open where the values begin, and has skipped all that its header says.
	nrrdIoStateSet(state.get(), nrrdIoStateKeepNrrdDataFileOpen, 1);
	if (nrrdLoad(head.nrrd.get(), file.c_str(), state.get()))
	{
		biffReason(); // so that it is forgotten
		return std::nullopt;
	}
	const std::unique_ptr<std::FILE, FileCloser> opened(state->dataFile);
	const long begin = opened ? std::ftell(opened.get()) : -1;
	if (begin < 0 || state->encoding != nrrdEncodingRaw || state->dataFNFormat || state->dataFNArr->len > 1)
		return std::nullopt;
	if (state->dataFNArr->len == 1)
		head.file = (std::filesystem::path(file).parent_path() / state->dataFN[0]).string();
	head.offset = static_cast<std::uint64_t>(begin);
	head.is_big_endian = state->endian == airEndianBig;
	std::error_code absent;
	const std::uint64_t size = std::filesystem::file_size(head.file, absent);
	std::uint64_t bytes = nrrdElementSize(head.nrrd.get());
	for (unsigned axis = 0; axis < head.nrrd->dim; ++axis)
		if (__builtin_mul_overflow(bytes, std::uint64_t(head.nrrd->axis[axis].size), &bytes))
			return std::nullopt;
	const bool is_there = !absent && head.offset <= size && bytes <= size - head.offset;
	return is_there ? std::optional(std::move(head)) : std::nullopt;
}

} // namespace vp::reader::volumes
