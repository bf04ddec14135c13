// File operations that R lacks: test for a regular file, force data to disk, and report the reason
// of a failure.

#include <fcntl.h>
#include <sys/stat.h>

#include <cerrno>
#include <cpp11.hpp>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>
#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace {

#ifdef _WIN32
int open_file(const char* path) { return _open(path, _O_RDWR | _O_BINARY); }
int sync_file(int file) { return _commit(file); }
int shorten(int file, long long size) { return _chsize_s(file, size); }
long long to_end(int file) { return _lseeki64(file, 0, SEEK_END); }
long write_bytes(int file, const char* bytes, unsigned count) { return _write(file, bytes, count); }
int close_file(int file) { return _close(file); }
void sync_folder(const std::string&) {}
#else
int open_file(const char* path) { return open(path, O_RDWR | O_CLOEXEC); }
int sync_file(int file) { return fsync(file); }
int shorten(int file, long long size) { return ftruncate(file, size); }
long long to_end(int file) { return lseek(file, 0, SEEK_END); }
long write_bytes(int file, const char* bytes, unsigned count) { return write(file, bytes, count); }
int close_file(int file) { return close(file); }
// A new name is permanent only after its folder is written to disk. Some file systems do not
// support this, so errors are ignored.
void sync_folder(const std::string& path) {
  const auto slash = path.find_last_of('/');
  const std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
  const int opened = open(folder.c_str(), O_RDONLY | O_CLOEXEC);
  if (opened < 0) return;
  fsync(opened);
  close(opened);
}
#endif

std::string reason() { return std::strerror(errno); }

std::string native(cpp11::strings path) {
  return R_ExpandFileName(Rf_translateChar(STRING_ELT(path, 0)));
}

}  // namespace

// Returns the size in bytes of a regular file; NA for a folder, device, pipe or missing file.
[[cpp11::register]] double file_size(cpp11::strings path) {
  struct stat about;
  if (stat(native(path).c_str(), &about) != 0 || (about.st_mode & S_IFMT) != S_IFREG)
    return NA_REAL;
  return static_cast<double>(about.st_size);
}

// Forces a file that was just written to disk. Returns "" or the system's reason of failure.
// The writer may have lost bytes without an error, because of a full disk or a file size limit (R's
// devices and connections do). Therefore 64 KiB are appended and removed again: if they do not fit,
// earlier bytes may be missing.
[[cpp11::register]] std::string file_sync(cpp11::strings path) {
  const int file = open_file(native(path).c_str());
  if (file < 0) return reason();
  std::string failed;
  const auto size = to_end(file);
  const std::vector<char> more(65536);
  size_t done = 0;
  while (failed.empty() && done < more.size()) {
    const auto count = static_cast<unsigned>(more.size() - done);
    const long written = write_bytes(file, more.data() + done, count);
    if (written > 0) {
      done += static_cast<size_t>(written);
    } else if (errno != EINTR) {
      failed = reason();
    }
  }
  if (failed.empty() && sync_file(file) != 0) failed = reason();
  if (shorten(file, size) != 0 && failed.empty()) failed = reason();
  if (failed.empty() && sync_file(file) != 0) failed = reason();
  if (close_file(file) != 0 && failed.empty()) failed = reason();
  return failed;
}

// Renames `from`, a file or folder, to `to`, which it replaces; atomic except on Windows. Returns
// "" or the system's reason of failure.
[[cpp11::register]] std::string file_replace(cpp11::strings from, cpp11::strings to) {
  const std::string place = native(to);
#ifdef _WIN32
  // rename() does not replace existing files on Windows.
  std::remove(place.c_str());
#endif
  if (std::rename(native(from).c_str(), place.c_str()) != 0) return reason();
  sync_folder(place);
  return "";
}
