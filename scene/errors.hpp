// Bad input, in one line.
#pragma once

#include <stdexcept>
#include <string>

namespace sightline {

/// Bad input: what() is one line "FILE:LINE: item: what is wrong" (exit code 3). LINE is left out where there is none.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A polygon soup that is no scene: what() names the vertex or polygon by its index.
class SceneError : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace sightline
