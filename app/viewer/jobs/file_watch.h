/// Watch over a file that another program may write again.
#pragma once

#include <chrono>
#include <filesystem>

namespace se::view {

class FileWatch {
  public:
    /// Watches a file, as it is now.
    void begin(const std::filesystem::path& path) {
        path_ = path;
        written_ = writeTime();
        looked_ = Clock::now();
    }
    const std::filesystem::path& path() const { return path_; }
    /// True if the file was written since begin(). Looks at most twice a second.
    bool hasChanged() {
        const Clock::time_point now = Clock::now();
        if (now - looked_ < kBetweenLooks) return false;
        looked_ = now;
        return writeTime() != written_;
    }

  private:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::milliseconds kBetweenLooks{500};

    std::filesystem::file_time_type writeTime() const {
        std::error_code error;
        const auto time = std::filesystem::last_write_time(path_, error);
        return error ? std::filesystem::file_time_type{} : time;
    }

    std::filesystem::path path_;
    std::filesystem::file_time_type written_{};
    Clock::time_point looked_;
};

}  // namespace se::view
