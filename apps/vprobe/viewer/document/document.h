#pragma once

#include "base/messages.h"
#include "interact/bindings.h"
#include "interact/history.h"
#include "interact/view.h"
#include "viewer/cutting/dataset_info.h"
#include "viewer/cutting/loader.h"
#include "viewer/cutting/render_thread.h"
#include "viewer/cutting/spec_edits.h"
#include "viewer/cutting/watcher.h"
#include "viewer/document/file_jobs.h"
#include "viewer/document/notice.h"
#include "viewer/document/playback.h"
#include "viewer/document/read_state.h"
#include "viewer/document/user_files.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vp::app
{

// Says which parts of the window are open. It is not part of the state, since it does not change the picture.
struct OpenParts
{
	bool panels = true;
	bool handles = true;
	bool magnifier = false;
	bool own = false; // the chosen sheet moves alone, not the whole probe
	bool plane_pane = false;
	bool profile = false;
	bool help = false;
	bool command_search = false;
	// Keys pressed for the search since its last frame. ImGui sees a key only while it is down, and a quick one may be
	// up again between two frames.
	int search_steps = 0; // downwards
	bool search_enters = false;
	// Numbers of menus, from 0 at the left.
	std::optional<int> open_menu;  // that was open in the last frame
	std::optional<int> opens_menu; // that opens in the next frame; past the last one is the first
	bool panel_keys = false;       // keys move through the panel, and do nothing else
	bool opens_color_map = false;  // the next frame unfolds the color map in the panel, for the keys
	std::size_t opacity_point = 0; // the chosen point of the color map's opacity
	bool full_screen = false;
	bool contour = false;  // a contour follows the pointer over the sheets
	bool exposure = false; // show all frames of the film loop in one picture
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
	save_color_map,
	save_trace,
	recover // offer the state that a window left when it ended unexpectedly
};

// The hints for the first steps, in their order (panels/hints.cpp): what the user does for them.
constexpr std::size_t kHintOfSheet = 0;
constexpr std::size_t kHintOfHandles = 1;
constexpr std::size_t kHintOfCamera = 2;
constexpr std::size_t kHintOfSweep = 3;
constexpr std::size_t kHintOfSearch = 4;
constexpr std::size_t kHints = 5;

// Holds everything of a viewer except its window: the state and its history, the data, the render thread. The panels
// and the pointer use it on the window's thread.
class Document
{
public:
	// history: the history of the previous document, whose device was lost, or a first state. read_state: reads a state
	// file that --save or the window has written. times: where the time goes; it outlives the document.
	Document(interact::History<view::ViewSpec> history, std::shared_ptr<gpu::Device> device, std::function<void()> wake,
	         ReadState read_state, WindowTimes& times);
	~Document();

	// --- The state. Each change is a step of the history. Changes with the same merge key form one step until
	// endMerge().
	const view::ViewSpec& state() const { return history_.state(); }
	using Edit = std::function<void(view::ViewSpec&)>;
	void change(const std::string& label, const Edit& edit, const std::string& merge = {});
	void endMerge() { history_.endMerge(); }
	const interact::History<view::ViewSpec>& history() const { return history_; }

	probe::Probe probe() const; // the probe of the state; it has no sheets before data are loaded
	// Takes a surface as --surface does, or an empty text for planes. Reports a text that is not a surface.
	void setSurface(const std::string& text);
	void setProbe(const std::string& label, const probe::Probe& probe, const std::string& merge = {});
	std::size_t sheet() const { return sheet_; } // the chosen sheet, which keys and panels change
	void chooseSheet(std::size_t sheet);
	void setCamera(const std::string& label, const render::Camera& camera, const std::string& merge = {});
	std::optional<interact::View> view() const; // the view of the last picture

	void perform(interact::Action action);
	// Sets a setting by its key (view/settings.h) to a value as on the command line. Those that open data or a device
	// cannot be set, except the time.
	Status set(std::string_view key, const std::string& value);
	// Goes on to the next hint for the first steps, if the user has done what this one shows.
	void learned(std::size_t hint);

	// --- Files. A failure shows a notice and changes nothing.
	// Loads files while the window goes on showing the old data. A single .json file is a state.
	void open(std::vector<std::string> inputs);
	void reload();
	const Loader& loader() const { return loader_; }
	void cancelLoading();
	void showTime(int step, const std::string& merge = {});
	const DatasetInfo::Array* shownArray() const; // the array that the state shows; null without arrays
	const std::optional<DatasetInfo>& facts() const { return facts_; }
	// Returns the color map as --colormap names it, also where the state leaves it to the file. Labels have none.
	std::string colorMapName() const;
	int timeStep() const; // index of the state's time among the times of the input
	void saveState(const std::string& file);
	const std::string& stateFile() const
	{
		return state_file_;
	} // the file that the state was last read from or saved to, or empty
	void savePicture(const std::string& file, std::uint32_t width, std::uint32_t height);
	void saveSlice(const std::string& file);
	void saveTrace(const std::string& file);
	void saveColorMap(const std::string& file); // as --colormap reads it
	void recover(bool wanted);                  // answers Question::recover

	Playback& playback() { return playback_; }
	const Playback& playback() const { return playback_; }

	const WindowTimes& times() const { return times_; }

	// --- The picture.
	// Call this once a frame and after input: it sends changes to the render thread. size: of the part of the window
	// that shows the scene.
	void update(PixelSize size);
	void noteInput(Moment when); // the next request answers this input
	// From the next picture on, shows the chosen sheet in a pane of this size. 0 x 0 shows no pane.
	void setPane(PixelSize size);
	// From the next picture on, draws a contour of this value. The sheet is an index of the cut.
	void pointContour(const std::optional<session::PointedValue>& pointed);
	const std::optional<session::PointedValue>& pointedContour() const { return pointed_contour_; }
	const std::shared_ptr<const PresentedFrame>& shown() const { return shown_; }
	PictureRequest pictureRequest() const; // a request for the state as it is, in the size that was last asked for
	bool isIdle() const;
	bool isDrawing() const { return render_thread_.isBusy(); } // a picture is under way
	bool isShown() const;                                      // the picture shows the state as it is

	// --- The window.
	OpenParts parts;
	Question question = Question::none;
	Settings settings;
	bool watches = true; // looks for files that are written anew
	const std::vector<Notice>& notices() const { return notices_.all(); }
	void notify(std::string words, bool is_error = false) { notices_.add(std::move(words), is_error); }
	void notify(const Error& error) { notify(error.message, true); }
	void dismiss(const std::string& words) { notices_.dismiss(words); }
	// Keeps the state for recovery when the document ends, because it ends by a fault.
	void keepState();
	// Returns the history for the next document. Its last step is the state that is being loaded.
	interact::History<view::ViewSpec> historyToKeep() const;
	const std::optional<Error>& lostDevice() const { return lost_device_; } // the device draws no more
	bool wantsToQuit() const { return quits_ > 0; }
	bool wantsToQuitAtOnce() const { return quits_ > 1; } // the user asked again while files were being written
	void quit();
	std::vector<std::string> filesUnderWay() const;                        // files that are still to be written
	const std::vector<std::string>& failures() const { return failures_; } // failed writes since quit()

private:
	void stateChanged();
	void fitAgain();
	void load(view::ViewSpec next);
	void takeLoaded();
	void takePicture();
	void ask(PixelSize size);
	void takeWritten();
	void keepForRecovery();
	void watchFiles();

	// Each function handles one group of actions, and returns false for any other action.
	void undo();
	void redo();
	bool performOnWindow(interact::Action action);
	bool performOnProbe(interact::Action action);
	bool performOnSheets(interact::Action action);
	bool performOnView(interact::Action action);
	bool moveCamera(interact::Action action);
	bool performOnLook(interact::Action action);
	void setPreset(view::ProbeShape shape);
	void stepArray(int by);
	void stepTime(int by);

	interact::History<view::ViewSpec> history_;
	ReadState read_state_;
	WindowTimes& times_;
	std::size_t sheet_ = 0;
	std::optional<DatasetInfo> facts_;
	std::optional<view::ViewSpec> loading_; // the state for the data that are being loaded
	bool loads_own_data_ = false;           // loads the data of state(), which may change meanwhile
	std::shared_ptr<const PresentedFrame> shown_;
	NoticeList notices_;
	std::optional<Error> lost_device_;
	int quits_ = 0; // how often the user asked to quit
	Moment first_quit_{};
	std::vector<std::string> failures_;

	std::uint64_t version_ = 1; // counts changes of everything that a picture depends on
	std::uint64_t asked_ = 0;   // the version of the last request
	PixelSize asked_size_{};
	std::optional<PaneWish> pane_;
	std::optional<session::PointedValue> pointed_contour_;
	std::optional<Moment> input_; // time of the oldest input that no request has answered yet
	bool takes_camera_ = true;    // the state takes over the camera of the next picture
	// The camera of the state, where it was fitted to the window and not moved since: it is fitted again to a window of
	// another size.
	std::optional<render::CameraChoice> fitted_camera_;
	PixelSize fitted_size_{};

	std::string state_file_;
	std::string recovery_file_;
	std::uint64_t recovery_version_ = 1; // the version that the recovery file holds
	Moment recovery_time_{};
	bool keeps_state_ = false; // keep the recovery file at the end
	Watcher watcher_;

	// Messages from the render thread.
	struct Mail;
	std::shared_ptr<Mail> mail_;
	MessageListener messages_;

	Loader loader_;
	FileJobs jobs_;
	RenderThread render_thread_;
	Playback playback_;
};

} // namespace vp::app
