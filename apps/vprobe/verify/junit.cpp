#include "verify/junit.h"

#include "version.h"
#include "write/xml_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace vp::app
{

namespace
{

using write::xmlText;

std::string testCase(const Judgment& one)
{
	const std::filesystem::path file = one.file;
	const std::string folder = file.has_parent_path() ? file.parent_path().string() : ".";
	const std::string device = one.driver.empty() ? one.device : fmt::format("{}, {}", one.device, one.driver);
	std::string inner;
	if (one.verdict == Verdict::differs)
		inner = fmt::format("<failure message=\"{}\" type=\"differs\"/>", xmlText(one.detail));
	else if (one.verdict == Verdict::failed)
		inner = fmt::format("<error message=\"{}\" type=\"error\"/>", xmlText(one.detail));
	return fmt::format(
	    "\t\t<testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\">{}<system-out>{}</system-out></testcase>\n",
	    xmlText(folder), xmlText(file.filename().string()), one.seconds, inner,
	    xmlText(fmt::format("{}: {}; {}", word(one.verdict), one.detail, device)));
}

} // namespace

std::string junitText(const std::vector<Judgment>& judgments)
{
	const auto count = [&](Verdict verdict) { return std::ranges::count(judgments, verdict, &Judgment::verdict); };
	double seconds = 0.0;
	for (const Judgment& one : judgments)
		seconds += one.seconds;
	const std::string counts = fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\"",
	                                       judgments.size(), count(Verdict::differs), count(Verdict::failed), seconds);
	std::string text =
	    fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"vprobe verify\" {}>\n"
	                "\t<testsuite name=\"vprobe {} verify\" {}>\n",
	                counts, kVersion, counts);
	for (const Judgment& one : judgments)
		text += testCase(one);
	return text + "\t</testsuite>\n</testsuites>\n";
}

} // namespace vp::app
