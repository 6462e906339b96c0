// Videos: ffmpeg gets the pixels through a pipe and writes into memory, so that neither a file of
// its own nor a part of one is left when it ends early.
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "formats.h"
#include "spiraling_edge/base/atomic_file.h"
#include "spiraling_edge/base/files.h"

namespace se::view {

namespace {

constexpr const char* kFfmpeg = "ffmpeg";
constexpr const char* kNeeds = "needs ffmpeg (apt-get install ffmpeg); .gif and .html need nothing";

bool isInPath(const std::string& program) {
    const char* path = std::getenv("PATH");
    std::string folders = path != nullptr ? path : "";
    for (std::size_t at = 0; at < folders.size();) {
        const std::size_t end = std::min(folders.find(':', at), folders.size());
        if (::access((folders.substr(at, end - at) + "/" + program).c_str(), X_OK) == 0)
            return true;
        at = end + 1;
    }
    return false;
}

/// A file in memory that a child process can open by its path.
class MemoryFile {
  public:
    MemoryFile() : descriptor_(::memfd_create("spiraling-edge", 0)) {}
    ~MemoryFile() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    int descriptor() const { return descriptor_; }
    std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }
    std::string content() const {
        std::string bytes;
        std::string part(std::size_t{1} << 16U, '\0');
        for (off_t at = 0;;) {
            const ssize_t count = ::pread(descriptor_, part.data(), part.size(), at);
            if (count <= 0) return bytes;
            bytes.append(part.data(), static_cast<std::size_t>(count));
            at += count;
        }
    }

  private:
    int descriptor_;
};

std::string lastLine(std::string text) {
    while (text.ends_with('\n')) text.pop_back();
    const std::size_t line = text.rfind('\n');
    return line == std::string::npos ? text : text.substr(line + 1);
}

/// The process of ffmpeg.
class VideoProcess {
  public:
    VideoProcess() : before_(std::signal(SIGPIPE, SIG_IGN)) {}
    ~VideoProcess() {
        closeInput();
        if (process_ > 0) {
            ::kill(process_, SIGKILL);
            ::waitpid(process_, nullptr, 0);
        }
        std::signal(SIGPIPE, before_);
    }
    VideoProcess(const VideoProcess&) = delete;
    VideoProcess& operator=(const VideoProcess&) = delete;

    /// Starts it with these arguments; its standard input is write().
    Status start(std::vector<std::string> words) {
        int ends[2];
        if (::pipe2(ends, O_CLOEXEC) != 0) return Error{systemReason()};
        input_ = ends[1];
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
        posix_spawn_file_actions_adddup2(&actions, errors_.descriptor(), STDOUT_FILENO);
        posix_spawn_file_actions_adddup2(&actions, errors_.descriptor(), STDERR_FILENO);
        std::vector<char*> pointers;
        pointers.reserve(words.size() + 1);
        for (std::string& word : words) pointers.push_back(word.data());
        pointers.push_back(nullptr);
        const int problem =
            ::posix_spawnp(&process_, kFfmpeg, &actions, nullptr, pointers.data(), environ);
        posix_spawn_file_actions_destroy(&actions);
        ::close(ends[0]);
        if (problem == 0) return success();
        process_ = 0;
        return Error{kNeeds};
    }

    Status write(const std::vector<std::uint8_t>& bytes) {
        for (std::size_t at = 0; at < bytes.size();) {
            const ssize_t count = ::write(input_, bytes.data() + at, bytes.size() - at);
            if (count < 0 && errno == EINTR) continue;
            if (count <= 0) return failure();
            at += static_cast<std::size_t>(count);
        }
        return success();
    }

    /// Waits for its end.
    Status finish() {
        closeInput();
        int state = 0;
        const pid_t process = std::exchange(process_, 0);
        if (process <= 0) return Error{"ffmpeg does not run"};
        while (::waitpid(process, &state, 0) < 0 && errno == EINTR) {
        }
        if (WIFEXITED(state) && WEXITSTATUS(state) == 0) return success();
        const std::string said = lastLine(errors_.content());
        return Error{"ffmpeg ended early" + (said.empty() ? "" : ": " + said)};
    }

  private:
    void closeInput() {
        if (input_ >= 0) ::close(std::exchange(input_, -1));
    }
    Status failure() {
        const Status ended = finish();
        return ended ? Error{"ffmpeg takes no more frames"} : ended.error();
    }

    void (*before_)(int);
    MemoryFile errors_;
    pid_t process_ = 0;
    int input_ = -1;
};

class Mp4Writer : public FrameWriter {
  public:
    explicit Mp4Writer(const ExportTarget& target) : target_(target) {}

    Status start() {
        const std::string size = fmt::format("{}x{}", target_.size.x, target_.size.y);
        return named(process_.start(
            {kFfmpeg, "-nostdin", "-loglevel", "error", "-y", "-f", "rawvideo", "-pix_fmt", "rgba",
             "-s", size, "-r", fmt::format("{}", target_.perSecond), "-i", "pipe:0",
             // Rows come from the bottom up, and the format needs even sizes.
             "-vf", "vflip,pad=ceil(iw/2)*2:ceil(ih/2)*2", "-c:v", "libx264", "-crf", "18",
             "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-f", "mp4", video_.path()}));
    }
    Status add(const ExportFrame& frame) override {
        return named(process_.write(frame.pixels.rgba));
    }
    Status finish() override {
        if (const Status ended = named(process_.finish()); !ended) return ended;
        return writeFileAtomically(target_.path, video_.content());
    }

  private:
    Status named(const Status& status) const {
        if (status) return status;
        return Error{target_.path.string() + ": " + status.error().message};
    }

    ExportTarget target_;
    MemoryFile video_;
    VideoProcess process_;
};

}  // namespace

Status mp4Possible() {
    if (isInPath(kFfmpeg)) return success();
    return Error{kNeeds};
}

Result<std::unique_ptr<FrameWriter>> openMp4Writer(const ExportTarget& target) {
    auto writer = std::make_unique<Mp4Writer>(target);
    if (const Status started = writer->start(); !started) return started.error();
    return std::unique_ptr<FrameWriter>(std::move(writer));
}

}  // namespace se::view
