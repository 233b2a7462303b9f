// Scenes, cameras and answers as bytes between two programs of one build. For this folder's own use.
#pragma once

#include "compare/method.hpp"

#include <span>
#include <stdexcept>

namespace sightline::comparison {

class Packer {
 public:
  template <class T>
  void put(const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <class T>
  void put(const std::vector<T>& list) {
    put<std::uint64_t>(list.size());
    bytes.append(reinterpret_cast<const char*>(list.data()), list.size() * sizeof(T));
  }
  std::string bytes;
};

/// Reads back what a packer was given. Throws std::runtime_error where there is less: a program that has gone wrong may
/// have written anything.
class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}
  template <class T>
  void get(T& value) {
    copy(&value, sizeof value);
  }
  template <class T>
  void get(std::vector<T>& list) {
    std::uint64_t size = 0;
    get(size);
    if (size > bytes_.size() / sizeof(T)) throw std::runtime_error("half an answer");
    list.resize(size);
    copy(list.data(), size * sizeof(T));
  }
  template <class T>
  T get() {
    T value;
    get(value);
    return value;
  }

 private:
  void copy(void* to, std::size_t count);
  std::string_view bytes_;
};

/// Of an answer that is a drawing.
std::string packed(const Measured& measured);
/// Throws std::runtime_error for bytes that are none.
Measured unpacked(std::string_view bytes);

/// A scene as it was read, before it was made exact.
std::string packed(const Scene& scene);
Scene unpacked_scene(std::string_view bytes);

/// What the parent asks for, and messages through a pipe: the length, then the bytes.
struct Request {
  Camera camera;
  double seconds;  // of processor time
};
bool send(int pipe, std::string_view message);
bool receive(int pipe, std::string& message);

}  // namespace sightline::comparison
