// For the program that measures what exact stages cost.
#pragma once

namespace sightline::comparison {

/// While true the predicates of plain/predicates.cpp are exact, by integers of any length: scenes are read that way.
extern bool reads_scene;

}  // namespace sightline::comparison
