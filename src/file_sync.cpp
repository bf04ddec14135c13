// What R cannot do with files: tell which are regular, force them to the disk and say why that failed.

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
// A new name lasts once its folder is on the disk; not every file system can do that.
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

// Bytes of a regular file; NA of anything else, such as a folder, a device or a pipe.
[[cpp11::register]] double file_size(cpp11::strings path) {
  struct stat about;
  if (stat(native(path).c_str(), &about) != 0 || (about.st_mode & S_IFMT) != S_IFREG)
    return NA_REAL;
  return static_cast<double>(about.st_size);
}

// Forces a file that was just written to the disk. The writer may have lost bytes to a full disk or
// a limit of file size without a word (R's devices and connections do), so 64 KiB more are written
// at its end and taken away: where these find no place, neither may those before them.
// Returns "" or the system's reason.
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

// Puts a file or folder in another's place at once. Returns "" or the system's reason.
[[cpp11::register]] std::string file_replace(cpp11::strings from, cpp11::strings to) {
  const std::string place = native(to);
#ifdef _WIN32
  // rename() here replaces nothing
  std::remove(place.c_str());
#endif
  if (std::rename(native(from).c_str(), place.c_str()) != 0) return reason();
  sync_folder(place);
  return "";
}
