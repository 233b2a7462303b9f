#include "app/messages.hpp"

#include <unistd.h>

#include <cstdio>

namespace sightline::app {

namespace {

std::string one_line(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  return text;
}

void put_line(const std::string& line) { std::fputs((one_line(line) + "\n").c_str(), stderr); }

}  // namespace

void complain(const std::string& text) { put_line("sightline: " + text); }

void tell(const std::string& text, bool quiet) {
  if (!quiet) put_line(text);
}

Progress::Progress(std::string what, std::size_t total, bool quiet)
    : what_(std::move(what)), total_(total), shown_(!quiet && isatty(STDERR_FILENO)) {
  if (shown_) draw(0);
}

Progress::~Progress() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void Progress::step() {
  const std::size_t done = ++done_;
  if (!shown_) return;
  const std::unique_lock lock(mutex_, std::try_to_lock);
  const auto now = std::chrono::steady_clock::now();
  if (!lock || now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  draw(done);
}

void Progress::draw(std::size_t done) {
  if (total_ == 0) {
    std::fprintf(stderr, "\r%s %zu", what_.c_str(), done);
    return;
  }
  constexpr std::size_t width = 40;
  const std::size_t filled = width * done / total_;
  const std::string bar = std::string(filled, '#') + std::string(width - filled, '.');
  std::fprintf(stderr, "\r%s [%s] %zu/%zu", what_.c_str(), bar.c_str(), done, total_);
}

}  // namespace sightline::app
