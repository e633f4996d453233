#include "profile/history.h"
#include "profile/spread.h"
#include "profile/steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vp::app
{

namespace
{

constexpr double kPageWidth = 960.0;
constexpr double kPlotLeft = 90.0, kPlotRight = 930.0;
constexpr double kHeadHeight = 64.0, kPanelHeight = 130.0, kPlotHeight = 90.0, kFootHeight = 110.0;

std::string escaped(const std::string& text)
{
	std::string safe;
	for (const char c : text)
		safe += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
	return safe;
}

std::string svgText(double x, double y, const std::string& attributes, const std::string& text)
{
	return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y, attributes, escaped(text));
}

// Runs that follow each other under one label.
struct LabelRange
{
	std::string label;
	std::size_t begin, end;
};

std::vector<LabelRange> labelRanges(const History& history)
{
	std::vector<LabelRange> ranges;
	for (std::size_t k = 0; k < history.runs.size(); ++k)
	{
		if (ranges.empty() || ranges.back().label != history.runs[k].label)
			ranges.push_back({history.runs[k].label, k, k});
		ranges.back().end = k + 1;
	}
	return ranges;
}

// The times of a stage, NaN where a run lacks it.
std::vector<double> timesOf(const History& history, const std::string& stage)
{
	std::vector<double> times;
	for (const HistoryRun& run : history.runs)
	{
		const auto found = std::ranges::find_if(run.stages, [&](const auto& s) { return s.first == stage; });
		times.push_back(found == run.stages.end() ? NAN : found->second);
	}
	return times;
}

struct HistoryPanel
{
	double top;
	double most; // time at the top of the plot
	std::size_t runs;

	double y(double ms) const { return top + kPlotHeight * (1.0 - ms / most); }
	double x(double run) const
	{
		return kPlotLeft + (kPlotRight - kPlotLeft) * (run + 0.5) / static_cast<double>(runs);
	}
};

// A round number not below a value: 1, 2 or 5 times a power of ten.
double roundedUp(double value)
{
	const double power = std::pow(10.0, std::floor(std::log10(value)));
	for (const double digit : {1.0, 2.0, 5.0})
		if (digit * power >= value)
			return digit * power;
	return 10.0 * power;
}

std::string panelFrame(const HistoryPanel& panel, const std::string& stage)
{
	std::string svg = svgText(kPlotLeft, panel.top - 8.0, "class=\"stage\"", stage);
	for (const double part : {0.0, 0.5, 1.0})
	{
		const double y = panel.y(part * panel.most);
		svg += fmt::format("<line class=\"grid\" x1=\"{}\" y1=\"{:.1f}\" x2=\"{}\" y2=\"{:.1f}\"/>\n", kPlotLeft, y,
		                   kPlotRight, y);
		svg += svgText(kPlotLeft - 8.0, y + 4.0, "text-anchor=\"end\"", fmt::format("{:g} ms", part * panel.most));
	}
	return svg;
}

std::string stepMarks(const HistoryPanel& panel, const std::vector<double>& times, const std::vector<std::size_t>& at)
{
	std::string svg;
	for (const Step& step : stepsOf(times))
	{
		const double x = panel.x(static_cast<double>(at[step.at]) - 0.5);
		svg += fmt::format("<line class=\"step\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>\n", x,
		                   panel.top - 4.0, x, panel.top + kPlotHeight);
		const bool is_right = x > kPlotRight - 130.0;
		svg += svgText(is_right ? x - 5.0 : x + 5.0, panel.top + 8.0,
		               is_right ? "class=\"change\" text-anchor=\"end\"" : "class=\"change\"",
		               fmt::format("{:+.1f} % (p = {:.3f})", 100.0 * (step.ratio - 1.0), step.probability));
	}
	return svg;
}

std::string panelOf(const History& history, const std::vector<LabelRange>& labels, const std::string& stage, double top)
{
	const std::vector<double> times = timesOf(history, stage);
	std::vector<double> known;
	std::vector<std::size_t> at; // the run of each
	for (std::size_t k = 0; k < times.size(); ++k)
		if (std::isfinite(times[k]))
		{
			known.push_back(times[k]);
			at.push_back(k);
		}
	const double largest = known.empty() ? 0.0 : *std::ranges::max_element(known);
	const HistoryPanel panel{top, largest > 0.0 ? roundedUp(largest) : 1.0, times.size()};
	std::string svg = panelFrame(panel, stage);
	for (const LabelRange& label : labels)
	{
		std::vector<double> of_label;
		for (std::size_t k = label.begin; k < label.end; ++k)
			if (std::isfinite(times[k]))
				of_label.push_back(times[k]);
		if (of_label.empty())
			continue;
		const auto [low, high] = std::ranges::minmax(of_label);
		const double left = panel.x(static_cast<double>(label.begin) - 0.4);
		const double width = panel.x(static_cast<double>(label.end) - 0.6) - left;
		svg += fmt::format("<rect class=\"noise\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n",
		                   left, panel.y(high), width, std::max(1.0, panel.y(low) - panel.y(high)));
		const double median = panel.y(medianOf(of_label));
		svg += fmt::format("<line class=\"median\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>\n", left,
		                   median, left + width, median);
	}
	for (std::size_t k = 0; k < known.size(); ++k)
		svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\"/>\n", panel.x(static_cast<double>(at[k])),
		                   panel.y(known[k]));
	return svg + stepMarks(panel, known, at);
}

// Labels stand aslant, and where there are many, only every so many.
std::string labelRow(const History& history, const std::vector<LabelRange>& labels, double top)
{
	constexpr double kLabelDistance = 22.0;
	const HistoryPanel panel{top, 1.0, history.runs.size()};
	std::string svg;
	double last = -kLabelDistance;
	for (const LabelRange& label : labels)
	{
		const double x = panel.x(0.5 * static_cast<double>(label.begin + label.end - 1));
		if (x - last < kLabelDistance)
			continue;
		last = x;
		const std::string text = label.label.size() <= 14 ? label.label : label.label.substr(0, 13) + "…";
		svg +=
		    svgText(x, top, fmt::format("text-anchor=\"end\" transform=\"rotate(-40 {:.1f} {:.1f})\"", x, top), text);
	}
	return svg;
}

} // namespace

std::string historySvg(const History& history)
{
	std::vector<std::string> stages;
	for (const HistoryRun& run : history.runs)
		for (const auto& [stage, ms] : run.stages)
			if (std::ranges::find(stages, stage) == stages.end())
				stages.push_back(stage);
	const double foot = kHeadHeight + kPanelHeight * static_cast<double>(stages.size());
	const std::vector<LabelRange> labels = labelRanges(history);
	std::string svg = fmt::format(
	    "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n"
	    "<style>text{{font:12px sans-serif;fill:#222}} .head{{font-size:16px}} .stage{{font-weight:bold}} "
	    ".grid{{stroke:#ddd}} .noise{{fill:#9ecae1;fill-opacity:.5}} .median{{stroke:#08519c;stroke-width:2}} "
	    "circle{{fill:#08519c}} .step{{stroke:#c00;stroke-dasharray:4 3}} .change{{fill:#c00}}</style>\n"
	    "<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
	    kPageWidth, foot + kFootHeight);
	svg += svgText(20.0, 24.0, "class=\"head\"", "Milliseconds a plane, by stage");
	svg += svgText(20.0, 42.0, "", history.subject);
	for (std::size_t k = 0; k < stages.size(); ++k)
		svg += panelOf(history, labels, stages[k], kHeadHeight + 20.0 + kPanelHeight * static_cast<double>(k));
	svg += labelRow(history, labels, foot + 4.0);
	svg +=
	    svgText(20.0, foot + kFootHeight - 30.0, "",
	            "A dot is the median of a run; a line the median of the runs of a label, and the area about it their "
	            "range.");
	svg += svgText(
	    20.0, foot + kFootHeight - 12.0, "",
	    fmt::format("Red: the time changed. Circular binary segmentation by the Mann-Whitney statistic; p by 999 "
	                "permutations, at most {:g}.",
	                kStepRisk));
	return svg + "</svg>\n";
}

} // namespace vp::app
