// The methods that can be set beside the exact map, and how one is asked for by name.
#pragma once

#include "compare/answer.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sightline::comparison {

/// One view by one method.
struct Measured {
  double seconds = 0;  // processor time from the camera to the result in memory
  Answer answer;
  std::string why;  // it failed; empty when it did not
};

/// A way to find out what a camera sees. Made for one scene, which must outlive it; then asked view after view, on one
/// thread.
class Method {
 public:
  Method() = default;
  virtual ~Method() = default;
  Method(const Method&) = delete;
  Method& operator=(const Method&) = delete;

  /// `usual`: seconds that the exact engine takes; what may take for ever is ended at a multiple of it.
  virtual Measured view(const Camera& camera, double usual) = 0;
  /// Processor time that another process spent on preparing the scene.
  virtual double spent_elsewhere() const { return 0; }
};

/// A method that is timed here. It looks once for the answer, which also warms buffers and caches, then three times
/// more for the median; what takes longer than a fifth of a second is timed the first time.
class TimedMethod : public Method {
 public:
  /// What it throws is why it failed.
  Measured view(const Camera& camera, double usual) final;

 protected:
  /// Makes what a view needs and other views may need again; not timed.
  virtual void approach(const Camera&) {}
  /// Finds out what the camera sees and keeps it: this is what is timed.
  virtual void look(const Camera& camera) = 0;
  /// What was seen last.
  virtual void tell(Answer& answer) = 0;
};

/// The calling thread's own processor time: on a shared machine the wall clock measures the neighbours as well.
double thread_seconds();

/// Prepares a method for a scene. What it throws is why there is none.
using MakeMethod = std::function<std::unique_ptr<Method>(const Scene&)>;

/// Methods of one kind. A kind of several settings is named `kind:SETTING`, and reads its setting itself.
struct Kind {
  std::string name;
  std::string form;  // of the setting, as a user is told it: "N"; empty for a kind without one
  /// The setting is empty where the name has none. Throws std::invalid_argument with what it wants instead: "a number
  /// of pixels from 1 to 16384".
  MakeMethod (*parse)(const std::string& setting);
};
const std::vector<Kind>& kinds();
/// `front-to-back, .., ids:N`: every kind with the form of its setting.
std::string known_methods();

/// A kind with its setting.
struct MethodName {
  std::string text;
  const Kind* kind;
  MakeMethod make;
};
/// Names with commas between them. Throws std::invalid_argument, in one line, for a name that there is not, or that
/// stands there twice.
std::vector<MethodName> parse_methods(const std::string& list);

/// The whole of a setting, or a part of it, as a number in decimal digits; nothing where it is no such number or not
/// within the limits.
std::optional<unsigned> setting_number(std::string_view text, unsigned least, unsigned most);

// A kind is a file with such a function, or with a `parse` of its own, and a line in methods.cpp.
std::unique_ptr<Method> make_front_to_back(const Scene& scene);
std::unique_ptr<Method> make_cells(const Scene& scene);
std::unique_ptr<Method> make_hybrid(const Scene& scene);
std::unique_ptr<Method> make_double(const Scene& scene);
std::unique_ptr<Method> make_ids(const Scene& scene, unsigned size);
std::unique_ptr<Method> make_rays(const Scene& scene, unsigned size);
MakeMethod parse_field(const std::string& setting);
MakeMethod parse_bitfield_method(const std::string& setting);
MakeMethod parse_exact_bitfield_method(const std::string& setting);

}  // namespace sightline::comparison
