#pragma once

#include "base/messages.h"
#include "interact/bindings.h"
#include "interact/history.h"
#include "interact/view.h"
#include "viewer/dataset_info.h"
#include "viewer/file_jobs.h"
#include "viewer/loader.h"
#include "viewer/notice.h"
#include "viewer/playback.h"
#include "viewer/render_thread.h"
#include "viewer/spec_edits.h"
#include "viewer/user_files.h"
#include "viewer/watcher.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vp::app
{

// What of the window is open. None of it is the state's: it says nothing about the picture.
struct OpenParts
{
	bool panels = true;
	bool handles = true;
	bool magnifier = false;
	bool own = false; // the sheet that is chosen moves alone, not the whole probe
	bool plane_pane = false;
	bool profile = false;
	bool help = false;
	bool command_search = false;
	// What keys have said to the search since its last frame: ImGui sees a key only while it is down, and a quick one
	// may go up again between two frames.
	int search_steps = 0; // downwards
	bool search_enters = false;
	bool full_screen = false;
	bool contour = false;  // one follows the pointer over the sheets
	bool exposure = false; // in place of the film loop, all its frames in one picture
};

// A question that waits for its answer.
enum class Question
{
	none,
	open,
	save_state,
	save_picture,
	save_film,
	save_slice,
	save_trace,
	recover // what a window that ended unexpectedly has left
};

using ReadState = std::function<Result<view::ViewSpec>(const std::string& file)>;

// All of a viewer but its window: the state and its history, the data, the render thread. Panels and the hand read it
// and call it, on the window's thread.
class Document
{
public:
	// read_state: of a file that --save or the window has written.
	Document(view::ViewSpec state, std::shared_ptr<gpu::Device> device, std::function<void()> wake,
	         ReadState read_state);
	~Document();

	// --- The state. Each change is a step of the history; those with the same key, until endMerge(), are one.
	const view::ViewSpec& state() const { return history_.state(); }
	using Edit = std::function<void(view::ViewSpec&)>;
	void change(const std::string& label, const Edit& edit, const std::string& merge = {});
	void endMerge() { history_.endMerge(); }
	const interact::History<view::ViewSpec>& history() const { return history_; }

	probe::Probe probe() const; // as the state has it; without sheets before anything is loaded
	// As --surface has it; empty for planes. What is none is told.
	void setSurface(const std::string& text);
	void setProbe(const std::string& label, const probe::Probe& probe, const std::string& merge = {});
	std::size_t sheet() const { return sheet_; } // the one that keys and panels mean
	void chooseSheet(std::size_t sheet);
	void setCamera(const std::string& label, const render::Camera& camera, const std::string& merge = {});
	std::optional<interact::View> view() const; // what is seen: the last picture's

	void perform(interact::Action action);

	// --- Files. What fails is told by a notice, and leaves all as it was.
	// Loads them beside what is shown. One .json file is a state.
	void open(std::vector<std::string> inputs);
	void reload();
	const Loader& loader() const { return loader_; }
	void cancelLoading();
	void showTime(int step, const std::string& merge = {});
	const DatasetInfo::Array* shownArray() const; // the state's; null without arrays
	const std::optional<DatasetInfo>& facts() const { return facts_; }
	int timeStep() const; // the one of the input's times that the state means
	void saveState(const std::string& file);
	const std::string& stateFile() const { return state_file_; } // that it was last read from or saved to, or empty
	void savePicture(const std::string& file, std::uint32_t width, std::uint32_t height);
	void saveSlice(const std::string& file);
	void saveTrace(const std::string& file);
	void recover(bool wanted); // the answer to Question::recover

	Playback& playback() { return playback_; }
	const Playback& playback() const { return playback_; }

	// --- The picture.
	// Once a frame, and after input: hands on what has changed. size: of the part of the window that shows the scene.
	void update(PixelSize size);
	void noteInput(Moment when); // what follows answers it
	// From the next picture on, the chosen sheet in a pane of this size; none of 0 x 0.
	void setPane(PixelSize size);
	// From the next picture on, a contour of this value; sheet: of the cut.
	void pointContour(const std::optional<session::PointedValue>& pointed);
	const std::optional<session::PointedValue>& pointedContour() const { return pointed_contour_; }
	const std::shared_ptr<const PresentedFrame>& shown() const { return shown_; }
	FrameRequest frameRequest() const; // what the state is to look like, in the size that was last asked for
	bool isIdle() const;
	bool isShown() const; // what is shown is of the state as it is

	// --- The window.
	OpenParts parts;
	Question question = Question::none;
	Settings settings;
	bool watches = true; // for files to be written anew
	const std::vector<Notice>& notices() const { return notices_.all(); }
	void notify(std::string words, bool is_error = false) { notices_.add(std::move(words), is_error); }
	void notify(const Error& error) { notify(error.message, true); }
	void dismiss(const std::string& words) { notices_.dismiss(words); }
	// What was set stays to be recovered when the document goes: it ends by a fault.
	void keepState();
	bool wantsToQuit() const { return quits_; }
	void quit() { quits_ = true; }

private:
	void stateChanged();
	void load(view::ViewSpec next);
	void takeLoaded();
	void takePicture();
	void ask(PixelSize size);
	void takeWritten();
	void keepForRecovery();
	void watchFiles();

	// One group of actions each; false where it is none of theirs.
	bool performOnWindow(interact::Action action);
	bool performOnProbe(interact::Action action);
	bool performOnSheets(interact::Action action);
	bool performOnView(interact::Action action);
	bool performOnLook(interact::Action action);
	void setPreset(view::ProbeShape shape);
	void stepArray(int by);
	void stepTime(int by);

	interact::History<view::ViewSpec> history_;
	ReadState read_state_;
	std::size_t sheet_ = 0;
	std::optional<DatasetInfo> facts_;
	std::optional<view::ViewSpec> loading_; // the state that what is being loaded is for
	std::shared_ptr<const PresentedFrame> shown_;
	NoticeList notices_;
	bool quits_ = false;

	std::uint64_t version_ = 1; // of all that a picture depends on
	std::uint64_t asked_ = 0;   // the version that was asked for last
	PixelSize asked_size_{};
	std::optional<PaneWish> pane_;
	std::optional<session::PointedValue> pointed_contour_;
	std::optional<Moment> input_; // the oldest that was not asked for yet
	bool takes_camera_ = true;    // the state's camera is to become the next picture's

	std::string state_file_;
	std::string recovery_file_;
	std::uint64_t recovery_version_ = 1; // that the recovery file holds
	Moment recovery_time_{};
	bool keeps_state_ = false; // when it ends
	Watcher watcher_;

	// What comes back from the render thread.
	struct Mail;
	std::shared_ptr<Mail> mail_;
	MessageListener messages_;

	Loader loader_;
	FileJobs jobs_;
	RenderThread render_thread_;
	Playback playback_;
};

} // namespace vp::app
